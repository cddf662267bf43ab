#pragma once
// Comparison of two EXR files: a request and a report, both plain data.

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "core/measure/metrics.h"
#include "core/measure/preset_difference.h"
#include "core/measure/shown_pictures.h"

namespace airlight::measure {

// Limits on the absolute difference of any channel, like idiff's, or on the difference in standard errors where those
// are given. An absent limit is not judged.
struct Limits {
  std::optional<double> fail;       // a pixel fails above it
  double fail_percent = 0.0;        // share of pixels that may fail
  std::optional<double> hard_fail;  // no pixel may exceed it
  std::optional<double> warn;
  double warn_percent = 0.0;
  std::optional<double> hard_warn;
  std::optional<double> relative_mean;  // of the colour channels pooled, over the whole picture
  std::optional<double> relative_p95;
  std::optional<double> relative_max;
  std::optional<double> chi_square;  // per value, colour channels pooled; needs a standard error
};

struct ComparisonRequest {
  std::string a;
  std::string b;                             // the reference
  std::vector<std::string> standard_errors;  // files; several add in quadrature
  std::string standard_error_layer;          // empty: the layer named like a standard error, else the main picture
  std::string layer;                         // empty: the main picture
  std::vector<std::string> channels;         // empty: all of the layer
  std::string view_preset;                   // resolved preset that says where pixels look; empty: the files' own
  std::string version;                       // of the program that compares; empty: not told
  bool allow_nonfinite = false;
  Limits limits;
  bool heatmap = false;  // draw one
  bool side_by_side = false;
  std::optional<double> heatmap_max;  // the scale's top; absent: from the picture
  std::size_t shown_pixels = 0;       // most pixels of each picture to return for a page
};

struct PixelReport {
  int x = 0;  // from the upper left corner of the whole picture
  int y = 0;
  double a = 0.0;
  double b = 0.0;
  std::string channel;
  std::optional<double> elevation_deg;
  std::optional<double> azimuth_deg;
};

struct ChannelReport {
  std::string name;  // as in the file, or "luminance", or "pooled": the colour channels together
  ErrorSummary absolute;
  ErrorSummary relative;
  std::optional<ErrorSummary> sigma;
  std::optional<ChiSquare> chi_square;
  Deviation deviation;
  std::size_t over_fail = 0;
  std::size_t over_warn = 0;
  PixelReport worst_absolute;
  PixelReport worst_relative;
};

struct AreaReport {
  std::string name;  // "picture", or a region's
  std::size_t pixels = 0;
  std::vector<ChannelReport> channels;
};

struct NonfiniteCount {
  std::string channel;
  std::size_t nan_a = 0, infinite_a = 0;
  std::size_t nan_b = 0, infinite_b = 0;
};

// The first value of a picture that is NaN or infinite, row by row.
struct NonfinitePlace {
  int x = 0;  // from the upper left corner of the whole picture
  int y = 0;
  std::string channel;
};

// A limit in force, in words, and the value measured against it.
struct LimitCheck {
  std::string limit;     // "mean relative error (--rel-mean)"
  std::string allowed;   // "0.005"
  std::string measured;  // "0.0123"
  bool holds = true;
  bool only_warns = false;
  std::string reason;  // if the limit does not hold: a line that says so
};

enum class Verdict { pass, warn, differ, cannot_compare };

struct ComparisonReport {
  Verdict verdict = Verdict::cannot_compare;
  std::string problem;               // reason why the files cannot be compared; one line
  std::vector<std::string> reasons;  // what failed or warned, a line each
  std::vector<LimitCheck> checks;    // every limit in force
  std::vector<std::string> notes;    // further information
  int width = 0;
  int height = 0;
  std::vector<std::string> channels;
  bool presets_known = false;  // both files carry one
  std::vector<KeyDifference> preset_keys;
  std::vector<NonfiniteCount> nonfinite;  // channels with at least one
  std::optional<NonfinitePlace> first_nonfinite_a, first_nonfinite_b;
  std::size_t unequal_nonfinite = 0;  // pixels
  std::size_t pixels = 0;
  std::size_t pixels_over_fail = 0;
  std::size_t pixels_over_warn = 0;
  double largest = std::numeric_limits<double>::quiet_NaN();  // absolute, or in standard errors
  std::vector<AreaReport> areas;                              // the whole picture first
  std::vector<std::byte> heatmap_png;
  std::vector<std::byte> side_by_side_png;
  std::optional<ShownPictures> shown;
};

// Never throws: failures are in the report.
ComparisonReport compare(const ComparisonRequest& request);

}  // namespace airlight::measure
