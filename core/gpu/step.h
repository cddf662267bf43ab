#pragma once
// A pass that runs, with everything needed to record it.

#include "core/gpu/match.h"
#include "core/gpu/pipeline.h"
#include "core/plan/plan.h"

namespace airlight {

struct Step {
  const PassDesc* pass = nullptr;
  const ShaderProgram* program = nullptr;
  MatchedPass matched;
  bool barrier = false;
  std::uint32_t stretch = 0;  // which of the timed stretches it belongs to, from 0
  VkPipeline pipeline = nullptr;
  VkDescriptorSet set = nullptr;

  bool writes(ResourceId id) const;
};

// Throws RunError naming pass, limit and size when the step exceeds the device's limits.
void check_limits(const Plan& plan, const Step& step, const Device& device);

}  // namespace airlight
