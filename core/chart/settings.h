#pragma once
// The contents of a chart and its accuracy: presets/chart.json, and the options that override it.

#include <string>
#include <string_view>
#include <vector>

#include "core/scene/scene.h"

namespace airlight::chart {

struct Settings {
  std::vector<std::string> scenes;  // built-in presets or files
  ImageSize image;                  // size at which pictures are timed
  int compared_columns = 48;        // the lattice of pixels at which the error is taken
  int compared_rows = 27;
  double truth_error = 0.001;  // mean relative standard error of the truth
};

// From JSON with exactly these keys: scenes, image, compared_pixels, truth_error. Throws InputError: file, line, key,
// what was expected.
Settings parse_settings(std::string_view text, std::string_view source);

}  // namespace airlight::chart
