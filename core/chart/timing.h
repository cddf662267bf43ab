#pragma once
// One method at one quality, timed on a device.

#include <map>
#include <string>
#include <vector>

#include "core/chart/pixels.h"
#include "core/gpu/executor.h"
#include "core/render/tile_sizes.h"
#include "core/scene/scene.h"

namespace airlight::chart {

struct TimingRules {
  int most_runs = 15;     // timed runs, after the first
  int fewest_runs = 3;    // least number of them; 1 where a picture takes longer than `long_s`
  double enough_s = 0.4;  // time of all timed runs after which no further one starts
  double long_s = 1.0;
  // A GPU renders the picture for so long before it is timed: its clock rises while it is busy.
  double warm_s = 0.3;
  std::size_t tile_bytes = kTileBytes;  // a picture with more is rendered in tiles of whole rows
};

struct Timing {
  double cpu_ms = 0.0;     // of the process, all its threads, for a picture whose tables are there; median
  double device_ms = 0.0;  // the same by device timestamps; by the clock for a method on the host
  double tables_ms = 0.0;  // tables that are kept from picture to picture
  double wall_ms = 0.0;    // one such run, by the clock; median
  double first_ms = 0.0;   // by how much the first picture took longer than a later one, by the clock
  int runs = 0;
  double share = 1.0;         // computed share of the picture's pixels; the times are scaled up
  std::vector<float> pixels;  // RGB of the pixels asked for
};

// Cost of tables by all that they depend on, since most of a method's qualities share their tables.
using TableTimes = std::map<std::string, double>;

// Times the stage's method on the device: sky passes alone, without disc, statistics and bloom.
Timing time_on_device(Executor& executor, const Stage& stage, const PixelSet& pixels, const TimingRules& rules,
                      TableTimes& tables);

// Times the stage's method on the host, once, for the listed pixels alone.
Timing time_on_host(const Stage& stage, const PixelSet& pixels);

double median(std::vector<double> values);  // of at least one

}  // namespace airlight::chart
