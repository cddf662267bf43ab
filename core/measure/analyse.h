#pragma once
// Two pictures in memory -> every figure of the report, and the error of each pixel for a heat map.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/measure/compare.h"
#include "core/measure/luminance.h"
#include "core/measure/view_geometry.h"

namespace airlight::measure {

struct Plane {
  std::string name;
  std::vector<float> a;
  std::vector<float> b;
  std::vector<float> sigma;  // empty: none; then a difference is judged exactly
};

struct PicturePair {
  PixelFrame frame;
  std::vector<Plane> planes;
  std::array<double, 3> luminance_weights = airlight::measure::luminance_weights(kBt709);
  std::optional<Viewpoint> viewpoint;
  bool in_sigmas = false;  // limits and heat map are in standard errors
  NonfiniteRule nonfinite = NonfiniteRule::never_equal;
};

// R, G and B where the picture has all three, else every plane: what is pooled and shown.
std::vector<std::size_t> colour_planes(const std::vector<Plane>& planes);

// Fills sizes, counts and areas; the verdict is judge()'s. Returns for each pixel the largest relative error over the
// planes, or the largest distance in standard errors.
std::vector<float> analyse(const PicturePair& pair, const Limits& limits, ComparisonReport& report);

}  // namespace airlight::measure
