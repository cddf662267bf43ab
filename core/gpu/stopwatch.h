#pragma once

#include "core/clock.h"

namespace airlight {

class Stopwatch {
 public:
  // Milliseconds since the last lap.
  double lap() {
    const auto now = Clock::now();
    const double elapsed = milliseconds_between(start_, now);
    start_ = now;
    return elapsed;
  }

 private:
  Clock::time_point start_ = Clock::now();
};

}  // namespace airlight
