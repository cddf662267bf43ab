#pragma once
// Times of passes that several plans of one picture have run.

#include <algorithm>
#include <vector>

#include "core/gpu/executor.h"

namespace airlight {

// Each pass once, with the sum of its times.
inline void add_timings(std::vector<PassTiming>& all, const std::vector<PassTiming>& more) {
  for (const PassTiming& timing : more) {
    const auto same = [&](const PassTiming& other) { return other.name == timing.name; };
    const auto found = std::find_if(all.begin(), all.end(), same);
    if (found == all.end()) {
      all.push_back(timing);
    } else {
      found->milliseconds += timing.milliseconds;
    }
  }
}

}  // namespace airlight
