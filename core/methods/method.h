#pragma once
// The interface of a rendering method. A new method is one .cpp, its shaders and one line in registry.cpp. The command
// line, the help, the tests and the chart loop over the registry.

#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/plan/plan.h"
#include "core/scene/method_info.h"
#include "core/stage/stage.h"
#include "core/stage/view.h"

namespace airlight {

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
  refractivity,   // refractive index less 1, at the ground
  waves,          // wind over a planet that is all water, m/s
};
inline constexpr std::size_t kQuantities = 11;

struct Limit {
  Quantity quantity = Quantity::steps;
  double minimum = 0.0;
  double maximum = 0.0;
};

// A region in which the method is known to fail (all limits hold at once), and why. A failure that `airlight stability`
// finds must be listed here, excluded by the claim below, or mended.
struct KnownFailure {
  std::string_view symptoms;  // letters of core/stability/judge.h; empty: of scenes that STABILITY.md does not have
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

// Name of the buffer of a plan that holds what all clouds leave of a beam along each pixel's ray, a float each.
// The host reads that of layers.
inline constexpr std::string_view kCloudTransmittance = "cloud_transmittance";

// The passes of a GPU method, added to a plan. `radiance` holds a vec4 for each pixel, rows from the top (alpha 0
// outside a fisheye's circle); for listed directions two vec4s each: radiance, then transmittance along the ray;
// where the view asks for them, Q and U follow.
// `tables` are the images that the method baked, for the dump and the check of their values. The first, if any, is
// always the transmittance to the top of the atmosphere, through which the sun's disc is seen.
struct SkyPasses {
  BufferId radiance;
  std::vector<ImageId> tables;
  std::vector<ImageId> more_tables = {};  // of logarithms or signed numbers: for the dump alone
};

// A picture of a plan that passes draw into: they add to what it holds, or write all of it where it is blank.
struct Canvas {
  BufferId radiance;
  bool is_blank = true;
};

// The light of a picture kept apart by its origin. `planes`: floats, three planes a layer over the view's tile: single
// scattering of each medium that scatters, multiple scattering, the ground, then the transmittance along the ray, and Q
// and U where the view asks for them. Where the scene has clouds all these are seen through them, and kCloudPlanes
// follow: three of the clouds' light, the share of what stands behind that they hide, and that share times the mean
// distance (km) of what hides it; and the plan has a buffer whose name begins with kCloudTransmittance.
inline constexpr std::size_t kCloudPlanes = 5;
struct LayerPasses {
  BufferId planes;
  std::optional<ImageId> transmittance;  // the method's table, if it has one, for the sun's disc
};

// `air`: for each span the radiance of the air before the thing, as the camera sees it, and the air's transmittance; 0
// and 1 where nothing is. Six floats, or 16 bytes if `packed` (shaders/shared/span_air_packed.glsl).
struct SpanPasses {
  BufferId air;
  bool packed = false;
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

// Its functions take three channels of a scene that ready() has made, their air as the method's keys want it; those
// that choose among wavelengths take the whole stage.
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
  // Exactly one of add_passes and render_on_host is set. The host's renders all parts at once, in the picture's
  // colours.
  SkyPasses (*add_passes)(Plan&, const Part&, const View&) = nullptr;
  // Of a stage of several parts: one picture pass in colours for all, from tables of each part, if the method's tables
  // permit it for this view. `tables`: the parts' transmittance, one each. Null, or no result: the picture is the sum
  // of a picture for each part. The passes draw into the canvas, or, where there is none, into a picture that they add.
  std::optional<SkyPasses> (*add_coloured_passes)(Plan&, const Stage&, const View&,
                                                  const std::optional<Canvas>&) = nullptr;
  // Replaces `auto` in the settings, where its meaning depends on the air, so that all wavelengths of a scene are
  // rendered alike. Null: there is no such key.
  void (*settle)(RenderSettings&, const Part&) = nullptr;
  // Parts of the method that the picture omits because the scene does not need them, where keys leave that to the
  // scene; a line each. Null: none.
  std::vector<std::string> (*spared)(const Part&) = nullptr;
  HostPicture (*render_on_host)(const Stage&, const View&, const HostOptions&) = nullptr;
  // Wishes of the scene that it does not fulfil because that would not end, a line each; null: none.
  std::vector<std::string> (*bounds)(const Part&) = nullptr;
  // The layers of the camera's picture. Null: the method cannot keep them apart.
  LayerPasses (*add_layer_passes)(Plan&, const Part&, const View&) = nullptr;
  // Why it has neither layers nor the air before things (below) of this scene, and what to do; empty: it has. Null: of
  // every scene it has those that it has at all.
  std::string (*no_layers)(const Scene&) = nullptr;
  // Whether it tells Q and U of listed directions, and as layers (View::stokes).
  bool has_stokes = false;
  // The air between the camera and things. Null: the method computes whole rays only.
  SpanPasses (*add_span_passes)(Plan&, const Part&, const Spans&, const SpanWay&) = nullptr;
  // Whether SpanWay::volume holds for the scene's camera. Null: never.
  bool (*has_volume)(const Scene&) = nullptr;
  // Parts of the method that the picture omits in this plan, a line each. Null: none.
  std::vector<std::string> (*left_out)(const Scene&, const Plan&) = nullptr;
  // Its own formulas in double. `p`: the scene's physics, which takes `tables`, by name as the device filled them.
  // Null: it has none but those of its tables.
  RayFormula (*formula)(physics::Physics p, const Part&, const HostTables& tables) = nullptr;
};

// All methods, in the order of the help text.
std::span<const SkyMethod> methods();

// Null when there is none of that name.
const SkyMethod* find_method(std::string_view name);

// The scene's method; resolve() has refused unknown names.
const SkyMethod& method_of(const Scene& scene);

// SkyMethod::no_layers of the scene's method.
std::string no_layers(const Scene& scene);

// Whether the scene's method takes samples, on the host.
bool samples(const Scene& scene);
bool samples(const Stage& stage);

// The scene as this method renders it at this quality: the method's defaults, and the quality's parameters over them.
Scene with_quality(Scene scene, const SkyMethod& method, const Quality& quality);

// The parameters of all methods, for resolve().
std::span<const MethodInfo> method_infos();

}  // namespace airlight
