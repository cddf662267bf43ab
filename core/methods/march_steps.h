#pragma once
// How many steps a march takes and where they stand: by its keys, and what these leave to the scene.

#include <cstdint>

#include "core/methods/method.h"

namespace airlight {

// The keys of `march`, which may leave both to the scene, and of methods whose steps are always told.
ParameterInfo steps_parameter(int default_steps);
ParameterInfo step_distribution_parameter();
ParameterInfo automatic_steps_parameter();
ParameterInfo automatic_distribution_parameter();

struct MarchSteps {
  int count = 0;
  std::uint32_t distribution = 0;  // physics::kStepsUniform, ...
  bool operator==(const MarchSteps&) const = default;
};

MarchSteps march_steps(const Scene& scene, const Air& air);

// The value of kStepDistribution that the keys tell; quadratic where they leave it to the scene.
std::uint32_t step_distribution_code(const Scene& scene);

// Whether steps, their distribution and their places are all left to the scene.
bool steps_are_automatic(const RenderSettings& settings);

// Quadratic ones, where no count is told.
inline constexpr int kUsualSteps = 32;

// Writes the choice into the settings.
void write_steps(RenderSettings& settings, const MarchSteps& steps);

}  // namespace airlight
