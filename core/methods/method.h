#pragma once
// What a rendering method is. A new one is one .cpp, its shaders and one line in registry.cpp; the command line, the
// help, the tests and the chart loop over the registry.

#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/air/air.h"
#include "core/plan/plan.h"
#include "core/radiance_image.h"
#include "core/scene/method_info.h"
#include "core/scene/scene.h"

namespace airlight {

// A view direction by its angles in the preset's frame, radians; azimuth clockwise from north.
struct Direction {
  double elevation = 0.0;
  double azimuth = 0.0;
};

// The direction of a unit vector in that frame: x east, y up, -z north.
inline Direction angles_of(const physics::vec3& d) {
  return {std::atan2(d.y, std::hypot(d.x, d.z)), std::atan2(d.x, -d.z)};
}

// What to render: the camera's picture, or listed directions from the camera's place (without the sun's disc).
struct View {
  std::span<const Direction> directions;  // empty: the camera's picture
  // Listed directions as pixels of the camera's picture would have them, by the same tables: transmittance is not told.
  bool as_picture = false;
  std::optional<Tile> tile = {};  // of the camera's picture: this much of it
  // A black wall at this distance from the camera, km, which hides what is behind it and lights nothing: for listed
  // directions of a method on the host.
  std::optional<double> wall = {};
  // Where not empty, the picture is rendered by several plans, and its own tables are kept from one to the next under
  // keys that begin so.
  std::string kept_as = {};
};

// What a scene, a view of it and a quality are placed by where a method is known to fail.
enum class Quantity {
  sun_elevation,  // degrees
  altitude,       // of the camera, km
  view,           // elevation above the true horizon, degrees
  optical_depth,  // of the whole air, straight up
  asymmetry,      // g of the medium that scatters
  planet_radius,  // km
  steps,          // render.steps
  table_size,     // greater side of the tables, texels
  light_kept,     // 1: neither air nor ground absorbs; else the lesser of ground albedo and the air's own albedo
};
inline constexpr std::size_t kQuantities = 9;

struct Limit {
  Quantity quantity = Quantity::steps;
  double minimum = 0.0;
  double maximum = 0.0;
};

// A region in which the method is known to fail, all limits together, and why: what `airlight stability` finds must
// stand here, in the claim below, or be mended.
struct KnownFailure {
  std::string_view symptoms;  // letters of core/stability/judge.h
  std::vector<Limit> where;
  std::string_view cause;
};

// Where a method claims to hold; outside, the command line warns once. Radians, km, vertical optical depth.
struct Validity {
  double sun_elevation_min = -1.5707963267948966;
  double altitude_max = 1e9;
  double optical_depth_max = 1e9;
  std::string_view leaves_out;  // what it does not model, for `airlight methods` and the warning
  double error = 0.02;          // mean relative error against its converged quality that it stays below
  std::vector<KnownFailure> known_failures = {};
};

// One point that the method contributes to the chart: parameters over the scene's own.
struct Quality {
  std::string_view label;
  std::vector<std::pair<std::string_view, ParameterValue>> parameters;
  // False: on the chart for comparison, but never chosen (core/choice). Either a direction alone does not tell its
  // error, which depends on where in the picture the pixel stands, or the chart shows that it pays nowhere.
  bool may_be_chosen = true;
};

// The passes of a GPU method, added to a plan. `radiance` holds a vec4 for each pixel, rows from the top (alpha 0
// outside a fisheye's circle); for listed directions two vec4s each: radiance, then transmittance along the ray.
// `tables` are the images that the method baked, for the dump and the check of their values; the first, if any, is
// always the transmittance to the top of the atmosphere, which the sun's disc is seen through.
struct SkyPasses {
  BufferId radiance;
  std::vector<ImageId> tables;
  std::vector<ImageId> more_tables = {};  // of logarithms or signed numbers: for the dump alone
};

// The light of a picture apart by where it comes from. `planes`: floats, three planes a layer over the view's tile:
// single scattering of each medium that scatters, multiple scattering, the ground, then the transmittance along the
// ray.
struct LayerPasses {
  BufferId planes;
  std::optional<ImageId> transmittance;  // the method's table, if it has one: the sun's disc is seen through it
};

// A ray of the camera's picture through the centre of a pixel, up to a distance in km.
struct Span {
  std::uint16_t x = 0;
  std::uint16_t y = 0;
  float distance = 0.0F;
};

// Rays of the picture up to things, told in one of two ways.
struct Spans {
  std::span<const Span> list = {};
  // Whole rows of the picture: the distance of every pixel, infinite where nothing is.
  std::span<const float> rows = {};
  std::uint32_t first_row = 0;

