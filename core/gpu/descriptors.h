#pragma once
// The descriptor sets that the passes of a run bind.

#include <span>

#include "core/gpu/frame.h"
#include "core/gpu/run_resources.h"
#include "core/gpu/step.h"

namespace airlight {

DescriptorCounts count_descriptors(std::span<const Step> steps);

// Points the step's set at its resources.
void write_descriptors(const Device& device, const Plan& plan, const RunResources& resources, VkSampler sampler,
                       const Step& step);

}  // namespace airlight
