#pragma once
// The benchmarks, registered with Google Benchmark. The time of each is the sum of its passes' device timestamps.

#include <optional>

#include "core/gpu/executor.h"

namespace airlight::bench {

// The devices' state, opened on first use. `failed`: a benchmark could not run.
class Session {
 public:
  Executor& pictures();  // keeps tables, like the tool
  Executor& tables();    // keeps no tables but those that the plan names
  bool failed = false;

 private:
  std::optional<Executor> pictures_;
  std::optional<Executor> tables_;
};

// For every method of the device:
//   air/METHOD-WAY/SCENE/SIZE   the air before things all over the picture, by march or volume (made for each picture)
//   sky/METHOD/SCENE/SIZE   sky, disc and statistics of one picture; the tables are there already
//   frame/METHOD/SCENE/SIZE the same with bloom and the tone curve, for the first scene
//   tables/METHOD/SCENE     every table from nothing, for each different air
void register_benchmarks(Session& session);

}  // namespace airlight::bench
