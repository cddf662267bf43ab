#pragma once
// Clocks: elapsed time and CPU time.

#include <sys/resource.h>

#include <chrono>

namespace airlight {

using Clock = std::chrono::steady_clock;

inline double milliseconds_between(Clock::time_point start, Clock::time_point end) {
  return std::chrono::duration<double, std::milli>(end - start).count();
}

inline double milliseconds_since(Clock::time_point start) {
  return milliseconds_between(start, Clock::now());
}

inline double seconds_since(Clock::time_point start) {
  return 1e-3 * milliseconds_since(start);
}

// CPU time of this process so far, all threads.
inline double process_cpu_ms() {
  rusage use{};
  getrusage(RUSAGE_SELF, &use);
  const auto ms = [](const timeval& time) {
    return 1e3 * static_cast<double>(time.tv_sec) + 1e-3 * static_cast<double>(time.tv_usec);
  };
  return ms(use.ru_utime) + ms(use.ru_stime);
}

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
