#pragma once
// One execution of one plan.

#include <functional>

#include "core/gpu/executor.h"
#include "core/gpu/frame.h"
#include "core/gpu/pipeline.h"
#include "core/gpu/resource_cache.h"
#include "core/gpu/stored_tables.h"
#include "core/plan/plan.h"

namespace airlight {

// Objects that outlive a run.
struct Machinery {
  const Device& device;
  PipelineCache& pipelines;
  ResourceCache& cache;
  Frame& frame;
  VkSampler sampler;
  bool teams;
  const StoredTables& tables;
};

// Executor::run() for a plan that is already checked.
RunResult run_plan(const Machinery& machinery, const Plan& plan, const std::function<void(double)>& report);

}  // namespace airlight
