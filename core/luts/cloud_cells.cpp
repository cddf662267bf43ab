#include "core/luts/cloud_cells.h"

#include <algorithm>
#include <cmath>

#include "core/base/in_parallel.h"

namespace airlight {
namespace {

// Shares of the fine cells in each coarse one along one axis.
struct Share {
  std::uint32_t from;
  std::uint32_t to;
  double share;  // of the coarse cell
};

std::vector<Share> shares_of(std::uint32_t fine, std::uint32_t coarse) {
  std::vector<Share> shares;
  const double width = static_cast<double>(fine) / coarse;
  for (std::uint32_t c = 0; c < coarse; ++c) {
    for (auto f = static_cast<std::uint32_t>(c * width); f < fine && f < (c + 1) * width - 1e-9; ++f) {
      const double length = std::min<double>(f + 1, (c + 1) * width) - std::max<double>(f, c * width);
      shares.push_back({f, c, length / width});
    }
  }
  return shares;
}

// What lies along one axis: `count` values, `stride` apart; `repeats`: the last is next to the first.
struct Axis {
  std::size_t stride;
  std::uint32_t count;
  bool repeats;
};

std::array<Axis, 3> axes_of(const CloudCells& cells) {
  return {{{1, cells.nx, true}, {cells.nx, cells.ny, true}, {std::size_t{cells.nx} * cells.ny, cells.nz, false}}};
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

CloudCells means_between(const CloudCells& cells) {
  constexpr float kNear = 0.125F;  // a neighbour's share
  CloudCells out = cells;
  for (const Axis& axis : axes_of(cells)) {
    const std::vector<float> before = out.extinction;
    for_each_line(cells, axis, [&](std::size_t first) {
      for (std::uint32_t i = 0; i < axis.count; ++i) {
        const std::uint32_t low = i > 0 ? i - 1 : (axis.repeats ? axis.count - 1 : 0);
        const std::uint32_t high = i + 1 < axis.count ? i + 1 : (axis.repeats ? 0 : i);
        const float sides = before[first + low * axis.stride] + before[first + high * axis.stride];
        const std::size_t at = first + i * axis.stride;
        out.extinction[at] = (1.0F - 2.0F * kNear) * before[at] + kNear * sides;
      }
    });
  }
  return out;
}

CloudCells coarsened(const CloudCells& cells, std::uint32_t most_x, std::uint32_t most_y, std::uint32_t most_z) {
  CloudCells out;
  out.nx = std::min(cells.nx, most_x);
  out.ny = std::min(cells.ny, most_y);
  out.nz = std::min(cells.nz, most_z);
  out.cell_x = cells.cell_x * cells.nx / out.nx;
  out.cell_y = cells.cell_y * cells.ny / out.ny;
  out.cell_z = cells.cell_z * cells.nz / out.nz;
  out.extinction.resize(out.count());
  const std::vector<Share> x = shares_of(cells.nx, out.nx);
  const std::vector<Share> y = shares_of(cells.ny, out.ny);
  const std::vector<Share> z = shares_of(cells.nz, out.nz);
  in_parallel(std::size_t{out.ny} * out.nz, [&](std::size_t line) {
    std::vector<double> sums(out.nx, 0.0);
    for (const Share& c : z) {
      if (c.to != line / out.ny) continue;
      for (const Share& b : y) {
        if (b.to != line % out.ny) continue;
        const float* row = &cells.extinction[(std::size_t{c.from} * cells.ny + b.from) * cells.nx];
        for (const Share& a : x) sums[a.to] += a.share * b.share * c.share * row[a.from];
      }
    }
    std::ranges::transform(sums, &out.extinction[line * out.nx], [](double sum) { return static_cast<float>(sum); });
  });
  return out;
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
