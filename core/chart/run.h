#pragma once
// Every method at every quality of its list on every scene, timed and compared with the truth.

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "core/chart/points.h"
#include "core/chart/settings.h"
#include "core/chart/timing.h"
#include "core/render/render.h"

namespace airlight::chart {

struct NamedScene {
  std::string name;
  Scene scene;  // of the size at which it is timed
};

struct RunOrder {
  std::vector<NamedScene> scenes;
  std::vector<std::string> methods;  // of the registry
  Settings settings;                 // lattice and truth
  double budget_s = 0.0;             // 0: no limit; at most half of it goes to the truth
  std::filesystem::path truth_folder;
  std::vector<Point> known;  // points of an earlier run, kept where their key is still the same
  std::string version;       // of airlight
  // Opens a fresh device. Each method of each scene gets one, so that its first picture really is the first.
  std::function<std::unique_ptr<Executor>()> open_device;
  std::function<bool(double done)> progress;            // 0 to 1
  std::function<void(const std::vector<Point>&)> keep;  // after each new point: all so far
};

struct RunOutcome {
  std::vector<Point> points;
  std::vector<std::string> left_out;  // "SCENE METHOD QUALITY", omitted for want of time
  std::size_t resumed = 0;            // points taken over from an earlier run
  DeviceInfo device;
  bool cpu_time = false;  // Point::time_ms is the process's CPU time, not the device's
};

RunOutcome run_chart(const RunOrder& order);

}  // namespace airlight::chart
