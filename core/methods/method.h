#pragma once
// The interface of a rendering method. A new method is one .cpp, its shaders and one line in registry.cpp. The command
// line, the help, the tests and the chart loop over the registry.

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

// The rays to render: the camera's picture, or listed directions from the camera's place (without the sun's disc).
struct View {
  std::span<const Direction> directions;  // empty: the camera's picture
  // Renders listed directions as the camera's picture would, by the same tables; transmittance is not computed.
  bool as_picture = false;
  std::optional<Tile> tile = {};  // of the camera's picture: the part to render
  // Distance from the camera of a black wall, km, for listed directions of a method on the host. It hides what is
  // behind it and lights nothing.
  std::optional<double> wall = {};
  // Not empty: several plans render the picture, and its own tables are kept from one to the next under keys that begin
  // with this.
  std::string kept_as = {};
};

// The quantities that locate a scene, a view of it and a quality among a method's known failures.
enum class Quantity {
  sun_elevation,  // degrees
  altitude,       // of the camera, km
  view,           // elevation above the true horizon, degrees
  optical_depth,  // of the whole air along the vertical
  asymmetry,      // mean cosine of the scattering by the medium that does most, molecules left out
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

// A region in which the method is known to fail (all limits hold at once), and why. A failure that `airlight stability`
// finds must be listed here, excluded by the claim below, or mended.
struct KnownFailure {
  std::string_view symptoms;  // letters of core/stability/judge.h
  std::vector<Limit> where;
  std::string_view cause;
};

// The range in which a method claims to hold; outside it the command line warns once. Radians, km, vertical optical
// depth.
struct Validity {
  double sun_elevation_min = -1.5707963267948966;
  double altitude_max = 1e9;
  double optical_depth_max = 1e9;
  std::string_view leaves_out;  // effects that it does not model, for `airlight methods` and the warning
  double error = 0.02;          // bound on the mean relative error against its converged quality
  std::vector<KnownFailure> known_failures = {};
};

// One point that the method contributes to the chart: parameters over the scene's own.
struct Quality {
  std::string_view label;
  std::vector<std::pair<std::string_view, ParameterValue>> parameters;
  // False: charted for comparison, but never chosen (core/choice). Either its error depends on the pixel's place in the
  // picture, not on the direction alone, or the chart shows that it never pays.
  bool may_be_chosen = true;
};

// The passes of a GPU method, added to a plan. `radiance` holds a vec4 for each pixel, rows from the top (alpha 0
// outside a fisheye's circle); for listed directions two vec4s each: radiance, then transmittance along the ray.
// `tables` are the images that the method baked, for the dump and the check of their values. The first, if any, is
// always the transmittance to the top of the atmosphere, through which the sun's disc is seen.
struct SkyPasses {
  BufferId radiance;
  std::vector<ImageId> tables;
  std::vector<ImageId> more_tables = {};  // of logarithms or signed numbers: for the dump alone
};

// The light of a picture kept apart by its origin. `planes`: floats, three planes a layer over the view's tile: single
// scattering of each medium that scatters, multiple scattering, the ground, then the transmittance along the ray.
struct LayerPasses {
  BufferId planes;
  std::optional<ImageId> transmittance;  // the method's table, if it has one, for the sun's disc
};

// A ray of the camera's picture through the centre of a pixel, up to a distance in km.
struct Span {
  std::uint16_t x = 0;
  std::uint16_t y = 0;
  float distance = 0.0F;
};

// Rays of the picture up to things, given in one of two ways.
struct Spans {
  std::span<const Span> list = {};
  // Whole rows of the picture: the distance of every pixel, infinite where there is nothing.
  std::span<const float> rows = {};
  std::uint32_t first_row = 0;

