#include "core/clouds/noise.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

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

namespace {

struct PlaceInCell {
  double x;
  double y;
  double z;
};

PlaceInCell point_in(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t seed) {
  return {hashed(a, b, c, seed), hashed(a, b, c, seed + 0x51ed270bU), hashed(a, b, c, seed + 0xa2f1c3d9U)};
}

// Along one axis: a place's cell and those before and after it.
struct CellsAround {
  // `cell_of(i)`: what point_of() below is told of cell i.
  template <class CellOf>
  CellsAround(double x, const CellOf& cell_of) {
    const int i = static_cast<int>(std::floor(x));
    const double part = x - i;
    cells = {cell_of(i), cell_of(i - 1), cell_of(i + 1)};
    starts = {i - x, i - 1 - x, i + 1 - x};
    gaps = {0.0, part * part, (1.0 - part) * (1.0 - part)};
  }
  std::array<std::size_t, 3> cells;
  std::array<double, 3> starts;  // from the place
  std::array<double, 3> gaps;    // the square of the distance: no point of the cell is nearer
};

// Distance to the nearest point, at most 1. `point_of(a, b, c)`: where the point of a cell is in it.
template <class PointOf>
double nearest_of(const CellsAround& x, const CellsAround& y, const CellsAround& z, const PointOf& point_of) {
  double nearest = 1.0;
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t j = 0; j < 3; ++j) {
      for (std::size_t i = 0; i < 3; ++i) {
        if (x.gaps[i] + y.gaps[j] + z.gaps[k] >= nearest) {
          continue;
        }
        const auto point = point_of(x.cells[i], y.cells[j], z.cells[k]);
        const double px = x.starts[i] + point.x;
        const double py = y.starts[j] + point.y;
        const double pz = z.starts[k] + point.z;
        nearest = std::min(nearest, px * px + py * py + pz * pz);
      }
    }
  }
  return std::sqrt(nearest);
}

}  // namespace

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
  const auto across = [](int count) { return [count](int i) { return std::size_t{wrapped(i, count)}; }; };
  const auto up = [&](int k) {
    return std::size_t{period.z > 0 ? wrapped(k, period.z) : static_cast<std::uint32_t>(k)};
  };
  return nearest_of(CellsAround(x, across(period.x)), CellsAround(y, across(period.y)), CellsAround(z, up),
                    [seed](std::size_t a, std::size_t b, std::size_t c) {
                      return point_in(static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b),
                                      static_cast<std::uint32_t>(c), seed);
                    });
}

double value_octaves(double x, double y, double z, NoisePeriod period, int octaves, std::uint32_t seed) {
  return octaves_of(value_noise, x, y, z, period, octaves, seed);
}

double cell_octaves(double x, double y, double z, NoisePeriod period, int octaves, std::uint32_t seed) {
  return octaves_of(cell_noise, x, y, z, period, octaves, seed);
}

StrewnPoints::StrewnPoints(NoisePeriod period, double most_z, std::uint32_t seed) : period_(period), seed_(seed) {
  constexpr double kMost = 2e6;  // points
  const double layers = period.z > 0 ? period.z : std::floor(most_z) + 3.0;
  if (layers * period.x * period.y > kMost) {
    return;
  }
  layers_ = static_cast<int>(layers);
  points_.reserve(static_cast<std::size_t>(layers_) * static_cast<std::size_t>(period.x) *
                  static_cast<std::size_t>(period.y));
  for (int k = 0; k < layers_; ++k) {
    const auto c = static_cast<std::uint32_t>(period.z > 0 ? k : k - 1);
    for (int j = 0; j < period.y; ++j) {
      for (int i = 0; i < period.x; ++i) {
        const PlaceInCell place = point_in(static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j), c, seed);
        points_.push_back({place.x, place.y, place.z});
      }
    }
  }
}

double StrewnPoints::noise(double x, double y, double z) const {
  if (layers_ == 0) {
    return cell_noise(x, y, z, period_, seed_);
  }
  const auto row = static_cast<std::size_t>(period_.x);
  const auto layer = row * static_cast<std::size_t>(period_.y);
  return nearest_of(CellsAround(x, [&](int i) { return std::size_t{wrapped(i, period_.x)}; }),
                    CellsAround(y, [&](int j) { return row * wrapped(j, period_.y); }),
                    CellsAround(z,
                                [&](int k) {
                                  return layer * (period_.z > 0
                                                      ? wrapped(k, period_.z)
                                                      : static_cast<std::size_t>(std::min(k + 1, layers_ - 1)));
                                }),
                    [this](std::size_t a, std::size_t b, std::size_t c) { return points_[a + b + c]; });
}

CellOctaves::CellOctaves(NoisePeriod period, double most_z, int octaves, std::uint32_t seed) {
  for (int k = 0; k < octaves; ++k) {
    octaves_.emplace_back(period, most_z, seed + static_cast<std::uint32_t>(k));
    most_z *= 2.0;
    period = {2 * period.x, 2 * period.y, 2 * period.z};
  }
}

double CellOctaves::at(double x, double y, double z) const {
  double sum = 0.0;
  double weight = 1.0;
  double all = 0.0;
  for (const StrewnPoints& octave : octaves_) {
    sum += weight * octave.noise(x, y, z);
    all += weight;
    weight *= 0.5;
    x *= 2.0;
    y *= 2.0;
    z *= 2.0;
  }
  return sum / all;
}

}  // namespace airlight
