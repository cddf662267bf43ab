#include "app/cli/stopwatch.h"

#include <sys/resource.h>

namespace airlight::cli {
namespace {

double milliseconds(const timeval& time) {
  return 1e3 * static_cast<double>(time.tv_sec) + 1e-3 * static_cast<double>(time.tv_usec);
}

double process_cpu_ms() {
  rusage use{};
  getrusage(RUSAGE_SELF, &use);
  return milliseconds(use.ru_utime) + milliseconds(use.ru_stime);
}

}  // namespace

Stopwatch::Stopwatch() : wall_(std::chrono::steady_clock::now()), cpu_ms_(process_cpu_ms()) {
  laps_.push_back({"process start", cpu_ms_, cpu_ms_});
}

void Stopwatch::lap(const std::string& name) {
  const auto now = std::chrono::steady_clock::now();
  const double cpu = process_cpu_ms();
  laps_.push_back({name, std::chrono::duration<double, std::milli>(now - wall_).count(), cpu - cpu_ms_});
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