  std::size_t size() const { return list.size() + rows.size(); }
};

// The way to find the air up to things.
struct SpanWay {
  bool volume = false;       // true: from a table over directions and distances; false: by a march along each span
  std::string kept_as = {};  // where not empty, as View::kept_as
};

// `air`: for each span the radiance of the air before the thing, as the camera sees it, and the air's transmittance; 0
// and 1 where nothing is. Six floats, or 16 bytes if `packed` (shaders/shared/span_air_packed.glsl).
struct SpanPasses {
  BufferId air;
  bool packed = false;
};

// Options of a host method. None of them changes the result of a given number of samples.
struct HostOptions {
  // Called a few times a second with the share done, 0 to 1. Returns false to stop early with the result so far. May be
  // empty.
  std::function<bool(double done)> report = {};
  // File with the state of a method that samples: read when it exists, written now and then and at the end. Empty:
  // none.
  std::string checkpoint = {};
  double checkpoint_interval_s = 60.0;
  unsigned int threads = 0;  // 0: as many as the machine has
};

struct HostPicture {
  RadianceImage radiance;               // for listed directions: width = their count, height 1
  RadianceImage transmittance;          // listed directions only
  RadianceImage standard_error;         // empty for a deterministic method
  std::uint64_t samples = 0;            // per pixel, for a method that samples
  std::vector<std::string> notes = {};  // what was left undone because it would not have ended
};

// The same sky without errors of steps and tables: a method (empty: the method itself) and its parameters.
struct Converged {
  std::string_view method;
  std::vector<std::pair<std::string_view, ParameterValue>> parameters;
};

// The device's tables by name.
using HostTables = std::map<std::string, physics::HostTable>;

// The radiance of the scene along one of its rays, in double.
using RayFormula = std::function<physics::vec3(const physics::Physics::Ray&)>;

struct SpectralScene;

// Its functions take a scene with its air as the method's keys want it (scene_air.h).
struct SkyMethod {
  MethodInfo info;
  Validity validity;
  std::vector<Quality> sweep;
  Converged converged;
  // Parameters that make it build all its tables, however small the picture, in place of its defaults. Empty: it always
  // builds all.
  std::vector<std::pair<std::string_view, ParameterValue>> all_tables;
  // Parameters that leave out light scattered more than once. Empty: there are none.
  std::vector<std::pair<std::string_view, ParameterValue>> single_scattering;
  // Exactly one of add_passes and render_on_host is set. The host's takes a scene with spectra as it stands and renders
  // it in the picture's colours. The device's takes three channels, one group of wavelengths at a time.
  SkyPasses (*add_passes)(Plan&, const Scene&, const Air&, const View&) = nullptr;
  // For a scene with spectra: one picture pass in colours for all wavelengths, from tables of each group, if the
  // method's tables permit it for this view. `tables`: the groups' transmittance, one each. Null, or no result: the
  // picture is the sum of a picture for each group.
  std::optional<SkyPasses> (*add_spectral_passes)(Plan&, const Scene&, const SpectralScene&, const View&) = nullptr;
  // Replaces `auto` in the settings, where its meaning depends on the air, so that all wavelengths of a scene are
  // rendered alike. Null: there is no such key.
  void (*settle)(RenderSettings&, const Scene&, const Air&) = nullptr;
  // Parts of the method that the picture omits because the scene does not need them, where keys leave that to the
  // scene; a line each. Null: none.
  std::vector<std::string> (*spared)(const Scene&, const Air&) = nullptr;
  HostPicture (*render_on_host)(const Scene&, const Air&, const View&, const HostOptions&) = nullptr;
  // Wishes of the scene that it does not fulfil because that would not end, a line each; null: none.
  std::vector<std::string> (*bounds)(const Scene&, const Air&) = nullptr;
  // The layers of the camera's picture. Null: the method cannot keep them apart.
  LayerPasses (*add_layer_passes)(Plan&, const Scene&, const Air&, const View&) = nullptr;
  // The air between the camera and things. Null: the method computes whole rays only.
  SpanPasses (*add_span_passes)(Plan&, const Scene&, const Air&, const Spans&, const SpanWay&) = nullptr;
  // Whether SpanWay::volume holds for the scene's camera. Null: never.
  bool (*has_volume)(const Scene&) = nullptr;
  // Replaces `auto` in the settings for a picture with layers, where some meanings of `auto` do not keep light apart.
  // Null: all do.
  void (*keep_apart)(RenderSettings&) = nullptr;
  // Why layers are impossible for this scene, though the method has them; empty: they are possible. Null: they always
  // are.
  std::string (*layers_refusal)(const Scene&) = nullptr;
  // Parts of the method that the picture omits in this plan, a line each. Null: none.
  std::vector<std::string> (*left_out)(const Scene&, const Plan&) = nullptr;
  // Its own formulas in double. `p`: the scene's physics, which takes `tables`, by name as the device filled them.
  // Null: it has none but those of its tables.
  RayFormula (*formula)(physics::Physics p, const Scene&, const Air&, const HostTables& tables) = nullptr;
};

// All methods, in the order of the help text.
std::span<const SkyMethod> methods();

// Null when there is none of that name.
const SkyMethod* find_method(std::string_view name);

// The scene's method; resolve() has refused unknown names.
const SkyMethod& method_of(const Scene& scene);

// Whether the scene's method takes samples, on the host.
bool samples(const Scene& scene);

// The scene as this method renders it at this quality: the method's defaults, and the quality's parameters over them.
Scene with_quality(Scene scene, const SkyMethod& method, const Quality& quality);

// The parameters of all methods, for resolve().
std::span<const MethodInfo> method_infos();

}  // namespace airlight
