#include "core/clouds/noise.h"

#include <algorithm>
#include <cmath>

namespace airlight {
namespace {

// A permutation of 32 bits (the finaliser of MurmurHash3).
std::uint32_t mixed_bits(std::uint32_t h) {
  h ^= h >> 16U;
  h *= 0x85ebca6bU;
  h ^= h >> 13U;
  h *= 0xc2b2ae35U;
  return h ^ (h >> 16U);
}

std::uint32_t wrapped(int i, int period) {
  const int rest = i % period;
  return static_cast<std::uint32_t>(rest < 0 ? rest + period : rest);
}

double fifth_order(double t) {
  return t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
}

double mix(double a, double b, double t) {
  return a + t * (b - a);
}

template <class Noise>
double octaves_of(Noise noise, double x, double y, double z, NoisePeriod period, int octaves, std::uint32_t seed) {
  double sum = 0.0;
  double weight = 1.0;
  double all = 0.0;
  for (int k = 0; k < octaves; ++k) {
    sum += weight * noise(x, y, z, period, seed + static_cast<std::uint32_t>(k));
    all += weight;
    weight *= 0.5;
    x *= 2.0;
    y *= 2.0;
    z *= 2.0;
    period = {2 * period.x, 2 * period.y, 2 * period.z};
  }
  return sum / all;
}

}  // namespace

double hashed(std::uint32_t x, std::uint32_t y, std::uint32_t z, std::uint32_t seed) {
  std::uint32_t h = mixed_bits(seed + 0x9e3779b9U);
  h = mixed_bits(h ^ (x + 0x7f4a7c15U));
  h = mixed_bits(h + (y ^ 0x94d049bbU));
  return static_cast<double>(mixed_bits(h ^ (z * 0x2545f491U + 0x1b873593U))) * 0x1p-32;
}

double value_noise(double x, double y, double z, NoisePeriod period, std::uint32_t seed) {
  const int i = static_cast<int>(std::floor(x));
  const int j = static_cast<int>(std::floor(y));
  const int k = static_cast<int>(std::floor(z));
  const double u = fifth_order(x - i);
  const double v = fifth_order(y - j);
  const auto corner = [&](int di, int dj, int dk) {
    return hashed(wrapped(i + di, period.x), wrapped(j + dj, period.y), static_cast<std::uint32_t>(k + dk), seed);
  };
  const auto level = [&](int dk) {
    return mix(mix(corner(0, 0, dk), corner(1, 0, dk), u), mix(corner(0, 1, dk), corner(1, 1, dk), u), v);
  };
  return mix(level(0), level(1), fifth_order(z - k));
}

double cell_noise(double x, double y, double z, NoisePeriod period, std::uint32_t seed) {
  const int i = static_cast<int>(std::floor(x));
  const int j = static_cast<int>(std::floor(y));
  const int k = static_cast<int>(std::floor(z));
  // The square of the distance to a neighbouring cell along one axis: no point of it is nearer.
  const auto gap = [](int d, double part) {
    const double away = d == 0 ? 0.0 : d < 0 ? part : 1.0 - part;
    return away * away;
  };
  double nearest = 1.0;
  for (const int dk : {0, -1, 1}) {
    for (const int dj : {0, -1, 1}) {
      for (const int di : {0, -1, 1}) {
        if (gap(di, x - i) + gap(dj, y - j) + gap(dk, z - k) >= nearest) {
          continue;
        }
        const std::uint32_t a = wrapped(i + di, period.x);
        const std::uint32_t b = wrapped(j + dj, period.y);
        const std::uint32_t c = period.z > 0 ? wrapped(k + dk, period.z) : static_cast<std::uint32_t>(k + dk);
        const double px = i + di + hashed(a, b, c, seed) - x;
        const double py = j + dj + hashed(a, b, c, seed + 0x51ed270bU) - y;
        const double pz = k + dk + hashed(a, b, c, seed + 0xa2f1c3d9U) - z;
        nearest = std::min(nearest, px * px + py * py + pz * pz);
      }
    }
  }
  return std::sqrt(nearest);
}

double value_octaves(double x, double y, double z, NoisePeriod period, int octaves, std::uint32_t seed) {
  return octaves_of(value_noise, x, y, z, period, octaves, seed);
}

double cell_octaves(double x, double y, double z, NoisePeriod period, int octaves, std::uint32_t seed) {
  return octaves_of(cell_noise, x, y, z, period, octaves, seed);
}

}  // namespace airlight
