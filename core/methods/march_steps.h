#pragma once
// Number and distribution of a march's steps, by its keys and, where these say `auto`, by the scene.

#include <cstdint>

#include "core/methods/method.h"

namespace airlight {

// Keys of methods whose steps are always given, then those of `march`, which may leave both to the scene.
ParameterInfo steps_parameter(int default_steps);
ParameterInfo step_distribution_parameter();
ParameterInfo automatic_steps_parameter();
ParameterInfo automatic_distribution_parameter();

struct MarchSteps {
  int count = 0;
  std::uint32_t distribution = 0;  // physics::kStepsUniform, ...
  bool operator==(const MarchSteps&) const = default;
};

MarchSteps march_steps(const Part& part);

// The value of kStepDistribution by the keys; quadratic where they leave it to the scene.
std::uint32_t step_distribution_code(const Scene& scene);

// Whether steps, their distribution and their places are all left to the scene.
bool steps_are_automatic(const RenderSettings& settings);

// Number of quadratic steps where no count is given.
inline constexpr int kUsualSteps = 32;

// Writes the choice into the settings.
void write_steps(RenderSettings& settings, const MarchSteps& steps);

}  // namespace airlight
