// The table of rules: a row for each key of preset format 1, in the order of presets/README.md.
#include "core/scene/rules.h"
#include "core/scene/scene.h"

namespace airlight {
namespace {

// Ranges for which the format says only "> 0" or ">= 0". They cover any sky and leave the shaders' 32-bit arithmetic
// room for squares and ratios. Planet and air: a metre to fourteen times the Sun.
constexpr Range kSize{.minimum = 1e-3, .maximum = kFarthest};
// Within the air: from a millimetre.
constexpr Range kLength{.minimum = 1e-6, .maximum = kFarthest};
constexpr Range kAltitude = kLayerAltitude;
constexpr Range kCoefficient{.minimum = 0.0, .maximum = 1e5};  // a mean free path of a centimetre
constexpr Range kFactor{.minimum = 0.0, .maximum = 1e6};
constexpr Range kIrradiance{.minimum = 0.0, .maximum = 1e9};
constexpr Range kTerrainWidth{.minimum = 1e-3, .maximum = 2000.0};
constexpr Range kTerrainHeight{.minimum = 1e-3, .maximum = 100.0};
constexpr Range kMapHeight{.minimum = -100.0, .maximum = 100.0};
constexpr Range kWind{.minimum = 0.0, .maximum = 20.0};
constexpr Range kSphereDistance{.minimum = 1e-3, .maximum = 1e7};
constexpr Range kSphereRadius{.minimum = 1e-4, .maximum = 1e6};
constexpr Range kCloudAltitude{.minimum = 0.0, .maximum = 100.0};
constexpr Range kLayerDepth{.minimum = 0.0, .maximum = 1000.0};
constexpr Range kLayerWater{.minimum = 0.0, .maximum = 10000.0};
constexpr Range kMetresPerUnit{.minimum = 1e-6, .maximum = 1e6};
constexpr Range kCloudCell{.minimum = 0.1, .maximum = 50.0};
constexpr Range kCloudPeriod{.minimum = 1.0, .maximum = 200.0};
constexpr Range kCloudDetail{.minimum = 5.0, .maximum = 1000.0};
constexpr Range kCloudPlace{.minimum = -1000.0, .maximum = 1000.0};
constexpr Range kCloudWind{.minimum = -200.0, .maximum = 200.0};
constexpr Range kShear{.minimum = 0.0, .maximum = 50.0};
constexpr Range kWater{.minimum = 0.0, .maximum = 5.0};
constexpr Range kDropRadius{.minimum = 1.0, .maximum = 40.0};
constexpr Range kCrystalRadius{.minimum = 1.0, .maximum = 200.0};
constexpr Range kUnit{.minimum = 0.0, .maximum = 1.0};
constexpr Range kPhaseAngle{.minimum = 0.0, .maximum = 180.0};
constexpr Range kPhaseValue{.minimum = 0.0, .maximum = 1e9};
constexpr Range kRightAngle{.minimum = -90.0, .maximum = 90.0};
constexpr Range kAnyAngle{.minimum = -1e6, .maximum = 1e6};
constexpr Range kHalfTurns{.minimum = -180.0, .maximum = 180.0};
constexpr Range kMoonDistance{.minimum = 1e4, .maximum = 1e7};
constexpr Range kNightFactor{.minimum = 0.0, .maximum = 1e4};
constexpr Range kMagnitude{.minimum = -2.0, .maximum = 6.5};
constexpr Range kJulianDate{.minimum = 2305447.5, .maximum = 2597641.5};  // the years 1600 to 2400
constexpr Range kImageSide{.minimum = 1.0, .maximum = 65536.0};
// 1e-4 degrees at irradiance 1e9 is a radiance of 1e20, far inside a 32-bit float.
constexpr Range kDiscRadius{.minimum = 1e-4, .maximum = 10.0};

constexpr std::array<std::string_view, 3> kScaled = {"exponential", "lorentzian", "height-fog"};
constexpr std::array<std::string_view, 2> kCentered = {"tent", "lorentzian"};
constexpr std::array<std::string_view, 1> kConstant = {"constant"};
constexpr std::array<std::string_view, 1> kLayered = {"layers"};
constexpr std::array<std::string_view, 1> kFog = {"height-fog"};
constexpr std::array<std::string_view, 1> kMolecules = {"rayleigh"};
constexpr std::array<std::string_view, 1> kTabled = {"table"};
constexpr std::array<std::string_view, 1> kDrops = {"drops"};
constexpr std::array<std::string_view, 1> kCloudPeak = {"henyey-greenstein"};
constexpr std::array<std::string_view, 1> kCumulus = {"cumulus"};
constexpr std::array<std::string_view, 1> kStratocumulus = {"stratocumulus"};
constexpr std::array<std::string_view, 1> kCirrus = {"cirrus"};
constexpr std::array<std::string_view, 3> kFields = {"cumulus", "stratocumulus", "cirrus"};
constexpr std::array<std::string_view, 1> kVolume = {"volume"};
constexpr std::array<std::string_view, 1> kCloudLayers = {"layer"};
constexpr std::array<std::string_view, 4> kPlacedClouds = {"cumulus", "stratocumulus", "cirrus", "volume"};
constexpr std::array<std::string_view, 1> kPerspective = {"perspective"};
constexpr std::array<std::string_view, 1> kFisheye = {"fisheye"};
constexpr std::array<std::string_view, 3> kMaps = {"equirectangular", "cube", "octahedral"};
constexpr std::array<std::string_view, 3> kOwnAlbedo = {"matte", "mirror", "translucent"};
constexpr std::array<std::string_view, 1> kTranslucent = {"translucent"};
constexpr std::array<std::string_view, 1> kCube = {"cube"};

// A row of the table; `default_text` "": none. `pointer`: the member of the scene that holds the value.
template <auto pointer = nullptr>
constexpr Rule row(RuleType type, std::string_view key, Range range, std::string_view unit,
                   std::string_view default_text, std::string_view meaning) {
  return {.key = key,
          .type = type,
          .range = range,
          .unit = unit,
          .default_text = default_text,
          .meaning = meaning,
          .member = member<pointer>()};
}

template <auto pointer = nullptr>
constexpr Rule number(std::string_view key, Range range, std::string_view unit, std::string_view default_text,
                      std::string_view meaning) {
  return row<pointer>(RuleType::number, key, range, unit, default_text, meaning);
}

template <auto pointer = nullptr>
constexpr Rule choice(std::string_view key, std::span<const std::string_view> choices, std::string_view default_text,
                      std::string_view meaning) {
  return {.key = key,
          .type = RuleType::choice,
          .default_text = default_text,
          .choices = choices,
          .meaning = meaning,
          .member = member<pointer>()};
}

template <auto pointer = nullptr>
constexpr Rule plain(RuleType type, std::string_view key, std::string_view meaning) {
  return {.key = key, .type = type, .meaning = meaning, .member = member<pointer>()};
}

constexpr Rule needed(Rule rule) {
  rule.required = true;
  return rule;
}

constexpr Rule quiet(Rule rule) {
  rule.quiet = true;
  return rule;
}

constexpr Rule only_for(std::span<const std::string_view> choices, Rule rule) {
  rule.only_for = choices;
  return rule;
}

constexpr Rule hinted(std::string_view hint, Rule rule) {
  rule.hint = hint;
  return rule;
}

constexpr auto kRules = std::to_array<Rule>({
    needed(plain(RuleType::version, "airlight", "the format's version, 1")),
    plain(RuleType::text, "$schema", "for editors: where the JSON Schema is; not read"),
    plain<&Scene::name>(RuleType::text, "name", "for people; written into the EXR"),
    plain<&Scene::description>(RuleType::text, "description", "for people; written into the EXR"),
    plain(RuleType::extends, "extends",
          "the preset that this one builds on, by a path relative to this file or, built in, by its name: merged key "
          "by key, `media` by `name`; a `density` with a `profile` of its own replaces the inherited one whole, a "
          "`phase` with a `function` all but its `g`"),

    row(RuleType::boolean, "sky_of_date", {}, "", "false",
        "whether a date, by --date and a place, adds `moon`, `night_sky` and `stars` where the preset has none"),

    number<&Planet::ground_radius>("planet.radius_km", kSize, "km", "6360", "radius of the ground sphere"),
    number<&Planet::atmosphere_height>("planet.atmosphere_height_km", kSize, "km", "100",
                                       "top of the atmosphere above the ground"),
    row<&Planet::ground_albedo>(RuleType::curve, "planet.ground_albedo", kUnit, "", "0",
                                "Lambertian reflectance of the ground"),
    needed(number<&Refraction::n_minus_1>(
        "planet.refraction.n_minus_1", Range{.minimum = 0.0, .maximum = 0.01}, "", "",
        "refractive index of the air at the ground, minus 1, at 550 nm: Earth's is 2.78e-4, 0 bends none. "
        "Light is bent by `orders`, `march`, `sky-view` and `path-trace`, among things too")),
    plain(RuleType::text, "planet.refraction.medium",
          "name of the medium whose density n - 1 follows; of `medium` and `scale_height_km` exactly one; "
          "one of the preset's own takes the place of an inherited one"),
    number("planet.refraction.scale_height_km", kSize, "km", "", "of n - 1"),

    quiet(plain<&GroundMap::albedo_map>(
        RuleType::text, "planet.albedo_map",
        "a picture of reflectances over the whole planet, by a path relative to this file (section Files), "
        "equirectangular, twice as wide as high, north up, longitude 0 in its middle; linear, or sRGB where "
        "the file says so. It takes the place of `ground_albedo`; the camera is over `camera.latitude_deg` and "
        "`camera.longitude_deg`. In a scene with curves a colour stands for a reflectance, as of terrain")),
    number<&Ocean::wind>(
        "planet.ocean.wind_m_per_s", kWind, "m/s", "5",
        "at 12.5 m above an ocean, whose waves mirror the sun: the more wind the wider the glint; measured from 1 "
        "to 14"),
    quiet(plain<&Ocean::mask_map>(
        RuleType::text, "planet.ocean.mask_map",
        "a picture like `albedo_map`, its first channel: white is water, black is land; absent: all of the planet is "
        "water")),

    quiet(plain<&Terrain::height_map>(
        RuleType::text, "planet.terrain.height_map",
        "a picture of heights, by a path relative to this file (section Files), its first channel, row by row "
        "from the upper edge, pixels square; black is 0 and white 1, floats stand as they are. What ends up "
        "at or below 0 km lies under the ground sphere. Of `height_map` and `ridge` exactly one; of the methods "
        "`orders` and `path-trace` know terrain")),
    row<&Ridge::seed>(
        RuleType::integer, "planet.terrain.ridge.seed", Range{.minimum = 0.0, .maximum = 1e9}, "", "1",
        "a mountain range in place of a height map, 1024 x 512 heights, its crest from the left edge to the right: one "
        "number gives one range"),
    number<&Ridge::height>("planet.terrain.ridge.height_km", kTerrainHeight, "km", "2", "of its highest peak"),
    needed(number<&Terrain::width>("planet.terrain.width_km", kTerrainWidth, "km", "",
                                   "of the map from its left edge to its right")),
    quiet(number<&Terrain::lowest>("planet.terrain.lowest_km", kMapHeight, "km", "0",
                                   "height above the ground sphere of the map's value 0")),
    quiet(number<&Terrain::highest>("planet.terrain.highest_km", kMapHeight, "km", "1",
                                    "of its value 1; 0.001 for floats in metres")),
    number<&Terrain::bearing>("planet.terrain.bearing_deg", kAnyAngle, "degrees", "0",
                              "where the map's centre lies from the camera's ground point, clockwise from north"),
    number<&Terrain::distance>("planet.terrain.distance_km", Range{.minimum = 0.0, .maximum = 2000.0}, "km", "0",
                               "how far, along the ground"),
    number<&Terrain::turn>("planet.terrain.turn_deg", kAnyAngle, "degrees", "0",
                           "where the map's upper edge faces, clockwise from north"),
    row<&Terrain::albedo>(RuleType::curve, "planet.terrain.albedo", kUnit, "", "0.2",
                          "Lambertian reflectance; with an `albedo_map` what its colours are multiplied by"),
    quiet(plain<&Terrain::albedo_map>(
        RuleType::text, "planet.terrain.albedo_map",
        "a picture of reflectances over the whole map, of any size; linear, or sRGB where the file says so. In a scene "
        "with curves a colour stands for the smoothest reflectance that has it in the light of the sun")),

    needed(row(RuleType::media, "media", Range{.minimum = 1, .maximum = kMaxMedia}, "", "",
               "what the air is made of; written here or inherited")),
    needed(plain<&Medium::name>(RuleType::name, "media[].name", "unique among the media")),
    row<&Medium::scattering>(
        RuleType::curve, "media[].scattering_per_km", kCoefficient, "per km", "0",
        "scattering coefficient where the density is 1; no medium may have a vertical optical depth above 1e6"),
    row(RuleType::curve, "media[].absorption_per_km", kCoefficient, "per km", "0",
        "absorption coefficient where the density is 1"),
    needed(choice<&Density::profile>("media[].density.profile", kProfileNames, "", "density over the altitude h")),
    only_for(kScaled, needed(number<&Density::scale_height>(
                          "media[].density.scale_height_km", kLength, "km", "",
                          "H: `exponential` is exp(-h/H), `lorentzian` exp(-h/H) / (1 + ((c - h)/w)^2), "
                          "`height-fog` exp(-(h - base)/H) above its base and 1 below"))),
    only_for(kCentered,
             needed(number<&Density::center>("media[].density.center_km", kAltitude, "km", "",
                                             "c: `tent` is max(0, 1 - abs(h - c)/w), `lorentzian` as above"))),
    only_for(kCentered, needed(number<&Density::half_width>("media[].density.half_width_km", kLength, "km", "",
                                                            "w, see `center_km`"))),
    only_for(kConstant, needed(number<&Density::below>("media[].density.below_km", kLength, "km", "",
                                                       "the density is 1 below this altitude and 0 above"))),
    only_for(kFog,
             number<&Density::below>(
                 "media[].density.base_km", kAltitude, "km", "0",
                 "where a height fog begins to thin out; each step of a march takes its mean density in closed form")),
    only_for(kLayered, needed(row(RuleType::layers, "media[].density.layers", kFactor, "", "",
                                  "pairs [altitude_km, density], altitudes ascending from 0 or above; linear between, "
                                  "constant outside; at most 256 over all media"))),
    choice("media[].phase.function", kPhaseNames, "isotropic", "how the medium spreads what it scatters"),
    number<&Medium::phase_g>("media[].phase.g", Range{.minimum = -0.99, .maximum = 0.99}, "", "0.8",
                             "asymmetry, positive = forward; not used by `rayleigh`, `isotropic` and `table`"),
    only_for(kMolecules, quiet(row<&Medium::depolarization>(
                             RuleType::curve, "media[].phase.depolarization", kUnit, "", "0",
                             "Chandrasekhar's gamma, rho / (2 - rho) of the depolarisation rho of light scattered at a "
                             "right angle; 0: molecules that are round"))),
    only_for(kTabled, row(RuleType::angles, "media[].phase.angles_deg", kPhaseAngle, "degrees", "",
                          "scattering angles of `values`, from 0 to 180")),
    only_for(kTabled, row(RuleType::angles, "media[].phase.wavelengths_nm", kWavelength, "nm", "",
                          "where the function changes with the wavelength, those of the rows of `values`")),
    only_for(kTabled, row(RuleType::phase_values, "media[].phase.values", kPhaseValue, "", "",
                          "a value for each angle, or a row of them for each wavelength; with integral 1 or 4 pi over "
                          "the sphere to 5 %")),
    only_for(kTabled,
             plain(RuleType::text, "media[].phase.file",
                   "in place of the three: a table beside the preset, see [Phase functions](#phase-functions)")),
    only_for(kDrops, needed(number<&Medium::effective_radius>(
                         "media[].phase.effective_radius_um",
                         kDropRadius, "um", "",
                         "of water drops of many sizes, whose table is made by Mie's theory: fogbow, glory "
                         "and corona are in it"))),

    row(RuleType::clouds, "clouds", Range{.minimum = 1, .maximum = kMaxClouds}, "", "",
        "water and ice that are uneven in all directions; `path-trace` knows all, `orders` those that stand one above "
        "the other: none begins below the top of a lower one. Each counts as one of the 8 media. A `layer` becomes a "
        "medium"),
    needed(choice<&Cloud::kind>(
        "clouds[].type", kCloudNames, "",
        "`cumulus`: heaps with flat bases; `stratocumulus`: a broken sheet; `cirrus`: ice in fibres; all to "
        "the horizon, by a seed, the same on every machine; `volume`: a file; `layer`: even all around the "
        "planet, for every method")),
    only_for(kVolume,
             needed(plain<&Cloud::file>(RuleType::text, "clouds[].file",
                                        "a grid of OpenVDB, of a name that ends in .vdb, or liquid water (g/m3) and "
                                        "effective radius (um) at points as plain text, see [Clouds](#clouds)"))),
    only_for(kVolume, row<&Cloud::repeats>(RuleType::boolean, "clouds[].repeat", {}, "", "false",
                                           "whether the grid is repeated to the horizon")),
    only_for(kVolume, row<&CloudVoxels::grid>(RuleType::text, "clouds[].grid", {}, "", "density",
                                              "of a .vdb: which of its grids")),
    only_for(kVolume, choice<&CloudVoxels::up>(
                          "clouds[].up", kUpNames, "y",
                          "of a .vdb: its axis that points up. x points east; with y up, z points south, with z up, "
                          "y points north")),
    only_for(kVolume, number<&CloudVoxels::unit>("clouds[].metres_per_unit", kMetresPerUnit, "m", "1",
                                                 "of a .vdb: what the unit of its transform is")),
    only_for(kVolume,
             number<&CloudVoxels::extinction>("clouds[].extinction_per_km", kCoefficient, "per km", "50",
                                              "of a .vdb: extinction where its value is 1; a cumulus has 20 to 100")),
    only_for(kCumulus,
             number<&Cloud::cover>("clouds[].cover", kUnit, "", "0.35", "share of the sky straight up that has cloud")),
    only_for(kStratocumulus, number<&Cloud::cover>("clouds[].cover", kUnit, "", "0.85", "likewise")),
    only_for(kCirrus, number<&Cloud::cover>("clouds[].cover", kUnit, "", "0.5", "likewise")),
    only_for(kCumulus,
             number<&Cloud::base>("clouds[].base_km", kCloudAltitude, "km", "1", "altitude of the lowest parts")),
    only_for(kStratocumulus, number<&Cloud::base>("clouds[].base_km", kCloudAltitude, "km", "0.8", "likewise")),
    only_for(kCirrus, number<&Cloud::base>("clouds[].base_km", kCloudAltitude, "km", "8", "likewise")),
    only_for(kCloudLayers, number("clouds[].base_km", kCloudAltitude, "km", "0.5", "likewise")),
    only_for(kVolume, number<&CloudVoxels::base>(
                          "clouds[].base_km", kCloudAltitude, "km", "",
                          "of a .vdb: altitude of its lowest voxels' lower side; absent: by its transform, whose 0 "
                          "is the ground")),
    only_for(kCumulus, number<&Cloud::top>("clouds[].top_km", kCloudAltitude, "km", "2.4",
                                           "altitude of the highest parts; above the base, inside the air")),
    only_for(kStratocumulus, number<&Cloud::top>("clouds[].top_km", kCloudAltitude, "km", "1.2", "likewise")),
    only_for(kCirrus, number<&Cloud::top>("clouds[].top_km", kCloudAltitude, "km", "9.5", "likewise")),
    only_for(kCloudLayers, number("clouds[].top_km", kCloudAltitude, "km", "1", "likewise")),
    only_for(kCloudLayers, number("clouds[].optical_depth", kLayerDepth, "", "", "from base to top, straight up")),
    only_for(kCloudLayers, number("clouds[].water_g_per_m2", kLayerWater, "g/m2", "",
                                  "in place of it: the water over a square metre; the optical depth is 1.5 water / "
                                  "radius")),
    only_for(kCloudLayers, number("clouds[].scale_height_km", kLength, "km", "",
                                  "the density falls from base to top by exp(-height / this), in 12 straight pieces; "
                                  "absent: it is even but for a fiftieth at base and top")),
    only_for(kCumulus, number<&Cloud::cell>("clouds[].cell_km", kCloudCell, "km", "2", "from one cloud to the next")),
    only_for(kStratocumulus, number<&Cloud::cell>("clouds[].cell_km", kCloudCell, "km", "1.2", "likewise")),
    only_for(kCirrus, number<&Cloud::cell>("clouds[].cell_km", kCloudCell, "km", "4", "likewise")),
    only_for(kCumulus, number<&Cloud::period>("clouds[].period_km", kCloudPeriod, "km", "16",
                                              "after which the field repeats itself; at least two cells")),
    only_for(kStratocumulus, number<&Cloud::period>("clouds[].period_km", kCloudPeriod, "km", "16", "likewise")),
    only_for(kCirrus, number<&Cloud::period>("clouds[].period_km", kCloudPeriod, "km", "32", "likewise")),
    only_for(kCumulus,
             number<&Cloud::detail>("clouds[].detail_m", kCloudDetail, "m", "50",
                                    "side of the cells of the grid that is made; at most 33 554 432 of them")),
    only_for(kStratocumulus, number<&Cloud::detail>("clouds[].detail_m", kCloudDetail, "m", "50", "likewise")),
    only_for(kCirrus, number<&Cloud::detail>("clouds[].detail_m", kCloudDetail, "m", "62.5", "likewise")),
    only_for(kCumulus,
             number<&Cloud::water>("clouds[].water_g_per_m3", kWater, "g/m3", "0.6",
                                   "water or ice where the cloud is densest; the extinction is 1.5 water / radius")),
    only_for(kStratocumulus, number<&Cloud::water>("clouds[].water_g_per_m3", kWater, "g/m3", "0.3", "likewise")),
    only_for(kCirrus, number<&Cloud::water>("clouds[].water_g_per_m3", kWater, "g/m3", "0.02", "likewise")),
    only_for(kCumulus, number<&Cloud::shear>("clouds[].shear_km", kShear, "km", "0.2",
                                             "how far the top leans downwind of the base")),
    only_for(kStratocumulus, number<&Cloud::shear>("clouds[].shear_km", kShear, "km", "0", "likewise")),
    only_for(kCirrus, number<&Cloud::shear>("clouds[].shear_km", kShear, "km", "3", "likewise")),
    only_for(kFields, number<&Cloud::wind>("clouds[].wind_to_deg", kAnyAngle, "degrees", "60",
                                           "where the wind blows to, clockwise from north")),
    only_for(kFields,
             row<&Cloud::seed>(RuleType::integer, "clouds[].seed", Range{.minimum = 0.0, .maximum = 2147483647.0}, "",
                               "1", "of the field's shape")),
    only_for(kCumulus, number<&Cloud::effective_radius>(
                           "clouds[].effective_radius_um", kDropRadius, "um", "10",
                           "of drops or crystals: mean of the radius cubed over mean of the radius squared")),
    only_for(kStratocumulus,
             number<&Cloud::effective_radius>("clouds[].effective_radius_um", kDropRadius, "um", "8", "likewise")),
    only_for(kCirrus,
             number<&Cloud::effective_radius>("clouds[].effective_radius_um", kCrystalRadius, "um", "30", "likewise")),
    only_for(kCloudLayers, number("clouds[].effective_radius_um", kCrystalRadius, "um", "8", "likewise")),
    only_for(kVolume, number("clouds[].effective_radius_um", kDropRadius, "um", "10", "of a .vdb: of its drops")),
    only_for(kPlacedClouds,
             number<&Cloud::east>(
                 "clouds[].east_km", kCloudPlace, "km", "0",
                 "of the grid's middle from the point under the camera; the field repeats itself from there")),
    only_for(kPlacedClouds, number<&Cloud::north>("clouds[].north_km", kCloudPlace, "km", "0", "likewise")),
    only_for(kPlacedClouds, quiet(row<&Cloud::drift>(
                                RuleType::pair, "clouds[].wind_m_s", kCloudWind, "m/s", "0",
                                "[east, north]: moves the cloud from frame to frame of a sequence by time (`sequence "
                                "--date`), whose first frame has it at `east_km` and `north_km`; one picture has no "
                                "use for it"))),
    number<&Cloud::single_scattering_albedo>("clouds[].single_scattering_albedo", kUnit, "", "1",
                                             "share of the light met that is scattered"),
    choice("clouds[].phase.function", kCloudPhaseNames, "drops",
           "`drops`: of the effective radius, by Mie's theory; a volume's of its mean radius. Of `cirrus` it is "
           "`henyey-greenstein` with g 0.75 where nothing is said, since ice is no drops"),
    only_for(kCloudPeak, number("clouds[].phase.g", Range{.minimum = -0.99, .maximum = 0.99}, "", "0.85",
                                "asymmetry, positive = forward")),

    number<&Sun::elevation>("sun.elevation_deg", kRightAngle, "degrees", "30",
                            "of the sun's centre above the horizontal plane"),
    number<&Sun::azimuth>("sun.azimuth_deg", kAnyAngle, "degrees", "0", "clockwise from north, 90 = east"),
    row(RuleType::spectrum, "sun.irradiance", kIrradiance, "", "1",
        "at the top of the atmosphere on a plane that faces the sun; radiance comes out in the same unit per "
        "steradian"),
    plain(RuleType::shape, "sun.spectrum",
          "the light above the air over the wavelength, up to a factor, where the scene has spectra; without it ASTM "
          "G-173's"),
    quiet(choice<&Sun::unit>(
        "sun.unit", kSunUnitNames, "relative",
        "what `irradiance` is in: `relative` says nothing of the absolute; `lux`: its BT.709 luminance, 0.2126 R + "
        "0.7152 G + 0.0722 B, is the illuminance in lux, and that of radiance is in cd/m2; `W/m2`: R = G = B = E is "
        "white sunlight of E W/m2 over its whole spectrum, at 128 000 lux / 1361 W/m2 = 94.05 lm/W")),
    row<&SunDisc::visible>(RuleType::boolean, "sun.disc.visible", {}, "", "true", "whether the picture shows the disc"),
    number<&SunDisc::angular_radius>("sun.disc.angular_radius_deg", kDiscRadius, "degrees", "0.2666",
                                     "half the disc's angular diameter"),
    number<&SunDisc::limb_darkening>("sun.disc.limb_darkening", kUnit, "", "0.6", "u in I(mu) = 1 - u (1 - mu)"),
    number<&SunDisc::radiance_scale>("sun.disc.radiance_scale", kFactor, "", "1",
                                     "1: the disc's mean radiance is irradiance / solid angle"),

    number<&Moon::elevation>("moon.elevation_deg", kRightAngle, "degrees", "30",
                             "of the moon's centre above the horizontal plane; without `moon` there is none"),
    number<&Moon::azimuth>("moon.azimuth_deg", kAnyAngle, "degrees", "0", "clockwise from north"),
    number("moon.phase_deg", kHalfTurns, "degrees", "",
           "angle between sun and camera as the moon sees them: 0 full, 90 the first quarter, -90 the last; absent: by "
           "the place of `sun`"),
    number("moon.illuminated", kUnit, "", "", "in place of `phase_deg`: lit share of the disc, of a waxing moon"),
    number<&Moon::distance>("moon.distance_km", kMoonDistance, "km", "384400",
                            "from the camera; the disc is 0.52 degrees wide at 384 400"),
    number("moon.bright_limb_deg", kAnyAngle, "degrees", "",
           "where the middle of the bright limb is on the disc, from straight up counter-clockwise; absent: toward "
           "`sun`"),

    number<&NightSky::airglow>(
        "night_sky.airglow", kNightFactor, "", "1",
        "factor on the glow of the air at 90 km, which is that of Paranal on a dark night; without `night_sky` there "
        "is no such light, with `{}` all three. It is in cd/m2: a sun of no unit counts as 128 000 lux"),
    number<&NightSky::zodiacal>("night_sky.zodiacal", kNightFactor, "", "1",
                                "factor on sunlight from dust between the planets, which lies along the ecliptic"),
    number<&NightSky::starlight>("night_sky.starlight", kNightFactor, "", "1",
                                 "factor on the light of stars fainter than magnitude 6.5, the Milky Way's with it"),
    number<&NightSky::light_pollution>(
        "night_sky.light_pollution_cd_per_m2", Range{.minimum = 0.0, .maximum = 1e3}, "cd/m2", "0",
        "luminance of the ground by lamps, the same everywhere and in all directions upward; the air scatters it. A "
        "town's mean is some 0.01 to 0.3"),
    choice<&NightSky::lamps>(
        "night_sky.lamps", kLampNames, "led",
        "their spectrum: `led`, white of about 4000 K; `sodium`, high-pressure lamps of about 2000 K"),

    number<&Stars::magnitude_limit>(
        "stars.magnitude_limit", kMagnitude, "", "6.5",
        "of the faintest star drawn, in V; without `stars` there are none, with `{}` 8874 and five planets, placed "
        "by the camera's latitude, longitude and Julian date"),

    hinted("below 0 the camera is inside the planet",
           number<&Camera::altitude>("camera.altitude_km", kAltitude, "km", "0.001",
                                     "above the ground; above the atmosphere is allowed")),
    quiet(number<&Camera::latitude>(
        "camera.latitude_deg", kRightAngle, "degrees", "0",
        "of the place that the camera is over, north positive: where it is on `planet.albedo_map`")),
    quiet(number<&Camera::longitude>("camera.longitude_deg", kAnyAngle, "degrees", "0", "likewise, east positive")),
    quiet(number<&Camera::julian_date>(
        "camera.julian_date", kJulianDate, "days", "2451545",
        "the time there, UTC, by which `stars` and `night_sky` are turned; 2451545 is noon on the first of January "
        "2000")),
    number<&Camera::azimuth>("camera.azimuth_deg", kAnyAngle, "degrees", "0",
                             "where the picture's centre looks, clockwise from north"),
    number<&Camera::pitch>("camera.pitch_deg", kRightAngle, "degrees", "0",
                           "elevation of the picture's centre; 0 for `equirectangular`, `cube` and `octahedral`"),
    number<&Camera::roll>("camera.roll_deg", kAnyAngle, "degrees", "0",
                          "about the view direction; 0 for `equirectangular`, `cube` and `octahedral`"),
    choice<&Camera::projection>("camera.projection", kProjectionNames, "perspective",
                                "how directions fall on the picture"),
    only_for(kPerspective,
             hinted("a view of 180 degrees or more needs the projection \"fisheye\"",
                    number<&Camera::vertical_fov>(
                        "camera.vertical_fov_deg",
                        Range{.minimum = 0.0, .maximum = 180.0, .minimum_excluded = true, .maximum_excluded = true},
                        "degrees", "60", "angle from the lower to the upper edge"))),
    only_for(kFisheye, number<&Camera::vertical_fov>("camera.vertical_fov_deg",
                                                     Range{.minimum = 0.0, .maximum = 360.0, .minimum_excluded = true},
                                                     "degrees", "180", "angle that the shorter side spans")),
    only_for(kMaps, quiet(number<&Camera::vertical_fov>(
                        "camera.vertical_fov_deg", Range{.minimum = 0.0, .maximum = 360.0, .minimum_excluded = true},
                        "degrees", "", "not used: the picture is the whole sphere"))),
    only_for(kCube, choice<&Camera::cube_layout>(
                        "camera.cube_layout", kCubeLayoutNames, "stack",
                        "how the six faces stand: `stack`, OpenEXR's, is 1 x 6 of them from above, `strip` 6 x 1 "
                        "from the left, `cross` 3 x 4 as they hang together")),
    number<&Camera::polariser>(
        "camera.polariser.angle_deg", kAnyAngle, "degrees", "0",
        "of an ideal polarising filter behind the lens: its axis from the picture's up, clockwise as the photographer "
        "sees it. Light that is not polarised passes by half; `orders` and `path-trace` know it, for projections "
        "`perspective` and `fisheye`"),

    row(RuleType::spheres, "scene.spheres", Range{.minimum = 1, .maximum = kMaxSpheres}, "", "",
        "balls, as on a set; `orders` and `path-trace` know them"),
    number<&Sphere::azimuth>("scene.spheres[].azimuth_deg", kAnyAngle, "degrees", "0",
                             "where the camera sees the centre, clockwise from north"),
    number<&Sphere::elevation>("scene.spheres[].elevation_deg", kRightAngle, "degrees", "0", "and how far above level"),
    needed(number<&Sphere::distance>("scene.spheres[].distance_m", kSphereDistance, "m", "",
                                     "from the camera to the centre")),
    needed(number<&Sphere::radius>("scene.spheres[].radius_m", kSphereRadius, "m", "",
                                   "less than the distance: the camera stands outside")),
    choice<&Sphere::material>(
        "scene.spheres[].material", kMaterialNames, "grey-18",
        "`matte`: Lambertian; `mirror`; `translucent`: 0.3 of a matte one and 0.7 of a term by thickness, which "
        "glows as the mean of the light around it; `grey-18` and `chrome`: the two balls of a set, matte of 0.18 "
        "and a mirror of 0.55"),
    only_for(kOwnAlbedo, row<&Sphere::albedo>(RuleType::curve, "scene.spheres[].albedo", kUnit, "", "0.8",
                                              "share of the light that is sent back")),
    only_for(kTranslucent,
             number<&Sphere::scatter_strength>(
                 "scene.spheres[].scatter_strength", Range{.minimum = 0.0, .maximum = 1e3}, "", "16",
                 "how far light gets in the body: below about 8 its middle, where it is thickest, grows dark")),

    row<&ImageSize::width>(RuleType::integer, "image.width", kImageSide, "pixels", "1280", "columns"),
    row<&ImageSize::height>(RuleType::integer, "image.height", kImageSide, "pixels", "720", "rows"),

    quiet(choice<&SceneSpectra::white>(
        "image.white", kWhiteNames, "sun",
        "what is white where the scene has spectra: sunlight above the air, of the irradiance E in all three channels; "
        "or CIE D65, or equal energy at all wavelengths, sunlight then having the luminance E and a colour")),

    row(RuleType::wavelengths, "render.wavelengths", Range{.minimum = kFewestWavelengths, .maximum = kMostWavelengths},
        "", "auto",
        "wavelengths that a scene with spectra is rendered at, in groups of three; \"auto\": the fewest of 3, 6, 12 "
        "and 24 that are wrong by at most 0.4 % for sunlight scattered once, by `orders` 1 % among terrain and "
        "spheres without maps of colour, 2 % among fields of clouds"),
    row<&RenderSettings::polarisation>(
        RuleType::boolean, "render.polarisation", {}, "", "true",
        "whether molecules polarise the light that they scatter, and scatter polarised light accordingly: of every "
        "method that follows light scattered more than once by its direction; the others, by whose mean it is lit, "
        "leave this out"),
    row(RuleType::method, "render.method", {}, "", "orders", "a method's name, see `airlight methods`"),

    quiet(row<&Bloom::enabled>(
        RuleType::boolean, "bloom.enabled", {}, "", "true",
        "glow around what is bright, in the PNG; stated true, it becomes a layer of the EXR as well; false for `cube` "
        "and `octahedral`, where it would stop at the edges")),
    choice<&Bloom::model>(
        "bloom.model", kBloomModelNames, "glare",
        "`glare`: light of the sun scattered in the eye or lens, see Bloom below; `chain`: a published lesson's, "
        "the picture above the threshold halved again and again, each step as strong as the one before"),
    number<&Bloom::threshold>("bloom.threshold", kIrradiance, "", "1",
                              "of `chain`: luminance after exposure from which a pixel glows"),
    number<&Bloom::intensity>(
        "bloom.intensity", Range{.minimum = 0.0, .maximum = 100.0}, "", "0.04",
        "factor on the glow as it is added; of `glare`: the share of the sun's light that is scattered"),
    row<&Bloom::levels>(RuleType::integer, "bloom.levels", Range{.minimum = 1.0, .maximum = 16.0}, "", "5",
                        "of `chain`: halvings of the picture: each doubles the widest glow"),

    row(RuleType::exposure, "display.exposure", Range{.minimum = 1e-9, .maximum = 1e9}, "", "auto",
        "linear factor before the display transform or tone curve, see Exposure below: a number, or found by a meter: "
        "\"auto\", \"day\", \"lock:FRAME\"; never touches the EXR's radiance"),
    number<&Display::compensation>("display.compensation_ev", Range{.minimum = -30.0, .maximum = 30.0}, "stops", "0",
                                   "added to the exposure, whether stated or metered: +1 doubles it"),
    quiet(number<&Display::night>(
        "display.night_ev", Range{.minimum = -10.0, .maximum = 10.0}, "stops", "0",
        "added to a metered exposure by night, as a photographer opens up: in full where the metered luminance "
        "is below 2e-4 cd/m2, a moonless night's, not at all from 0.02 on, between them by the square of its "
        "logarithm")),
    plain<&Display::display>(RuleType::text, "display.display",
                             "a display of the OCIO config in force; \"\" is the config's default"),
    plain<&Display::view>(RuleType::text, "display.view",
                          "a view of that display; \"\" is the config's default, \"gpu\" the tone curve below"),
    choice<&Display::tonemap>("display.tonemap", kToneCurveNames, "aces", "the tone curve of the view \"gpu\""),
    quiet(row<&Display::rods>(
        RuleType::boolean, "display.rods", {}, "", "false",
        "whether the PNG's colours fade and turn blue below 3 cd/m2, as an eye's rods see the night (Kirk and O'Brien "
        "2011); grey stays as bright. Not with the view \"gpu\"")),

    needed(plain(RuleType::key_frames, "sequence.frames",
                 "key frames for `airlight sequence`: each has `at` and, by JSON pointer, what keys are then, e.g. "
                 "`\"/sun/elevation_deg\": -6`; a number, or three of a spectrum")),
    needed(row(RuleType::integer, "sequence.frames[].at", Range{.minimum = 0.0, .maximum = 1e7}, "", "",
               "the frame's number; ascending. There is a picture for every number from the first to the last")),
    choice("sequence.interpolation", kInterpolationNames, "linear",
           "of a key between the key frames that have it; before and after them it stays; keys that take whole numbers "
           "are rounded"),
});

}  // namespace

std::span<const Rule> rules() {
  return kRules;
}

}  // namespace airlight
