#include "core/clouds/cloud_edge.h"

#include <algorithm>
#include <cmath>

#include "core/base/in_parallel.h"
#include "core/clouds/noise.h"
#include "core/gpu/kept_values.h"

namespace airlight {
namespace {

// A texel and the next, and how far a place lies beyond the first one's middle.
struct Texels {
  std::size_t low;
  std::size_t high;
  double share;
};

Texels texels_at(double x) {
  constexpr int kSide = CarvingNoise::kSide;
  const double place = (x - std::floor(x)) * kSide + (kSide - 0.5);
  const double low = std::floor(place);
  const int first = static_cast<int>(low) % kSide;
  return {static_cast<std::size_t>(first), static_cast<std::size_t>((first + 1) % kSide), place - low};
}

// Squares of the distance to strewn points: paraboloids, which meet in creases, of three sizes.
std::vector<float> made_noise() {
  constexpr int kLargestCells = 4;
  constexpr int kNoiseOctaves = 3;
  constexpr double kMost = 0.55;  // of the sum, which is less at 97 % of all places
  constexpr std::uint32_t kSeed = 2027;
  std::vector<StrewnPoints> octaves;
  for (int octave = 0; octave < kNoiseOctaves; ++octave) {
    const int cells = kLargestCells << octave;
    octaves.emplace_back(NoisePeriod{cells, cells, cells}, cells, kSeed + static_cast<std::uint32_t>(octave));
  }
  constexpr std::size_t kLayer = std::size_t{CarvingNoise::kSide} * CarvingNoise::kSide;
  std::vector<float> values(kLayer * CarvingNoise::kSide);
  in_parallel(CarvingNoise::kSide, [&](std::size_t level) {
    const int k = static_cast<int>(level);
    std::size_t at = level * kLayer;
    for (int j = 0; j < CarvingNoise::kSide; ++j) {
      for (int i = 0; i < CarvingNoise::kSide; ++i) {
        double sum = 0.0;
        double weight = 4.0 / 7.0;
        for (int octave = 0; octave < kNoiseOctaves; ++octave) {
          const double scale = static_cast<double>(kLargestCells << octave) / CarvingNoise::kSide;
          const double distance =
              octaves[static_cast<std::size_t>(octave)].noise((i + 0.5) * scale, (j + 0.5) * scale, (k + 0.5) * scale);
          sum += weight * distance * distance;
          weight *= 0.5;
        }
        values[at++] = static_cast<float>(std::min(sum / kMost, 1.0));
      }
    }
  });
  return values;
}

}  // namespace

double CarvingNoise::at(double x, double y, double z) const {
  constexpr std::size_t kRow = kSide;
  const Texels a = texels_at(x);
  const Texels b = texels_at(y);
  const Texels c = texels_at(z);
  const auto row = [&](std::size_t j, std::size_t k) {
    const float* texels = &values[kRow * (j + kRow * k)];
    const auto low = static_cast<double>(texels[a.low]);
    return low + a.share * (static_cast<double>(texels[a.high]) - low);
  };
  const auto level = [&](std::size_t k) {
    const double low = row(b.low, k);
    return low + b.share * (row(b.high, k) - low);
  };
  const double low = level(c.low);
  return low + c.share * (level(c.high) - low);
}

CarvingNoise carving_noise() {
  return {kept_floats("carving noise", made_noise)};
}

}  // namespace airlight
