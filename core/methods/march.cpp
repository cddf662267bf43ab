// `march`: the view ray is marched on tables of transmittance and isotropic multiple scattering [H20].

#include <array>
#include <string>
#include <utility>

#include "core/methods/ground_pass.h"
#include "core/methods/march_passes.h"
#include "core/methods/marched_picture.h"
#include "core/methods/methods.h"
#include "core/scene/angle.h"

namespace airlight {
namespace {

const std::array<ParameterInfo, 9> kParameters{automatic_steps_parameter(),
                                               automatic_distribution_parameter(),
                                               jitter_parameter(),
                                               automatic_resolution_parameter(),
                                               phase_parameter(),
                                               transmittance_lut_parameter(),
                                               multiple_scattering_lut_parameter(),
                                               multiple_scattering_scale_parameter(),
                                               sun_fade_parameter()};

SkyPasses add_march(Plan& plan, const Part& part, const View& view) {
  const SkyTarget target = add_sky_target(plan, part.scene, view);
  const MarchTables tables = add_march_tables(plan, part);
  begin_black_ground(plan, part, view);
  add_march_pass(plan, part, tables, target);
  end_black_ground(plan, part, view);
  add_march_ground(plan, part, tables, target);
  return {target.radiance, tables.list()};
}

void settle(RenderSettings& settings, const Part& part) {
  settings.parameters.insert_or_assign("resolution", std::string(halves(part.scene) ? "half" : "full"));
  write_steps(settings, march_steps(part));
}

std::vector<std::string> spared(const Part& part) {
  std::vector<std::string> lines;
  if (const MarchSteps steps = march_steps(part); steps_are_automatic(part.scene.render) && steps.count < kUsualSteps) {
    lines.push_back("steps: in air so smooth " + std::to_string(steps.count) + " Gauss-Legendre nodes do in place of " +
                    std::to_string(kUsualSteps) + " steps");
  }
  if (part.scene.render.get<std::string>("resolution") == "auto" && halves(part.scene)) {
    lines.emplace_back("pixels: so fine that most go bilinearly between a march in four");
  }
  return lines;
}

// A quality sets all that the default leaves to the scene: candidates are judged by directions, without a picture.
Quality with_steps(std::string_view label, int steps) {
  return {label,
          {{"steps", steps}, {"step_distribution", std::string("quadratic")}, {"resolution", std::string("full")}}};
}

Quality with_tables(std::string_view label, int steps, TableSize transmittance, TableSize multiple_scattering) {
  Quality quality = with_steps(label, steps);
  quality.parameters.emplace_back("transmittance_lut", transmittance);
  quality.parameters.emplace_back("multiple_scattering_lut", multiple_scattering);
  return quality;
}

Quality with_key(std::string_view label, int steps, std::string_view key, std::string value,
                 bool may_be_chosen = true) {
  Quality quality = with_steps(label, steps);
  std::erase_if(quality.parameters, [&](const auto& parameter) { return parameter.first == key; });
  quality.parameters.emplace_back(key, std::move(value));
  quality.may_be_chosen = may_be_chosen;
  return quality;
}

// The contribution of each key to the chart, with its cost and error beside the plain march's.
std::vector<Quality> keys_of_the_ladder() {
  return {{"default", {}, false},
          with_key("8, Gauss-Legendre", 8, "step_distribution", "gauss-legendre"),
          with_key("16, Gauss-Legendre", 16, "step_distribution", "gauss-legendre"),
          with_key("8, blue noise", 8, "jitter", "blue-noise", false),
          with_key("16, blue noise", 16, "jitter", "blue-noise", false),
          with_key("32, half resolution", 32, "resolution", "half", false),
          with_key("32, Schlick", 32, "phase", "schlick", false)};
}

}  // namespace

SkyMethod march_method() {
  SkyMethod method;
  method.info = {"march", "view march on transmittance and isotropic multiple-scattering tables [H20]", kParameters};
  method.info.knows_ground_maps = true;
  method.info.bends_light = true;
  method.validity.leaves_out = "direction and polarisation of light scattered more than once";
  method.sweep = {with_steps("4", 4),
                  with_tables("8, small tables", 8, {64, 16}, {8, 8}),
                  with_steps("8", 8),
                  with_steps("16", 16),
                  with_tables("16, small tables", 16, {64, 16}, {8, 8}),
                  with_steps("32", 32),
                  with_steps("64", 64),
                  with_steps("128", 128),
                  with_tables("128, large tables", 128, {512, 128}, {64, 64}),
                  with_steps("512", 512)};
  const std::vector<Quality> keys = keys_of_the_ladder();
  method.sweep.insert(method.sweep.end(), keys.begin(), keys.end());
  method.validity.sun_elevation_min = -6.0 * kDegree;
  method.validity.optical_depth_max = 5.0;
  method.validity.known_failures = march_failures();
  method.converged = converged_march();
  method.add_passes = add_march;
  method.settle = settle;
  method.spared = spared;
  method.left_out = march_left_out;
  method.single_scattering = {{"multiple_scattering_scale", 0.0}};
  method.formula = march_formula;
  return method;
}

}  // namespace airlight
