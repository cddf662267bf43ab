#include "core/luts/cloud_cells.h"

#include <algorithm>
#include <array>

#include "core/base/in_parallel.h"

namespace airlight {
namespace {

// What lies along one axis: `count` values, `stride` apart; `repeats`: the last is next to the first.
struct Axis {
  std::size_t stride;
  std::uint32_t count;
  bool repeats;
};

std::array<Axis, 3> axes_of(const CloudCells& cells) {
  return {{{1, cells.nx, true}, {cells.nx, cells.ny, true}, {std::size_t{cells.nx} * cells.ny, cells.nz, false}}};
}

// Shares of the fine cells' values in each coarse one along one axis.
struct Share {
  std::uint32_t from;
  std::uint32_t to;
  double share;  // of the coarse cell
};

std::vector<Share> shares_of(const Axis& axis, std::uint32_t coarse, CellValues values) {
  constexpr double kNear = 0.125;  // a neighbour's share in the mean over a cell
  const double width = static_cast<double>(axis.count) / coarse;
  std::vector<Share> shares;
  for (std::uint32_t c = 0; c < coarse; ++c) {
    std::vector<double> weights(axis.count, 0.0);
    for (auto f = static_cast<std::uint32_t>(c * width); f < axis.count && f < (c + 1) * width - 1e-9; ++f) {
      const double length = std::min<double>(f + 1, (c + 1) * width) - std::max<double>(f, c * width);
      const double near = values == CellValues::middles ? kNear * length / width : 0.0;
      weights[f] += length / width - 2.0 * near;
      weights[f > 0 ? f - 1 : (axis.repeats ? axis.count - 1 : 0)] += near;
      weights[f + 1 < axis.count ? f + 1 : (axis.repeats ? 0 : f)] += near;
    }
    for (std::uint32_t f = 0; f < axis.count; ++f) {
      if (weights[f] > 0.0) shares.push_back({f, c, weights[f]});
    }
  }
  return shares;
}

// Calls line(at) for the first value of every line along the axis.
template <class Line>
void for_each_line(const CloudCells& cells, const Axis& axis, const Line& line) {
  constexpr std::size_t kTasks = 64;
  const std::size_t lines = cells.count() / axis.count;
  in_parallel(kTasks, [&](std::size_t task) {
    for (std::size_t n = task * lines / kTasks; n < (task + 1) * lines / kTasks; ++n) {
      line(n / axis.stride * axis.stride * axis.count + n % axis.stride);
    }
  });
}

}  // namespace

CloudCells coarse_shape(const CloudCells& cells, std::uint32_t most_x, std::uint32_t most_y, std::uint32_t most_z) {
  CloudCells out;
  out.nx = std::min(cells.nx, most_x);
  out.ny = std::min(cells.ny, most_y);
  out.nz = std::min(cells.nz, most_z);
  out.cell_x = cells.cell_x * cells.nx / out.nx;
  out.cell_y = cells.cell_y * cells.ny / out.ny;
  out.cell_z = cells.cell_z * cells.nz / out.nz;
  return out;
}

CloudCells coarsened(const CloudCells& cells, std::uint32_t most_x, std::uint32_t most_y, std::uint32_t most_z,
                     CellValues values) {
  CloudCells out = coarse_shape(cells, most_x, most_y, most_z);
  out.extinction.resize(out.count());
  const auto axes = axes_of(cells);
  const std::vector<Share> x = shares_of(axes[0], out.nx, values);
  const std::vector<Share> y = shares_of(axes[1], out.ny, values);
  const std::vector<Share> z = shares_of(axes[2], out.nz, values);
  in_parallel(std::size_t{out.ny} * out.nz, [&](std::size_t line) {
    std::vector<double> sums(out.nx, 0.0);
    for (const Share& c : z) {
      if (c.to != line / out.ny) continue;
      for (const Share& b : y) {
        if (b.to != line % out.ny) continue;
        const float* row = &cells.extinction[(std::size_t{c.from} * cells.ny + b.from) * cells.nx];
        for (const Share& a : x) sums[a.to] += a.share * b.share * c.share * static_cast<double>(row[a.from]);
      }
    }
    std::ranges::transform(sums, &out.extinction[line * out.nx], [](double sum) { return static_cast<float>(sum); });
  });
  return out;
}

CloudCells with_lumps(CloudCells coarse, CloudCells fine, CellValues values) {
  constexpr double kLumps = 0.02;  // chosen by pictures (core/CLOUDS.md)
  std::ranges::transform(fine.extinction, fine.extinction.begin(), [](float value) { return value * value; });
  const CloudCells squares = coarsened(fine, coarse.nx, coarse.ny, coarse.nz, values);
  const auto lumpy = [](double mean, double square) {
    const double variance = mean > 0.0 ? std::max(square / (mean * mean) - 1.0, 0.0) : 0.0;
    return static_cast<float>(mean / (1.0 + kLumps * variance));
  };
  std::ranges::transform(coarse.extinction, squares.extinction, coarse.extinction.begin(), lumpy);
  return coarse;
}

// The steps are the largest of the three distances along the axes, so each axis is searched by itself.
std::vector<float> gaps_of(const CloudCells& cells) {
  constexpr float kMost = 64.0F;
  std::vector<float> gaps(cells.count());
  std::ranges::transform(cells.extinction, gaps.begin(), [](float water) { return water > 0.0F ? 0.0F : kMost; });
  for (const Axis& axis : axes_of(cells)) {
    for_each_line(cells, axis, [&](std::size_t first) {
      const auto count = static_cast<int>(axis.count);
      std::vector<float> before(axis.count);
      for (std::size_t i = 0; i < axis.count; ++i) before[i] = gaps[first + i * axis.stride];
      const float least = std::ranges::min(before);
      const auto at = [&](int i) {
        const int inside = axis.repeats ? (i % count + count) % count : std::clamp(i, 0, count - 1);
        return before[static_cast<std::size_t>(inside)];
      };
      for (int i = 0; i < count; ++i) {
        float gap = at(i);
        for (int step = 1; gap > least && static_cast<float>(step) < gap; ++step) {
          gap = std::min(gap, std::max(static_cast<float>(step), std::min(at(i - step), at(i + step))));
        }
        gaps[first + static_cast<std::size_t>(i) * axis.stride] = gap;
      }
    });
  }
  return gaps;
}

}  // namespace airlight
