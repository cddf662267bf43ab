#include "core/scene/rules.h"

#include "core/scene/json_format.h"
#include "core/scene/scene.h"

namespace airlight {
namespace {

// Where the format says only "> 0" or ">= 0", these are what any sky needs and what the 32-bit arithmetic of the
// shaders holds with squares and ratios to spare. Planet and air: a metre; fourteen times the Sun.
constexpr Range kSize{.minimum = 1e-3, .maximum = kFarthest};
// Within the air: a millimetre.
constexpr Range kLength{.minimum = 1e-6, .maximum = kFarthest};
constexpr Range kAltitude = kLayerAltitude;
constexpr Range kCoefficient{.minimum = 0.0, .maximum = 1e5};  // the light of a centimetre
constexpr Range kFactor{.minimum = 0.0, .maximum = 1e6};
constexpr Range kIrradiance{.minimum = 0.0, .maximum = 1e9};
constexpr Range kTerrainWidth{.minimum = 1e-3, .maximum = 2000.0};
constexpr Range kTerrainHeight{.minimum = 1e-3, .maximum = 100.0};
constexpr Range kMapHeight{.minimum = -100.0, .maximum = 100.0};
constexpr Range kWind{.minimum = 0.0, .maximum = 20.0};
constexpr Range kSphereDistance{.minimum = 1e-3, .maximum = 1e7};
constexpr Range kSphereRadius{.minimum = 1e-4, .maximum = 1e6};
constexpr Range kUnit{.minimum = 0.0, .maximum = 1.0};
constexpr Range kPhaseAngle{.minimum = 0.0, .maximum = 180.0};
constexpr Range kPhaseValue{.minimum = 0.0, .maximum = 1e9};
constexpr Range kRightAngle{.minimum = -90.0, .maximum = 90.0};
constexpr Range kAnyAngle{.minimum = -1e6, .maximum = 1e6};
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
constexpr std::array<std::string_view, 1> kPerspective = {"perspective"};
constexpr std::array<std::string_view, 1> kFisheye = {"fisheye"};
constexpr std::array<std::string_view, 3> kMaps = {"equirectangular", "cube", "octahedral"};
constexpr std::array<std::string_view, 3> kOwnAlbedo = {"matte", "mirror", "translucent"};
constexpr std::array<std::string_view, 1> kTranslucent = {"translucent"};
constexpr std::array<std::string_view, 1> kCube = {"cube"};

constexpr auto kRules = std::to_array<Rule>({
    {.key = "airlight", .type = RuleType::version, .required = true, .meaning = "the format's version, 1"},
    {.key = "$schema", .type = RuleType::text, .meaning = "for editors: where the JSON Schema is; not read"},
    {.key = "name", .type = RuleType::text, .meaning = "for people; written into the EXR"},
    {.key = "description", .type = RuleType::text, .meaning = "for people; written into the EXR"},
    {.key = "extends",
     .type = RuleType::extends,
     .meaning = "the preset that this one builds on, by a path relative to this file or, built in, by its name: merged "
                "key by key, `media` by `name`; a `density` with a `profile` of its own replaces the inherited one "
                "whole, a `phase` with a `function` all but its `g`"},

    {.key = "planet.radius_km",
     .range = kSize,
     .unit = "km",
     .default_text = "6360",
     .meaning = "radius of the ground sphere"},
    {.key = "planet.atmosphere_height_km",
     .range = kSize,
     .unit = "km",
     .default_text = "100",
     .meaning = "top of the atmosphere above the ground"},
    {.key = "planet.ground_albedo",
     .type = RuleType::curve,
     .range = kUnit,
     .default_text = "0",
     .meaning = "Lambertian reflectance of the ground"},

    {.key = "planet.albedo_map",
     .type = RuleType::text,
     .meaning =
         "a picture of reflectances over the whole planet, by a path relative to this file: any that OpenImageIO "
         "reads, equirectangular, twice as wide as high, north up, longitude 0 in its middle; linear, or sRGB where "
         "the file says so. It takes the place of `ground_albedo`; the camera is over `camera.latitude_deg` and "
         "`camera.longitude_deg`. Not with curves over the wavelength, terrain or spheres"},
    {.key = "planet.ocean.wind_m_per_s",
     .range = kWind,
     .unit = "m/s",
     .default_text = "5",
     .meaning =
         "at 12.5 m above an ocean, whose waves mirror the sun: the more wind the wider the glint; measured from "
         "1 to 14"},
    {.key = "planet.ocean.mask_map",
     .type = RuleType::text,
     .meaning = "a picture like `albedo_map`, its first channel: white is water, black is land; absent: all of the "
                "planet is water"},

    {.key = "planet.terrain.height_map",
     .type = RuleType::text,
     .meaning =
         "a picture of heights, by a path relative to this file: any that OpenImageIO reads, its first channel, "
         "row by row from the upper edge, pixels square; black is 0 and white 1, floats stand as they are. What "
         "ends up at or below 0 km lies under the ground sphere. Of `height_map` and `ridge` exactly one; of the "
         "methods `orders` and `path-trace` know terrain"},
    {.key = "planet.terrain.ridge.seed",
     .type = RuleType::integer,
     .range = {.minimum = 0.0, .maximum = 1e9},
     .default_text = "1",
     .meaning = "a mountain range in place of a height map, 1024 x 512 heights, its crest from the left edge to the "
                "right: one number gives one range"},
    {.key = "planet.terrain.ridge.height_km",
     .range = kTerrainHeight,
     .unit = "km",
     .default_text = "2",
     .meaning = "of its highest peak"},
    {.key = "planet.terrain.width_km",
     .range = kTerrainWidth,
     .unit = "km",
     .required = true,
     .meaning = "of the map from its left edge to its right"},
    {.key = "planet.terrain.lowest_km",
     .range = kMapHeight,
     .unit = "km",
     .default_text = "0",
     .meaning = "height above the ground sphere of the map's value 0"},
    {.key = "planet.terrain.highest_km",
     .range = kMapHeight,
     .unit = "km",
     .default_text = "1",
     .meaning = "of its value 1; 0.001 for floats in metres"},
    {.key = "planet.terrain.bearing_deg",
     .range = kAnyAngle,
     .unit = "degrees",
     .default_text = "0",
     .meaning = "where the map's centre lies from the camera's ground point, clockwise from north"},
    {.key = "planet.terrain.distance_km",
     .range = {.minimum = 0.0, .maximum = 2000.0},
     .unit = "km",
     .default_text = "0",
     .meaning = "how far, along the ground"},
    {.key = "planet.terrain.turn_deg",
     .range = kAnyAngle,
     .unit = "degrees",
     .default_text = "0",
     .meaning = "where the map's upper edge faces, clockwise from north"},
    {.key = "planet.terrain.albedo",
     .type = RuleType::spectrum,
     .range = kUnit,
     .default_text = "0.2",
     .meaning = "Lambertian reflectance; with an `albedo_map` what its colours are multiplied by"},
    {.key = "planet.terrain.albedo_map",
     .type = RuleType::text,
     .meaning = "a picture of reflectances over the whole map, of any size; linear, or sRGB where the file says so"},

    {.key = "media",
     .type = RuleType::media,
     .range = {.minimum = 1, .maximum = kMaxMedia},
     .required = true,
     .meaning = "what the air is made of; written here or inherited"},
    {.key = "media[].name", .type = RuleType::name, .required = true, .meaning = "unique among the media"},
    {.key = "media[].scattering_per_km",
     .type = RuleType::curve,
     .range = kCoefficient,
     .unit = "per km",
     .default_text = "0",
     .meaning = "scattering coefficient where the density is 1; no medium may have a vertical optical depth above 1e6"},
    {.key = "media[].absorption_per_km",
     .type = RuleType::curve,
     .range = kCoefficient,
     .unit = "per km",
     .default_text = "0",
     .meaning = "absorption coefficient where the density is 1"},
    {.key = "media[].density.profile",
     .type = RuleType::choice,
     .required = true,
     .choices = kProfileNames,
     .meaning = "density over the altitude h"},
    {.key = "media[].density.scale_height_km",
     .range = kLength,
     .unit = "km",
     .required = true,
     .only_for = kScaled,
     .meaning = "H: `exponential` is exp(-h/H), `lorentzian` exp(-h/H) / (1 + ((c - h)/w)^2), `height-fog` "
                "exp(-(h - base)/H) above its base and 1 below"},
    {.key = "media[].density.center_km",
     .range = kAltitude,
     .unit = "km",
     .required = true,
     .only_for = kCentered,
     .meaning = "c: `tent` is max(0, 1 - abs(h - c)/w), `lorentzian` as above"},
    {.key = "media[].density.half_width_km",
     .range = kLength,
     .unit = "km",
     .required = true,
     .only_for = kCentered,
     .meaning = "w, see `center_km`"},
    {.key = "media[].density.below_km",
     .range = kLength,
     .unit = "km",
     .required = true,
     .only_for = kConstant,
     .meaning = "the density is 1 below this altitude and 0 above"},
    {.key = "media[].density.base_km",
     .range = kAltitude,
     .unit = "km",
     .default_text = "0",
     .only_for = kFog,
     .meaning = "where a height fog begins to thin out; each step of a march takes its mean density in closed form"},
    {.key = "media[].density.layers",
     .type = RuleType::layers,
     .range = kFactor,
     .required = true,
     .only_for = kLayered,
     .meaning = "pairs [altitude_km, density], altitudes ascending from 0 or above; linear between, constant outside; "
                "at most 256 over all media"},
    {.key = "media[].phase.function",
     .type = RuleType::choice,
     .default_text = "isotropic",
     .choices = kPhaseNames,
     .meaning = "how the medium spreads what it scatters"},
    {.key = "media[].phase.g",
     .range = {.minimum = -0.99, .maximum = 0.99},
     .default_text = "0.8",
     .meaning = "asymmetry, positive = forward; not used by `rayleigh`, `isotropic` and `table`"},
    {.key = "media[].phase.depolarization",
     .type = RuleType::curve,
     .range = kUnit,
     .default_text = "0",
     .only_for = kMolecules,
     .meaning = "Chandrasekhar's gamma, rho / (2 - rho) of the depolarisation rho of light scattered at a right angle; "
                "0: molecules that are round"},
    {.key = "media[].phase.angles_deg",
     .type = RuleType::angles,
     .range = kPhaseAngle,
     .unit = "degrees",
     .only_for = kTabled,
     .meaning = "scattering angles of `values`, from 0 to 180"},
    {.key = "media[].phase.wavelengths_nm",
     .type = RuleType::angles,
     .range = kWavelength,
     .unit = "nm",
     .only_for = kTabled,
     .meaning = "where the function changes with the wavelength, those of the rows of `values`"},
    {.key = "media[].phase.values",
     .type = RuleType::phase_values,
     .range = kPhaseValue,
     .only_for = kTabled,
     .meaning =
         "a value for each angle, or a row of them for each wavelength; with integral 1 or 4 pi over the sphere to "
         "5 %"},
    {.key = "media[].phase.file",
     .type = RuleType::text,
     .only_for = kTabled,
     .meaning = "in place of the three: a table beside the preset, see [Phase functions](#phase-functions)"},

    {.key = "sun.elevation_deg",
     .range = kRightAngle,
     .unit = "degrees",
     .default_text = "30",
     .meaning = "of the sun's centre above the horizontal plane"},
    {.key = "sun.azimuth_deg",
     .range = kAnyAngle,
     .unit = "degrees",
     .default_text = "0",
     .meaning = "clockwise from north, 90 = east"},
    {.key = "sun.irradiance",
     .type = RuleType::spectrum,
     .range = kIrradiance,
     .default_text = "1",
     .meaning = "at the top of the atmosphere on a plane that faces the sun; radiance comes out in the same unit per "
                "steradian"},
    {.key = "sun.spectrum",
     .type = RuleType::shape,
     .meaning = "the light above the air over the wavelength, up to a factor, where the scene has spectra; without it "
                "ASTM G-173's"},
    {.key = "sun.unit",
     .type = RuleType::choice,
     .default_text = "relative",
     .choices = kSunUnitNames,
     .meaning = "what `irradiance` is in: `relative` says nothing of the absolute; `lux`: its BT.709 luminance, "
                "0.2126 R + 0.7152 G + 0.0722 B, is the illuminance in lux, and that of radiance is in cd/m2; `W/m2`: "
                "R = G = B = E is white sunlight of E W/m2 over its whole spectrum, at 128 000 lux / 1361 W/m2 = 94.05 "
                "lm/W"},
    {.key = "sun.disc.visible",
     .type = RuleType::boolean,
     .default_text = "true",
     .meaning = "whether the picture shows the disc"},
    {.key = "sun.disc.angular_radius_deg",
     .range = kDiscRadius,
     .unit = "degrees",
     .default_text = "0.2666",
     .meaning = "half the disc's angular diameter"},
    {.key = "sun.disc.limb_darkening", .range = kUnit, .default_text = "0.6", .meaning = "u in I(mu) = 1 - u (1 - mu)"},
    {.key = "sun.disc.radiance_scale",
     .range = kFactor,
     .default_text = "1",
     .meaning = "1: the disc's mean radiance is irradiance / solid angle"},

    {.key = "camera.altitude_km",
     .range = kAltitude,
     .unit = "km",
     .default_text = "0.001",
     .meaning = "above the ground; above the atmosphere is allowed",
     .hint = "below 0 the camera is inside the planet"},
    {.key = "camera.latitude_deg",
     .range = kRightAngle,
     .unit = "degrees",
     .default_text = "0",
     .meaning = "of the place that the camera is over, north positive: where it is on `planet.albedo_map`"},
    {.key = "camera.longitude_deg",
     .range = kAnyAngle,
     .unit = "degrees",
     .default_text = "0",
     .meaning = "likewise, east positive"},
    {.key = "camera.azimuth_deg",
     .range = kAnyAngle,
     .unit = "degrees",
     .default_text = "0",
     .meaning = "where the picture's centre looks, clockwise from north"},
    {.key = "camera.pitch_deg",
     .range = kRightAngle,
     .unit = "degrees",
     .default_text = "0",
     .meaning = "elevation of the picture's centre; 0 for `equirectangular`, `cube` and `octahedral`"},
    {.key = "camera.roll_deg",
     .range = kAnyAngle,
     .unit = "degrees",
     .default_text = "0",
     .meaning = "about the view direction; 0 for `equirectangular`, `cube` and `octahedral`"},
    {.key = "camera.projection",
     .type = RuleType::choice,
     .default_text = "perspective",
     .choices = kProjectionNames,
     .meaning = "how directions fall on the picture"},
    {.key = "camera.vertical_fov_deg",
     .range = {.minimum = 0.0, .maximum = 180.0, .minimum_excluded = true, .maximum_excluded = true},
     .unit = "degrees",
     .default_text = "60",
     .only_for = kPerspective,
     .meaning = "angle from the lower to the upper edge",
     .hint = "a wider view needs the projection \"fisheye\""},
    {.key = "camera.vertical_fov_deg",
     .range = {.minimum = 0.0, .maximum = 360.0, .minimum_excluded = true},
     .unit = "degrees",
     .default_text = "180",
     .only_for = kFisheye,
     .meaning = "angle that the shorter side spans"},
    {.key = "camera.vertical_fov_deg",
     .range = {.minimum = 0.0, .maximum = 360.0, .minimum_excluded = true},
     .unit = "degrees",
     .only_for = kMaps,
     .meaning = "not used: the picture is the whole sphere"},
    {.key = "camera.cube_layout",
     .type = RuleType::choice,
     .default_text = "stack",
     .choices = kCubeLayoutNames,
     .only_for = kCube,
     .meaning =
         "how the six faces stand: `stack`, OpenEXR's, is 1 x 6 of them from above, `strip` 6 x 1 from the left, "
         "`cross` 3 x 4 as they hang together"},

    {.key = "scene.spheres",
     .type = RuleType::spheres,
     .range = {.minimum = 1, .maximum = kMaxSpheres},
     .meaning = "balls before the sky, as on a set; of the methods `orders` alone knows them"},
    {.key = "scene.spheres[].azimuth_deg",
     .range = kAnyAngle,
     .unit = "degrees",
     .default_text = "0",
     .meaning = "where the camera sees the centre, clockwise from north"},
    {.key = "scene.spheres[].elevation_deg",
     .range = kRightAngle,
     .unit = "degrees",
     .default_text = "0",
     .meaning = "and how far above level"},
    {.key = "scene.spheres[].distance_m",
     .range = kSphereDistance,
     .unit = "m",
     .required = true,
     .meaning = "from the camera to the centre"},
    {.key = "scene.spheres[].radius_m",
     .range = kSphereRadius,
     .unit = "m",
     .required = true,
     .meaning = "less than the distance: the camera stands outside"},
    {.key = "scene.spheres[].material",
     .type = RuleType::choice,
     .default_text = "grey-18",
     .choices = kMaterialNames,
     .meaning =
         "`matte`: Lambertian; `mirror`; `translucent`: 0.3 of a matte one and 0.7 of a term by thickness, which "
         "glows as the mean of the light around it; `grey-18` and `chrome`: the two balls of a set, matte of "
         "0.18 and a mirror of 0.55"},
    {.key = "scene.spheres[].albedo",
     .type = RuleType::curve,
     .range = kUnit,
     .default_text = "0.8",
     .only_for = kOwnAlbedo,
     .meaning = "share of the light that is sent back"},
    {.key = "scene.spheres[].scatter_strength",
     .range = {.minimum = 0.0, .maximum = 1e3},
     .default_text = "16",
     .only_for = kTranslucent,
     .meaning = "how far light gets in the body: below about 8 its middle, where it is thickest, grows dark"},

    {.key = "image.width",
     .type = RuleType::integer,
     .range = kImageSide,
     .unit = "pixels",
     .default_text = "1280",
     .meaning = "columns"},
    {.key = "image.height",
     .type = RuleType::integer,
     .range = kImageSide,
     .unit = "pixels",
     .default_text = "720",
     .meaning = "rows"},

    {.key = "image.white",
     .type = RuleType::choice,
     .default_text = "sun",
     .choices = kWhiteNames,
     .meaning = "what is white where the scene has spectra: sunlight above the air, of the irradiance E in all three "
                "channels; or CIE D65, or equal energy at all wavelengths, sunlight then having the luminance E and a "
                "colour"},

    {.key = "render.wavelengths",
     .type = RuleType::wavelengths,
     .range = {.minimum = kFewestWavelengths, .maximum = kMostWavelengths},
     .default_text = "auto",
     .meaning =
         "wavelengths that a scene with spectra is rendered at, in groups of three; \"auto\": the fewest of 3, 6, "
         "12 and 24 that are wrong by at most a third of a percent for sunlight scattered once"},
    {.key = "render.method",
     .type = RuleType::method,
     .default_text = "orders",
     .meaning = "a method's name, see `airlight methods`"},

    {.key = "bloom.enabled",
     .type = RuleType::boolean,
     .default_text = "true",
     .meaning = "glow around what is bright, in the PNG; stated true, it becomes a layer of the EXR as well; false for "
                "`cube` and `octahedral`, where it would stop at the edges"},
    {.key = "bloom.model",
     .type = RuleType::choice,
     .default_text = "glare",
     .choices = kBloomModelNames,
     .meaning =
         "`glare`: light of the sun scattered in the eye or lens, see Bloom below; `chain`: a published lesson's, "
         "the picture above the threshold halved again and again, each step as strong as the one before"},
    {.key = "bloom.threshold",
     .range = kIrradiance,
     .default_text = "1",
     .meaning = "of `chain`: luminance after exposure from which a pixel glows"},
    {.key = "bloom.intensity",
     .range = {.minimum = 0.0, .maximum = 100.0},
     .default_text = "0.04",
     .meaning = "factor on the glow as it is added; of `glare`: the share of the sun's light that is scattered"},
    {.key = "bloom.levels",
     .type = RuleType::integer,
     .range = {.minimum = 1.0, .maximum = 16.0},
     .default_text = "5",
     .meaning = "of `chain`: halvings of the picture: each doubles the widest glow"},

    {.key = "display.exposure",
     .type = RuleType::exposure,
     .range = {.minimum = 1e-9, .maximum = 1e9},
     .default_text = "auto",
     .meaning = "linear factor before the display transform or tone curve, see Exposure below: a number, or found by a "
                "meter: \"auto\", \"day\", \"lock:FRAME\"; never touches the EXR's radiance"},
    {.key = "display.compensation_ev",
     .range = {.minimum = -30.0, .maximum = 30.0},
     .unit = "stops",
     .default_text = "0",
     .meaning = "added to the exposure, whether stated or metered: +1 doubles it"},
    {.key = "display.display",
     .type = RuleType::text,
     .meaning = "a display of the OCIO config in force; \"\" is the config's default"},
    {.key = "display.view",
     .type = RuleType::text,
     .meaning = "a view of that display; \"\" is the config's default, \"gpu\" the tone curve below"},
    {.key = "display.tonemap",
     .type = RuleType::choice,
     .default_text = "aces",
     .choices = kToneCurveNames,
     .meaning = "the tone curve of the view \"gpu\""},

    {.key = "sequence.frames",
     .type = RuleType::key_frames,
     .required = true,
     .meaning = "key frames for `airlight sequence`: each has `at` and, by JSON pointer, what keys are then, e.g. "
                "`\"/sun/elevation_deg\": -6`; a number, or three of a spectrum"},
    {.key = "sequence.frames[].at",
     .type = RuleType::integer,
     .range = {.minimum = 0.0, .maximum = 1e7},
     .required = true,
     .meaning = "the frame's number; ascending. There is a picture for every number from the first to the last"},
    {.key = "sequence.interpolation",
     .type = RuleType::choice,
     .default_text = "linear",
     .choices = kInterpolationNames,
     .meaning = "of a key between the key frames that have it; before and after them it stays; keys that take whole "
                "numbers are rounded"},
});

std::string with_unit(std::string text, std::string_view unit) {
  return unit.empty() ? text : text + " " + std::string(unit);
}

}  // namespace

bool Range::contains(double value) const {
  const bool above = minimum_excluded ? value > minimum : value >= minimum;
  const bool below = maximum_excluded ? value < maximum : value <= maximum;
  return above && below;
}

std::span<const Rule> rules() {
  return kRules;
}

std::string range_text(const Range& range, std::string_view unit) {
  const bool has_minimum = range.minimum > -std::numeric_limits<double>::infinity();
  const bool has_maximum = range.maximum < std::numeric_limits<double>::infinity();
  if (!has_minimum && !has_maximum) {
    return "any";
  }
  if (has_minimum && has_maximum && !range.minimum_excluded && !range.maximum_excluded) {
    return with_unit(format_number(range.minimum) + " to " + format_number(range.maximum), unit);
  }
  std::string text;
  if (has_minimum) {
    text = (range.minimum_excluded ? "above " : "at least ") + format_number(range.minimum);
  }
  if (has_maximum) {
    text += (has_minimum ? " and " : "") + std::string(range.maximum_excluded ? "below " : "at most ") +
            format_number(range.maximum);
  }
  return with_unit(text, unit);
}

std::string expectation(const Rule& rule) {
  const std::string range = range_text(rule.range, rule.unit);
  switch (rule.type) {
    case RuleType::version:
      return "1";
    case RuleType::extends:
      return "a file name or that of a built-in preset";
    case RuleType::text:
      return "a string";
    case RuleType::name:
      return "a string of at least one character";
    case RuleType::boolean:
      return "true or false";
    case RuleType::integer:
      return "a whole number, " + range;
    case RuleType::number:
      return "a number, " + range;
    case RuleType::spectrum:
      return "a number or an array of three, " + range;
    case RuleType::curve:
      return "a number or an array of three, " + range + ", or a curve {...}";
    case RuleType::shape:
      return "a curve {...}";
    case RuleType::wavelengths:
      return "a whole number, " + range + ", or \"auto\"";
    case RuleType::choice: {
      std::string text = "one of";
      for (std::size_t i = 0; i < rule.choices.size(); ++i) {
        text += (i == 0 ? " " : ", ") + json_string(rule.choices[i]);
      }
      return text;
    }
    case RuleType::method:
      return "the name of a method";
    case RuleType::exposure:
      return "a number, " + range + ", \"auto\", \"day\" or \"lock:FRAME\"";
    case RuleType::media:
      return "an array of " + range + " media";
    case RuleType::spheres:
      return "an array of " + range + " spheres";
    case RuleType::angles:
      return "an array of ascending numbers, " + range;
    case RuleType::phase_values:
      return "an array of numbers, " + range + ", or one such array a wavelength";
    case RuleType::layers:
      return "an array of [altitude_km, density], altitudes ascending";
    case RuleType::key_frames:
      return "an array of at least one {\"at\": NUMBER, \"/POINTER\": VALUE, ...}";
  }
  return {};
}

}  // namespace airlight
