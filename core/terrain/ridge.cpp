#include "core/terrain/ridge.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace airlight {
namespace {

// -1 to 1, of a corner of the grid (the finalizer of MurmurHash3).
double corner(std::uint32_t seed, int x, int y, int octave) {
  std::uint32_t n = seed * 0x9E3779B9U + static_cast<std::uint32_t>(x) * 0x85EBCA6BU +
                    static_cast<std::uint32_t>(y) * 0xC2B2AE35U + static_cast<std::uint32_t>(octave) * 0x27D4EB2FU;
  n = (n ^ (n >> 16U)) * 0x85EBCA6BU;
  n = (n ^ (n >> 13U)) * 0xC2B2AE35U;
  n ^= n >> 16U;
  return static_cast<double>(n) / 2147483647.5 - 1.0;
}

double fade(double x) {
  return x * x * x * (x * (x * 6.0 - 15.0) + 10.0);
}

double noise(std::uint32_t seed, double x, double y, int octave) {
  const int i = static_cast<int>(std::floor(x));
  const int j = static_cast<int>(std::floor(y));
  const double u = fade(x - i);
  const double v = fade(y - j);
  const double upper = std::lerp(corner(seed, i, j, octave), corner(seed, i + 1, j, octave), u);
  const double lower = std::lerp(corner(seed, i, j + 1, octave), corner(seed, i + 1, j + 1, octave), u);
  return std::lerp(upper, lower, v);
}

// Ridged noise: sharp where each octave changes its sign, rough where the ones before are high. About 0 to 1.
double ridged(std::uint32_t seed, double x, double y) {
  constexpr int kOctaves = 8;
  double sum = 0.0;
  double weight = 1.0;
  double strength = 0.5;
  for (int octave = 0; octave < kOctaves; ++octave) {
    const double crest = 1.0 - std::abs(noise(seed, x, y, octave));
    sum += crest * crest * weight * strength;
    weight = std::clamp(1.6 * crest * crest, 0.0, 1.0);
    strength *= 0.5;
    x = 2.03 * x + 17.7;
    y = 1.97 * y - 5.1;
  }
  return sum;
}

double smooth(double x) {
  const double t = std::clamp(x, 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

}  // namespace

std::vector<double> ridge_heights(const Ridge& ridge) {
  constexpr double kFeatures = 9.0;  // of the coarsest octave along the range
  const auto seed = static_cast<std::uint32_t>(ridge.seed);
  std::vector<double> heights;
  heights.reserve(static_cast<std::size_t>(kRidgeColumns) * static_cast<std::size_t>(kRidgeRows));
  for (int row = 0; row < kRidgeRows; ++row) {
    for (int column = 0; column < kRidgeColumns; ++column) {
      const double x = static_cast<double>(column) / (kRidgeColumns - 1);
      const double y = static_cast<double>(row) / (kRidgeRows - 1);
      const double crest = 0.5 + 0.12 * noise(seed, 3.0 * x, 0.5, 31);
      const double across = std::abs(y - crest) / (y < crest ? crest : 1.0 - crest);
      const double flank = std::pow(std::max(1.0 - across, 0.0), 1.3);
      const double ends = smooth(8.0 * x) * smooth(8.0 * (1.0 - x));
      const double peaks = 0.25 + ridged(seed, kFeatures * x, 0.5 * kFeatures * y);
      heights.push_back(flank * ends * peaks);
    }
  }
  const double highest = *std::max_element(heights.begin(), heights.end());
  for (double& h : heights) {
    h *= ridge.height / highest;
  }
  return heights;
}

}  // namespace airlight
