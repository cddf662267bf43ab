#pragma once
// Where a run's time goes: every stretch between two laps has a name, and nothing is left unnamed.

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
  // The first lap, "process start", is what the process took before main: CPU time, as it is spent linking libraries.
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
