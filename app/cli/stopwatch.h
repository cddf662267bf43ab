#pragma once
// The times of a run's stretches: each stretch between two laps has a name, and none is left out.

#include <chrono>
#include <string>
#include <vector>

namespace airlight::cli {

struct Lap {
  std::string name;
  double wall_ms = 0.0;
  double cpu_ms = 0.0;  // of all threads
};

class Stopwatch {
 public:
  // The first lap, "process start", is the CPU time that the process took before main, mostly for linking libraries.
  Stopwatch();

  // Ends the stretch that began with the previous lap.
  void lap(const std::string& name);

  const std::vector<Lap>& laps() const { return laps_; }
  Lap total() const;  // over all laps so far

 private:
  std::vector<Lap> laps_;
  std::chrono::steady_clock::time_point wall_;
  double cpu_ms_ = 0.0;
};

double peak_resident_mib();

}  // namespace airlight::cli
