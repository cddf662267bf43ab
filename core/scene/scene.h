#pragma once
// A validated scene in internal units: km, radians, spectra in the linear working space. resolve() makes it; all others
// only read it. presets/README.md has the rules of the preset format.

#include <array>
#include <concepts>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/scene/key_frames.h"
#include "core/scene/method_info.h"
#include "core/spectra/colour.h"
#include "core/spectra/curve.h"
#include "core/spectra/moonlight.h"
#include "core/spectra/phase_table.h"

namespace airlight {

using Spectrum = std::array<double, 3>;

// A coefficient or a reflectance: a value for each channel and, in a scene with spectra, the curve that they stand for.
struct SpectralValue : Spectrum {
  Curve curve = {};
  // Channels are 0 until the curve's are found: an array by itself holds what stood there before.
  SpectralValue() : Spectrum{} {}
  explicit SpectralValue(const Spectrum& channels) : Spectrum(channels) {}
  SpectralValue(double first, double second, double third) : Spectrum{first, second, third} {}
  // Takes the channels and keeps the curve.
  template <std::same_as<Spectrum> T>
  SpectralValue& operator=(const T& channels) {
    static_cast<Spectrum&>(*this) = channels;
    return *this;
  }
  bool operator==(const SpectralValue&) const = default;
};

inline constexpr int kMaxMedia = 8;
inline constexpr int kMaxSpheres = 16;
inline constexpr int kMaxClouds = 4;
inline constexpr int kMaxDensityLayers = 256;  // over all media of a scene

enum class DensityProfile { exponential, tent, lorentzian, constant, layers, height_fog };
inline constexpr std::array<std::string_view, 6> kProfileNames = {"exponential", "tent",   "lorentzian",
                                                                  "constant",    "layers", "height-fog"};
enum class PhaseFunction { rayleigh, henyey_greenstein, cornette_shanks, schlick, isotropic, table };
// Behind the enum's: "drops", a table that is made for them.
inline constexpr std::array<std::string_view, 7> kPhaseNames = {
    "rayleigh", "henyey-greenstein", "cornette-shanks", "schlick", "isotropic", "table", "drops"};
inline constexpr std::size_t kDropsPhase = 6;
enum class Projection { perspective, equirectangular, fisheye, cube, octahedral };
enum class CubeLayout { stack, strip, cross };
enum class SphereMaterial { matte, mirror, translucent };
enum class CloudKind { cumulus, stratocumulus, cirrus, volume };
enum class CloudPhase { drops, henyey_greenstein };
enum class SunUnit { relative, watts_per_square_metre, lux };
enum class ToneCurve { aces, reinhard, reinhard_luminance, exponential, clamp, none };

struct DensityLayer {
  double altitude = 0.0;  // km
  double density = 0.0;   // 1
  bool operator==(const DensityLayer&) const = default;
};

struct Density {
  DensityProfile profile = DensityProfile::exponential;
  double scale_height = 1.0;  // km
  double center = 0.0;        // km
  double half_width = 1.0;    // km
  double below = 1.0;         // km; the density is 1 up to this altitude
  std::vector<DensityLayer> layers;
  bool operator==(const Density&) const = default;
};

struct Medium {
  std::string name;
  SpectralValue scattering{};  // 1/km at density 1
  SpectralValue absorption{};  // 1/km at density 1
  Density density;
  PhaseFunction phase = PhaseFunction::isotropic;
  double phase_g = 0.8;
  SpectralValue depolarization{};  // Chandrasekhar's gamma, for rayleigh
  PhaseTable phase_table{};        // for table
  double effective_radius = 0.0;   // um, of the drops whose table it is; 0: of no drops
  Spectrum phase_wavelengths{};    // nm, at which each channel reads it
  bool operator==(const Medium&) const = default;
};

// Air that bends light.
struct Refraction {
  double n_minus_1 = 0.0;              // at the ground
  Density density;                     // that it follows
  std::string medium;                  // whose density that is; empty: the scale height's own
  Spectrum dispersion{1.0, 1.0, 1.0};  // of each channel over 550 nm
  double scale = 1.0;  // of optical lengths, which ready() sets where things stand (core/air/refraction)
  bool operator==(const Refraction&) const = default;
};

struct Planet {
  double ground_radius = 6360.0;     // km
  double atmosphere_height = 100.0;  // km
  SpectralValue ground_albedo{};
  std::optional<Refraction> refraction = {};
  bool operator==(const Planet&) const = default;
};

// A mountain range generated from a seed.
struct Ridge {
  int seed = 1;
  double height = 2.0;  // km, of the highest peak
  bool operator==(const Ridge&) const = default;
};

// Contents of a terrain's files. core/foreign reads them where they are named, since the scene knows no pictures.
struct TerrainFiles {
  std::string identity;  // of the files at the time they were read
  int columns = 0;
  int rows = 0;
  std::vector<float> heights;  // values as in the file, rows from the top; empty: a ridge's are generated
  int colour_columns = 0;
  int colour_rows = 0;
  std::vector<float> colours;  // linear R, G, B; empty: one albedo
};

// For a map's colours: channel c's reflectance is the sum of mix[c][j] x colour j. Channels may be wavelengths.
using ColourMix = std::array<Spectrum, 3>;
inline constexpr ColourMix kColoursThemselves{{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}};

// The reflectance in channel c of a map's colour.
template <class T>
double mixed(const ColourMix& mix, std::size_t c, const T* colour) {
  double sum = 0.0;
  for (std::size_t j = 0; j < 3; ++j) {
    sum += mix[c][j] * static_cast<double>(colour[j]);
  }
  return sum;
}

struct Terrain {
  std::optional<Ridge> ridge;  // absent: a height map
  std::string height_map;      // file names, absolute; empty: none
  std::string albedo_map;
  double width = 0.0;      // km, of the map from left to right
  double lowest = 0.0;     // km, of the value 0
  double highest = 1.0;    // km, of the value 1
  double bearing = 0.0;    // rad, of the map's centre from the camera's ground point, clockwise from north
  double distance = 0.0;   // km, likewise
  double turn = 0.0;       // rad, of the map's upper edge, clockwise from north
  SpectralValue albedo{};  // of the whole terrain, or the factor of the map's colours
  ColourMix mix = kColoursThemselves;
  std::shared_ptr<const TerrainFiles> files;
  std::shared_ptr<const std::vector<float>> ridge_heights;  // km; null: made when they are asked for
};

// The wind-blown water of a planet.
struct Ocean {
  double wind = 5.0;     // m/s
  std::string mask_map;  // file name, absolute; empty: all of the planet is water
  bool operator==(const Ocean&) const = default;
};

// Contents of a ground's files: pictures twice as wide as high over the whole planet, rows from the north pole. They
// are read where they are named, like a terrain's.
struct GroundFiles {
  std::string identity;  // of the files at the time they were read
  int colour_rows = 0;
  std::vector<float> colours;  // linear R, G, B; empty: one albedo
  int water_rows = 0;
  std::vector<float> water;  // share of water; empty: all water, or none without an ocean
};

// A ground with more than one albedo.
struct GroundMap {
  std::string albedo_map;  // file name, absolute; empty: the planet's one albedo
  std::optional<Ocean> ocean;
  ColourMix mix = kColoursThemselves;
  std::shared_ptr<const GroundFiles> files;
};

// A ball before the sky.
struct Sphere {
  double azimuth = 0.0;    // rad, of its centre as seen from the camera, clockwise from north
  double elevation = 0.0;  // rad
  double distance = 0.0;   // km, of its centre
  double radius = 0.0;     // km
  SphereMaterial material = SphereMaterial::matte;
  SpectralValue albedo{};
  double scatter_strength = 16.0;  // for a translucent sphere
  bool operator==(const Sphere&) const = default;
};

// Contents of a cloud's file: water at points of a grid, even in each direction.
struct CloudFile {
  int nx = 0;                     // points toward the east
  int ny = 0;                     // toward the north
  int nz = 0;                     // upward
  double dx = 0.0;                // km between points
  double dy = 0.0;                // km
  double lowest = 0.0;            // km, altitude of the lowest points
  double dz = 0.0;                // km
  std::vector<float> extinction;  // 1/km, x fastest, then y, then z
  double effective_radius = 0.0;  // um, mean over the extinction
  bool in_cells = false;          // even in cells around the points; false: linear between the points
  std::string identity;           // of what was read
  std::string origin;             // of an OpenVDB file as it was on the disk
};

enum class UpAxis { y, z };

// How a grid of an OpenVDB file becomes a cloud. core/foreign reads it, since the scene knows no such library.
struct CloudVoxels {
  std::string grid;
  UpAxis up = UpAxis::y;       // x is east; with y up, z is south, else y is north
  double unit = 1e-3;          // km, of the file's transform
  double extinction = 50.0;    // 1/km, where the file's value is 1
  std::optional<double> base;  // km, of the lowest cells; absent: by the file's transform
  bool operator==(const CloudVoxels&) const = default;
};

// Water or ice that is uneven in all directions. Its extinction is the same at all wavelengths.
struct Cloud {
  std::size_t index = 0;  // in the preset's list, which has layers too; for messages
  CloudKind kind = CloudKind::cumulus;
  std::string file;                        // of a volume: its name, absolute
  std::optional<CloudVoxels> voxels = {};  // of a volume whose file is one of OpenVDB
  double cover = 0.0;                      // share of the sky straight up; of all kinds but a volume, as what follows
  double base = 0.0;                       // km
  double top = 0.0;                        // km
  double cell = 1.0;                       // km, from one cloud to the next
  double detail = 0.05;                    // km, side of the grid's cells
  double period = 12.8;                    // km, after which the field repeats itself
  double water = 0.0;                      // g/m3, where it is densest
  double shear = 0.0;                      // km, by which the top stands downwind of the base
  double wind = 0.0;                       // rad, clockwise from north, toward which it is blown
  int seed = 1;
  bool repeats = true;
  double effective_radius = 0.0;  // um
  double east = 0.0;              // km, of the field's middle from the camera's ground point
  double north = 0.0;             // km
  std::array<double, 2> drift{};  // m/s toward east and north, with the time of a sequence
  double single_scattering_albedo = 1.0;
  CloudPhase phase = CloudPhase::drops;
  double phase_g = 0.85;                      // for henyey_greenstein
  std::shared_ptr<const CloudFile> contents;  // of a volume
  bool operator==(const Cloud&) const = default;
};

// Whether wind moves it in a sequence by time.
inline bool is_moved(const Cloud& cloud) {
  return cloud.drift != std::array<double, 2>{};
}

// A ball that shines by the sun's light.
struct LitBall {
  double phase = 0.0;        // rad, angle between sun and observer as the ball sees them
  double bright_limb = 0.0;  // rad, where the middle of its bright limb is, from straight up to the left
  double earthshine = 0.0;   // radiance by the earth's light over the disc's mean radiance
  bool operator==(const LitBall&) const = default;
};

// What stands before a disc: another.
struct DiscCover {
  double elevation = 0.0;       // rad
  double azimuth = 0.0;         // rad
  double angular_radius = 0.0;  // rad
};

struct SunDisc {
  bool visible = true;
  double angular_radius = 0.0;  // rad
  double limb_darkening = 0.6;
  double radiance_scale = 1.0;
  std::optional<LitBall> lit = {};      // absent: it shines by itself
  std::optional<DiscCover> cover = {};  // absent: it is seen whole
};

struct Sun {
  double elevation = 0.0;              // rad
  double azimuth = 0.0;                // rad, clockwise from north
  Spectrum irradiance{1.0, 1.0, 1.0};  // of the whole disc
  double uncovered = 1.0;              // share of it that the moon leaves
  SunUnit unit = SunUnit::relative;    // of irradiance; radiance is in this unit per steradian
  SunDisc disc;
};

// A second light, far beyond the air.
struct Moon {
  double elevation = 0.0;               // rad
  double azimuth = 0.0;                 // rad, clockwise from north
  double distance = kMeanMoonDistance;  // km, from the camera
  LitBall lit;                          // its phase is negative while the moon wanes
  Curve over_sun;                       // irradiance over the sun's
  Spectrum irradiance{};                // in the scene's channels and the unit of the sun's
  bool operator==(const Moon&) const = default;
};

enum class Lamps { led, sodium };

// The smooth light of a moonless night: factors on what it is on Earth, and the light of towns.
struct NightSky {
  double airglow = 1.0;
  double zodiacal = 1.0;
  double starlight = 1.0;
  double light_pollution = 0.0;  // cd/m2 that the ground sends up
  Lamps lamps = Lamps::led;
  bool operator==(const NightSky&) const = default;
};

// Stars as points, by the camera's place and time.
struct Stars {
  double magnitude_limit = 6.5;  // V
  bool operator==(const Stars&) const = default;
};

struct Camera {
  double altitude = 0.001;  // km
  double azimuth = 0.0;     // rad
  double pitch = 0.0;       // rad
  double roll = 0.0;        // rad
  Projection projection = Projection::perspective;
  double vertical_fov = 0.0;  // rad; for perspective and fisheye
  CubeLayout cube_layout = CubeLayout::stack;
  // Axis of a polarising filter, rad from the picture's up, clockwise as the photographer sees it; absent: no filter.
  std::optional<double> polariser = {};
  double latitude = 0.0;           // rad, of the camera's place on the planet; north positive
  double longitude = 0.0;          // rad, east positive
  double julian_date = 2451545.0;  // UTC, of the night sky over that place
};

// A map of the whole sphere, upright: pitch and roll are 0 and there is no field of view.
constexpr bool is_map(Projection projection) {
  return projection != Projection::perspective && projection != Projection::fisheye;
}

// A map whose edges run through the sky instead of around it.
constexpr bool is_cut(Projection projection) {
  return projection == Projection::cube || projection == Projection::octahedral;
}

// Whether some pixels have no direction: black with alpha 0.
constexpr bool has_outside(const Camera& camera) {
  return camera.projection == Projection::fisheye ||
         (camera.projection == Projection::cube && camera.cube_layout == CubeLayout::cross);
}

struct ImageSize {
  int width = 1280;
  int height = 720;
};

// A rectangle of a picture's pixels; x, y: its upper left one.
struct Tile {
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;
};

// The chosen method and all its parameters, defaults filled in. Inherited parameters (`extends`) that the method does
// not have are left out.
struct RenderSettings {
  std::string method = "orders";
  bool polarisation = true;  // molecules polarise the light that they scatter
  std::map<std::string, ParameterValue, std::less<>> parameters;

