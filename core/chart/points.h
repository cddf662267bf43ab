#pragma once
// The data of the chart: one point a method, quality and scene. It is plain data and pure functions; nothing here
// renders.

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace airlight::chart {

inline constexpr std::string_view kAllScenes = "all";

struct Point {
  std::string scene;         // as the user named the preset; kAllScenes: the geometric mean over the scenes
  std::string method;        // of the registry
  std::string quality;       // its label
  double time_ms = 0.0;      // for a picture whose tables are there; cpu_ms or device_ms, whichever the chart shows
  double error_mean = 0.0;   // mean relative error, 1
  double error_p95 = 0.0;    // 95th percentile of the relative error, 1
  double floor = 0.0;        // the truth's own mean standard error / radiance, 1
  double cpu_ms = 0.0;       // of the process, all threads
  double device_ms = 0.0;    // by device timestamps; by the clock for a method on the host
  double tables_ms = 0.0;    // tables that are kept from picture to picture, by device timestamps
  double first_ms = 0.0;     // excess of the first picture over a later one: shaders compiled, tables, memory
  int runs = 0;              // timed runs; the figures are their medians
  double share_timed = 1.0;  // of the picture's pixels; below 1 the times are scaled up
  bool frontier = false;     // nothing in its scene is both as fast and as accurate
  std::string key;           // hash of all that the figures depend on; empty for kAllScenes
};

// Sets `frontier` scene by scene. Of points with an equal time only the most accurate one is on it.
void mark_frontier(std::vector<Point>& points);

// One point of kAllScenes for each method and quality with a point in every scene: geometric means of times, errors and
// floors. An error of 0 counts as 1e-9.
std::vector<Point> over_all_scenes(const std::vector<Point>& points);

// Sorts by scene in the order given (others after them, kAllScenes last), then by time.
void sort_points(std::vector<Point>& points, const std::vector<std::string>& scenes);

// The table with a line of headings; reading it back gives the same points.
std::string csv_text(const std::vector<Point>& points);

// Throws InputError with the line where the text is no table of csv_text()'s. `name` is the file, for the message.
std::vector<Point> read_csv(const std::string& text, const std::string& name);

}  // namespace airlight::chart
