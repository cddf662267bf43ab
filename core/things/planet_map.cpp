#include "core/things/planet_map.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace airlight {
namespace {

std::size_t at(int row, int column, int columns, int channels, int c) {
  return (static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(column)) *
             static_cast<std::size_t>(channels) +
         static_cast<std::size_t>(c);
}

// Share of the sphere between the north pole and a row coordinate.
double area_above(double row, int rows) {
  return 0.5 * (1.0 - std::cos(std::numbers::pi * row / rows));
}

// The part of texel k of `from` within texel i of `to`, as its low and high end in texels of `from`.
struct Overlap {
  double low;
  double high;
};

Overlap overlap(int i, int to, int k, int from) {
  const double scale = static_cast<double>(from) / to;
  return {std::max(i * scale, static_cast<double>(k)), std::min((i + 1) * scale, k + 1.0)};
}

int first_of(int i, int to, int from) {
  return static_cast<int>(static_cast<long long>(i) * from / to);
}

int last_of(int i, int to, int from) {
  return static_cast<int>((static_cast<long long>(i + 1) * from + to - 1) / to) - 1;
}

// Averages each row over as many columns as are as wide on the planet as the row is high.
void spread_toward_poles(PlanetLevel& level, int channels) {
  const int columns = 2 * level.rows;
  std::vector<double> sums(static_cast<std::size_t>(columns) + 1);
  for (int j = 0; j < level.rows; ++j) {
    const double width =
        std::min(1.0 / std::sin(std::numbers::pi * (j + 0.5) / level.rows), static_cast<double>(columns));
    for (int c = 0; c < channels; ++c) {
      for (int i = 0; i < columns; ++i) {
        sums[static_cast<std::size_t>(i) + 1] =
            sums[static_cast<std::size_t>(i)] + static_cast<double>(level.values[at(j, i, columns, channels, c)]);
      }
      // Integral of the row from its start to x columns, also over more than one turn.
      const auto up_to = [&](double x) {
        const double turns = std::floor(x / columns);
        const double rest = x - turns * columns;
        const auto k = std::min(static_cast<std::size_t>(rest), static_cast<std::size_t>(columns) - 1);
        return turns * sums.back() + sums[k] + (sums[k + 1] - sums[k]) * (rest - static_cast<double>(k));
      };
      for (int i = 0; i < columns; ++i) {
        level.values[at(j, i, columns, channels, c)] =
            static_cast<float>((up_to(i + 0.5 + 0.5 * width) - up_to(i + 0.5 - 0.5 * width)) / width);
      }
    }
  }
}

}  // namespace

PlanetLevel resampled(const PlanetLevel& picture, int rows, int channels) {
  PlanetLevel out{rows, std::vector<float>(at(rows, 0, 2 * rows, channels, 0))};
  const int columns = 2 * rows;
  for (int j = 0; j < rows; ++j) {
    const double area = area_above(j + 1.0, rows) - area_above(j, rows);
    for (int y = first_of(j, rows, picture.rows); y <= last_of(j, rows, picture.rows); ++y) {
      const Overlap down = overlap(j, rows, y, picture.rows);
      const double row_share = (area_above(down.high, picture.rows) - area_above(down.low, picture.rows)) / area;
      for (int i = 0; i < columns; ++i) {
        for (int x = first_of(i, rows, picture.rows); x <= last_of(i, rows, picture.rows); ++x) {
          const Overlap across = overlap(i, rows, x, picture.rows);
          const double share = row_share * (across.high - across.low) * rows / picture.rows;
          for (int c = 0; c < channels; ++c) {
            out.values[at(j, i, columns, channels, c)] +=
                static_cast<float>(share) * picture.values[at(y, x, 2 * picture.rows, channels, c)];
          }
        }
      }
    }
  }
  return out;
}

std::vector<PlanetLevel> planet_levels(PlanetLevel picture, int channels) {
  std::vector<PlanetLevel> levels;
  levels.push_back(std::move(picture));
  while (levels.back().rows > 1) {
    levels.push_back(resampled(levels.back(), levels.back().rows / 2, channels));
  }
  for (PlanetLevel& level : levels) {
    spread_toward_poles(level, channels);
  }
  return levels;
}

std::vector<double> planet_mean(const PlanetLevel& picture, int channels) {
  std::vector<double> mean(static_cast<std::size_t>(channels));
  const int columns = 2 * picture.rows;
  for (int j = 0; j < picture.rows; ++j) {
    const double share = (area_above(j + 1.0, picture.rows) - area_above(j, picture.rows)) / columns;
    for (int i = 0; i < columns; ++i) {
      for (int c = 0; c < channels; ++c) {
        mean[static_cast<std::size_t>(c)] +=
            share * static_cast<double>(picture.values[at(j, i, columns, channels, c)]);
      }
    }
  }
  return mean;
}

}  // namespace airlight