  // The named parameter. To ask for one that the method does not declare, or with another type, is a programming error.
  template <class T>
  const T& get(std::string_view key) const {
    return std::get<T>(parameters.find(key)->second);
  }
};

enum class BloomModel { glare, chain };

struct Bloom {
  BloomModel model = BloomModel::glare;
  bool enabled = true;
  bool in_exr = false;  // the preset itself asks for bloom, which becomes a layer of the EXR
  double intensity = 0.04;
  double threshold = 1.0;  // for a chain, on exposed luminance
  int levels = 5;          // for a chain
};

// The light that meters an exposure that is no number: the picture's own, a midday's, or that of a sequence's frame.
enum class Metering { picture, day, frame };

struct Display {
  std::optional<double> exposure;  // a linear factor; absent: metered
  Metering metering = Metering::picture;
  int metered_frame = 0;      // for Metering::frame
  double compensation = 0.0;  // stops, added in either case
  double night = 0.0;         // stops, added to a metered exposure where it is dark
  std::string display;        // empty: the OCIO config's default
  std::string view;           // empty: the OCIO config's default; "gpu": the GPU tone curve
  ToneCurve tonemap = ToneCurve::aces;
  bool rods = false;  // whether a dark picture has the colours that an eye in the dark sees
};

// Light over the wavelength, where the scene's values have curves.
struct SceneSpectra {
  Curve sun;                        // above the air, up to a factor
  int wavelengths = 0;              // 0: auto
  double irradiance = 1.0;          // of the sun, as the preset gives it
  std::optional<Curve> light = {};  // the scene's light over that of `sun`, which white and irradiance go by; absent: 1
  White white = White::sun;
  bool operator==(const SceneSpectra&) const = default;
};

struct Scene {
  std::string name;
  std::string description;
  Planet planet;
  std::optional<Terrain> terrain;
  std::optional<GroundMap> ground;  // with a map of albedo, planet.ground_albedo is its mean
  std::vector<Sphere> spheres;
  std::vector<Medium> media;
  std::vector<Cloud> clouds;
  Sun sun;
  std::optional<Moon> moon;
  std::optional<NightSky> night_sky;
  std::optional<Stars> stars;
  Camera camera;
  ImageSize image;
  RenderSettings render;
  Bloom bloom;
  Display display;
  std::optional<KeyFrames> sequence;  // absent: the preset has no key frames
  // Absent: the scene has only the three channels of media, ground and sun. Present: these stand for 615, 541 and 449
  // nm, and the sun's irradiance is its colour.
  std::optional<SceneSpectra> spectra;
};

// Calls use(value) for all of the scene's values that may have a curve.
template <class AnyScene, class Use>
void for_each_spectral_value(AnyScene& scene, Use use) {
  use(scene.planet.ground_albedo);
  for (auto& medium : scene.media) {
    use(medium.scattering);
    use(medium.absorption);
    use(medium.depolarization);
  }
  for (auto& sphere : scene.spheres) {
    use(sphere.albedo);
  }
  if (scene.terrain) {
    use(scene.terrain->albedo);
  }
}

}  // namespace airlight