  std::size_t size() const { return list.size() + rows.size(); }
};

// How the air up to things is found.
struct SpanWay {
  bool volume = false;       // from a table over directions and distances, else by a march along each span
  std::string kept_as = {};  // where not empty, as View::kept_as
};

// `air`: for each span the radiance that the air up to there sends to the camera, and its transmittance: 0 and 1 where
// nothing is. Six floats, or where `packed` 16 bytes (shaders/shared/span_air_packed.glsl).
struct SpanPasses {
  BufferId air;
  bool packed = false;
};

// How a host method runs: nothing here changes what a given number of samples yields.
struct HostOptions {
  // Called a few times a second with done in 0 to 1; returns false to stop early with what there is. Empty: nobody
  // listens.
  std::function<bool(double done)> report = {};
  // A file that keeps the state of a method that samples: read when it exists, written now and then and at the end.
  // Empty: none.
  std::string checkpoint = {};
  double checkpoint_interval_s = 60.0;
  unsigned int threads = 0;  // 0: as many as the machine has
};

struct HostPicture {
  RadianceImage radiance;               // for listed directions: width = their count, height 1
  RadianceImage transmittance;          // listed directions only
  RadianceImage standard_error;         // empty for a deterministic method
  std::uint64_t samples = 0;            // a pixel, of a method that samples
  std::vector<std::string> notes = {};  // what was left undone because it would never have ended
};

// The same sky without the error of steps and tables: a method, the method itself where empty, and its parameters.
struct Converged {
  std::string_view method;
  std::vector<std::pair<std::string_view, ParameterValue>> parameters;
};

// Each takes a scene with its air as the method's keys want it (scene_air.h).
using HostTables = std::map<std::string, physics::HostTable>;

// The radiance of the scene along one of its rays, in double.
using RayFormula = std::function<physics::vec3(const physics::Physics::Ray&)>;

struct SpectralScene;

struct SkyMethod {
  MethodInfo info;
  Validity validity;
  std::vector<Quality> sweep;
  Converged converged;
  // Parameters with which it makes all its tables, however small the picture, in place of its defaults. Empty: it
  // always does.
  std::vector<std::pair<std::string_view, ParameterValue>> all_tables;
  // Parameters with which it leaves out light scattered more than once. Empty: there are none.
  std::vector<std::pair<std::string_view, ParameterValue>> single_scattering;
  // Exactly one of add_passes and render_on_host. The host's takes a scene with spectra as it stands, and renders it
  // in the colours of the picture; the device's takes three channels, a group of wavelengths at a time.
  SkyPasses (*add_passes)(Plan&, const Scene&, const Air&, const View&) = nullptr;
  // For a scene with spectra: one picture pass in colours for all wavelengths, from tables of each group of them, where
  // the method's tables allow it for this view. `tables`: the groups' transmittance, one each. Null, or nothing: there
  // is a picture for each group, and their sum.
  std::optional<SkyPasses> (*add_spectral_passes)(Plan&, const Scene&, const SpectralScene&, const View&) = nullptr;
  // Writes into the settings what `auto` stands for in this scene where it follows the air, so that all wavelengths of
  // it are rendered alike. Null: nothing does.
  void (*settle)(RenderSettings&, const Scene&, const Air&) = nullptr;
  // What its picture does without because the scene needs it not, where the keys leave that to the scene, a line each;
  // null: nothing.
  std::vector<std::string> (*spared)(const Scene&, const Air&) = nullptr;
  HostPicture (*render_on_host)(const Scene&, const Air&, const View&, const HostOptions&) = nullptr;
  // What of the scene's wishes is not done because it would take for ever, a line each; null: nothing.
  std::vector<std::string> (*bounds)(const Scene&, const Air&) = nullptr;
  // The layers of the camera's picture. Null: the method does not tell them apart.
  LayerPasses (*add_layer_passes)(Plan&, const Scene&, const Air&, const View&) = nullptr;
  // The air between the camera and things. Null: the method knows whole rays alone.
  SpanPasses (*add_span_passes)(Plan&, const Scene&, const Air&, const Spans&, const SpanWay&) = nullptr;
  // Whether SpanWay::volume holds for the scene's camera. Null: never.
  bool (*has_volume)(const Scene&) = nullptr;
  // Writes into the settings what `auto` stands for in a picture with layers, where not all of it keeps light apart.
  // Null: it does.
  void (*keep_apart)(RenderSettings&) = nullptr;
  // Why it does not for this scene, though it does in general; empty: it does. Null: it always does.
  std::string (*layers_refusal)(const Scene&) = nullptr;
  // What the picture does without as this plan has it, a line each. Null: nothing.
  std::vector<std::string> (*left_out)(const Scene&, const Plan&) = nullptr;
  // Its own formulas in double. `p`: the scene's, to put `tables` into, by name as the device has filled them. Null: it
  // has none beside its tables'.
  RayFormula (*formula)(physics::Physics p, const Scene&, const Air&, const HostTables& tables) = nullptr;
};

// All methods, in the order of the help text.
std::span<const SkyMethod> methods();

// Null when there is none of that name.
const SkyMethod* find_method(std::string_view name);

// That of a scene: resolve() refuses unknown names.
const SkyMethod& method_of(const Scene& scene);

// Whether it takes samples, on the host.
bool samples(const Scene& scene);

// The scene as this method renders it at this quality: the method's defaults, and the quality's parameters over them.
Scene with_quality(Scene scene, const SkyMethod& method, const Quality& quality);

// Their parameters, for resolve().
std::span<const MethodInfo> method_infos();

}  // namespace airlight
