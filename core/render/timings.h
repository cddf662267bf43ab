#pragma once
// Times of several plans of one picture.

#include <algorithm>
#include <vector>

#include "core/gpu/executor.h"

namespace airlight {

// Adds up times, one entry for each name; for PassTiming or Milestone.
template <class Timing>
void add_timings(std::vector<Timing>& all, const std::vector<Timing>& more) {
  for (const Timing& timing : more) {
    const auto same = [&](const Timing& other) { return other.name == timing.name; };
    const auto found = std::ranges::find_if(all, same);
    if (found == all.end()) {
      all.push_back(timing);
    } else {
      found->milliseconds += timing.milliseconds;
    }
  }
}

// The lists that collect the times of several runs.
struct Timings {
  std::vector<PassTiming>& passes;
  std::vector<Milestone>& host;

  void add(const RunResult& result) const {
    add_timings(passes, result.passes);
    add_timings(host, result.host);
  }
};

}  // namespace airlight
