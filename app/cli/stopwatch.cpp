#include "app/cli/stopwatch.h"

#include "core/base/clock.h"

namespace airlight::cli {
Stopwatch::Stopwatch() : wall_(Clock::now()), cpu_ms_(process_cpu_ms()) {
  laps_.push_back({"process start", cpu_ms_, cpu_ms_});
}

void Stopwatch::lap(const std::string& name) {
  const auto now = Clock::now();
  const double cpu = process_cpu_ms();
  laps_.push_back({name, milliseconds_between(wall_, now), cpu - cpu_ms_});
  wall_ = now;
  cpu_ms_ = cpu;
}

Lap Stopwatch::total() const {
  Lap sum{"total", 0.0, 0.0};
  for (const Lap& lap : laps_) {
    sum.wall_ms += lap.wall_ms;
    sum.cpu_ms += lap.cpu_ms;
  }
  return sum;
}

double peak_resident_mib() {
  rusage use{};
  getrusage(RUSAGE_SELF, &use);
  return static_cast<double>(use.ru_maxrss) / 1024.0;  // Linux counts in KiB
}

}  // namespace airlight::cli
