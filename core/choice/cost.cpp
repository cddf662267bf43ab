#include "core/choice/cost.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "core/physics/physics.h"

namespace airlight::choice {
namespace {

// A thread of a shader costs `base`, and `step` for each step that its push constants name. Measured on the software
// device by `airlight chart`; on hardware the ratios are much the same, as fetches and steps are what both spend on.
struct Weight {
  std::string_view shader;
  double base;
  double step;
};
constexpr std::array kWeights{
    Weight{"sky_march", 4.0, 1.0},          Weight{"sky_view", 4.0, 1.0},
    Weight{"sky_from_view", 5.0, 0.0},      Weight{"sky_orders", 10.0, 2.5},
    Weight{"sky_factors", 10.0, 2.5},       Weight{"sky_from_factors", 2.0, 0.0},
    Weight{"sky_analytic", 5.0, 0.0},       Weight{"sky_nested", 4.0, 1.0},
    Weight{"transmittance", 12.0, 0.0},     Weight{"multiple_scattering", 44.0, 0.0},
    Weight{"ground_irradiance", 44.0, 0.0}, Weight{"orders_bake", 0.0, 2.0},
};

double threads_of(const PassDesc& pass) {
  return static_cast<double>(pass.grid.width) * pass.grid.height * pass.grid.depth;
}

double constant(const PassDesc& pass, std::size_t i) {
  return i < pass.push_constants.size() ? static_cast<double>(pass.push_constants[i]) : 0.0;
}

// What finding the optical depth of a ray costs, in steps.
double steps_to_place_steps(const PassDesc& pass) {
  constexpr double kPanels = physics::kOpticalPanels;
  const bool by_depth = std::ranges::any_of(pass.specialization, [](const Specialization& constant) {
    return constant.name == "kStepDistribution" && constant.value == physics::kStepsOpticalDepth;
  });
  return by_depth ? kPanels : 0.0;
}

// Steps of one thread.
double steps_of(const PassDesc& pass) {
  if (pass.shader == "sky_nested") {
    return constant(pass, 2) * (1.0 + constant(pass, 3));
  }
  if (pass.shader == "orders_bake") {
    return constant(pass, 0) * constant(pass, 1) / pass.grid.width;  // directions are shared by a row of threads
  }
  const bool first = pass.shader == "sky_view" || pass.shader == "sky_factors";
  return constant(pass, first ? 0 : 2) + steps_to_place_steps(pass);
}

double cost_of(const PassDesc& pass) {
  for (const Weight& weight : kWeights) {
    if (weight.shader == pass.shader) {
      return threads_of(pass) * (weight.base + weight.step * steps_of(pass));
    }
  }
  return threads_of(pass);
}

}  // namespace

bool is_table(const Plan& plan, ResourceId id) {
  const auto* image = std::get_if<ImageId>(&id);
  return image != nullptr && !plan.images()[image->index].key.empty();
}

Cost predicted_cost(const Plan& plan, const IsKept& is_there) {
  const std::vector<bool> runs = passes_to_run(plan, is_there);
  const std::vector<bool> of_picture = passes_to_run(plan, [&](ResourceId id) { return is_table(plan, id); });
  Cost cost;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (runs[i]) {
      (of_picture[i] ? cost.picture : cost.tables) += cost_of(plan.passes()[i]);
    }
  }
  return cost;
}

}  // namespace airlight::choice
