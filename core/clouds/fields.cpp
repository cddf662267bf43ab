// Fields of clouds by a seed. Each kind says how far inside the cloud a place lies; the level at which the cloud begins
// is then chosen so that just the share `cover` of all columns has some.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "core/base/in_parallel.h"
#include "core/clouds/carved_field.h"
#include "core/clouds/cloud_grid.h"
#include "core/clouds/noise.h"
#include "core/spectra/drops.h"

namespace airlight {
namespace {

double smooth_step(double low, double high, double x) {
  const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

// Values over the field's columns.
class ColumnMap {
 public:
  explicit ColumnMap(int side)
      : side_(side), values_(static_cast<std::size_t>(side) * static_cast<std::size_t>(side)) {}

  double& at(int i, int j) { return values_[place(i, j)]; }

  // Linear between the columns' middles, repeated; `x`, `y` in columns.
  double between(double x, double y) const {
    const double i = std::floor(x - 0.5);
    const double j = std::floor(y - 0.5);
    const double u = x - 0.5 - i;
    const double v = y - 0.5 - j;
    const auto value = [&](int di, int dj) {
      return values_[place(static_cast<int>(i) + di, static_cast<int>(j) + dj)];
    };
    const double low = value(0, 0) + u * (value(1, 0) - value(0, 0));
    const double high = value(0, 1) + u * (value(1, 1) - value(0, 1));
    return low + v * (high - low);
  }

  // Replaces each value by the share of columns below it, 0 to 1.
  void rank() {
    std::vector<std::size_t> order(values_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t k) { return values_[k]; });
    for (std::size_t k = 0; k < order.size(); ++k) {
      values_[order[k]] = (static_cast<double>(k) + 0.5) / static_cast<double>(order.size());
    }
  }

 private:
  std::size_t place(int i, int j) const {
    const auto wrap = [this](int n) { return static_cast<std::size_t>(((n % side_) + side_) % side_); };
    return wrap(i) + static_cast<std::size_t>(side_) * wrap(j);
  }
  int side_;
  std::vector<double> values_;
};

// A field's grid, and its cells' places.
class Field {
 public:
  explicit Field(const Cloud& cloud) : cloud_(cloud) {
    grid_.nx = grid_.ny = static_cast<int>(std::ceil(cloud.period / cloud.detail - 1e-9));
    // Two levels at least: a device's image of one is flat.
    grid_.nz = std::max(2, static_cast<int>(std::ceil((cloud.top - cloud.base) / cloud.detail - 1e-9)));
    grid_.cell_x = grid_.cell_y = cloud.period / grid_.nx;
    grid_.base = cloud.base;
    grid_.top = cloud.top;
    grid_.repeats = true;
    grid_.extinction.resize(static_cast<std::size_t>(grid_.nx) * static_cast<std::size_t>(grid_.ny) *
                            static_cast<std::size_t>(grid_.nz));
  }

  int side() const { return grid_.nx; }
  int levels() const { return grid_.nz; }
  double height() const { return cloud_.top - cloud_.base; }

  // Of noise whose cells are about so wide, km.
  NoisePeriod cells(double width) const {
    const int count = std::max(2, static_cast<int>(std::lround(cloud_.period / width)));
    return {count, count};
  }
  std::uint32_t seed(std::uint32_t of) const { return static_cast<std::uint32_t>(cloud_.seed) * 64U + of; }

  // A map of value(x, y), x and y as shares of the period.
  template <class Value>
  ColumnMap map(Value value) const {
    ColumnMap map(side());
    in_parallel(static_cast<std::size_t>(side()), [&](std::size_t row) {
      const int j = static_cast<int>(row);
      for (int i = 0; i < side(); ++i) {
        map.at(i, j) = value((i + 0.5) / side(), (j + 0.5) / side());
      }
    });
    return map;
  }

  // Fills the grid. `inside(x, y, z)`: how far inside the cloud the place is, x and y as shares of the period (moved
  // upwind by the shear), z of the height; below 0: outside for certain. `soft`: the depth over which the edge fades.
  template <class Inside>
  CloudGrid fill(Inside inside, double soft) && {
    finish(edge_of(fill_depths(inside)), soft);
    return std::move(grid_);
  }

  // Likewise with lobes finer than the grid (carved_field.h); depths go on below 0. The density rises evenly from
  // `low` at the base to 1 at the top.
  template <class Inside>
  CloudGrid carve(Inside inside, double low) && {
    const double edge = edge_of(fill_depths(inside));
    double most = 0.0;
    for (int k = 0; k < levels(); ++k) {
      const double z = (k + 0.5) / levels();
      for (std::size_t at = grid_.index(0, 0, k); at < grid_.index(0, 0, k + 1); ++at) {
        grid_.extinction[at] -= static_cast<float>(std::min(edge, 1e9));
        most = grid_.extinction[at] > 0.0F ? low + (1.0 - low) * z : most;
      }
    }
    const double top = most > 0.0 ? densest() / most : 0.0;
    const Carving carving{.tile = 0.6 * cloud_.cell,
                          .most = std::min(0.09 * cloud_.cell, 0.15 * height()),
                          .soft = 0.006 * cloud_.cell,
                          .gentlest = 0.8 / cloud_.cell};
    carve_field(grid_, cloud_.cover, low * top, top, carving);
    return std::move(grid_);
  }

 private:
  // Returns each column's greatest depth, 0 at least.
  template <class Inside>
  std::vector<float> fill_depths(Inside inside) {
    const double east = cloud_.shear * std::sin(cloud_.wind) / cloud_.period;
    const double north = cloud_.shear * std::cos(cloud_.wind) / cloud_.period;
    std::vector<float> deepest(static_cast<std::size_t>(side()) * static_cast<std::size_t>(side()));
    in_parallel(static_cast<std::size_t>(side()), [&](std::size_t row) {
      const int j = static_cast<int>(row);
      for (int k = 0; k < levels(); ++k) {
        const double z = (k + 0.5) / levels();
        for (int i = 0; i < side(); ++i) {
          const double depth = inside((i + 0.5) / side() - z * east, (j + 0.5) / side() - z * north, z);
          grid_.extinction[grid_.index(i, j, k)] = static_cast<float>(depth);
          float& most = deepest[grid_.index(i, j, 0)];
          most = std::max(most, static_cast<float>(depth));
        }
      }
    });
    return deepest;
  }

  double densest() const {
    return cloud_.kind == CloudKind::cirrus ? crystal_extinction(cloud_.water, cloud_.effective_radius)
                                            : drop_extinction(cloud_.water, cloud_.effective_radius);
  }

  // The depth that just the share `cover` of columns exceeds.
  double edge_of(std::vector<float> deepest) const {
    const double count = static_cast<double>(deepest.size());
    const auto clear = static_cast<std::size_t>(std::lround((1.0 - cloud_.cover) * count));
    if (clear >= deepest.size()) {
      return 1e30;
    }
    if (clear == 0) {
      return 0.0;
    }
    const auto at = deepest.begin() + static_cast<std::ptrdiff_t>(clear - 1);
    std::ranges::nth_element(deepest, at);
    return static_cast<double>(*at);
  }

  void finish(double edge, double soft) {
    double most = 0.0;
    for (float& value : grid_.extinction) {
      const double depth = static_cast<double>(value);
      const double share = depth > edge ? smooth_step(-0.1 * soft, soft, depth - edge) : 0.0;
      value = static_cast<float>(share);
      most = std::max(most, share);
    }
    const double scale = most > 0.0 ? densest() / most : 0.0;
    for (float& value : grid_.extinction) {
      value = static_cast<float>(static_cast<double>(value) * scale);
    }
  }

  const Cloud& cloud_;
  CloudGrid grid_;
};

// Heaps around strewn points, of many sizes: the largest is left standing where two meet.
double heaps(double x, double y, NoisePeriod cells, std::uint32_t seed) {
  const double px = x * cells.x;
  const double py = y * cells.y;
  const int i = static_cast<int>(std::floor(px));
  const int j = static_cast<int>(std::floor(py));
  const auto wrap = [](int n, int period) { return static_cast<std::uint32_t>(((n % period) + period) % period); };
  double most = 0.0;
  for (int dj = -2; dj <= 2; ++dj) {
    for (int di = -2; di <= 2; ++di) {
      const std::uint32_t a = wrap(i + di, cells.x);
      const std::uint32_t b = wrap(j + dj, cells.y);
      const double dx = i + di + hashed(a, b, 0, seed) - px;
      const double dy = j + dj + hashed(a, b, 1, seed) - py;
      const double u = hashed(a, b, 2, seed);
      const double radius = 0.25 + 0.9 * u * u;
      const double share = (dx * dx + dy * dy) / (radius * radius);
      most = std::max(most, radius * (1.0 - share));
    }
  }
  return most;
}

}  // namespace

CloudGrid cumulus_grid(const Cloud& cloud) {
  Field field(cloud);
  const NoisePeriod cells = field.cells(cloud.cell);
  const NoisePeriod broad = field.cells(4.0 * cloud.cell);
  const NoisePeriod lumps = field.cells(0.35 * cloud.cell);
  ColumnMap map = field.map([&](double x, double y) {
    const double ragged = value_octaves(x * lumps.x, y * lumps.y, 0.5, lumps, 3, field.seed(1));
    const double clusters = value_octaves(x * broad.x, y * broad.y, 0.5, broad, 2, field.seed(2));
    return heaps(x, y, cells, field.seed(3)) + 0.3 * (ragged - 0.5) + 0.5 * (clusters - 0.5);
  });
  map.rank();
  const double wide = std::min(1.0, 1.25 * cloud.cover + 0.02);  // before the billows take their part
  const double lump_height = field.height() * lumps.x / cloud.period;
  const CellOctaves billows(lumps, lump_height, 3, field.seed(10));
  return std::move(field).carve(
      [&, lumps](double x, double y, double z) {
        const double strength = (map.between(x * field.side(), y * field.side()) - 1.0 + wide) / wide;
        const double depth = strength - z * std::sqrt(z);
        const double billow = 0.12 + 0.33 * std::sqrt(z);
        // Fades out where it is far from the edge.
        const double share = smooth_step(-0.3, -0.1, depth) * (1.0 - smooth_step(billow + 0.1, billow + 0.35, depth));
        if (share <= 0.0) {
          return depth;
        }
        const double carved = billows.at(x * lumps.x, y * lumps.y, z * lump_height);
        return depth - share * billow * carved;
      },
      0.35);
}

CloudGrid stratocumulus_grid(const Cloud& cloud) {
  Field field(cloud);
  const NoisePeriod cells = field.cells(cloud.cell);
  const NoisePeriod broad = field.cells(4.0 * cloud.cell);
  const NoisePeriod lumps = field.cells(0.3 * cloud.cell);
  ColumnMap map = field.map([&](double x, double y) {
    return 0.6 * value_octaves(x * broad.x, y * broad.y, 0.5, broad, 2, field.seed(2)) -
           cell_noise(x * cells.x, y * cells.y, 0.5, cells, field.seed(1)) -
           0.25 * cell_octaves(x * lumps.x, y * lumps.y, 0.5, lumps, 2, field.seed(3));
  });
  map.rank();
  const double wide = std::min(1.0, 1.1 * cloud.cover + 0.05);
  const double lump_height = field.height() * lumps.x / cloud.period;
  const CellOctaves billows(lumps, lump_height, 3, field.seed(10));
  return std::move(field).carve(
      [&, lumps](double x, double y, double z) {
        const double strength = (map.between(x * field.side(), y * field.side()) - 1.0 + wide) / wide;
        const double thick = std::sqrt(std::max(strength, 0.0));
        // The base is nearly level; the top bulges over each cell.
        const double depth = std::min((0.35 + 0.65 * thick - z) * 1.5, (z - 0.3 * (1.0 - thick)) * 3.0 + 0.1);
        const double carved = billows.at(x * lumps.x, y * lumps.y, z * lump_height);
        return std::min(depth, 2.0 * strength) - 0.25 * carved;
      },
      0.3);
}

// Fibres that lie along a direction with whole coordinates near the wind's, by which the field repeats itself all the
// same. Each octave is twice as fine across, but hardly shorter: fibres stay fibres. None is finer than the grid shows.
class Fibres {
 public:
  Fibres(const Cloud& cloud, NoisePeriod cells, std::uint32_t seed)
      : a_(static_cast<int>(std::lround(2.0 * std::sin(cloud.wind)))),
        b_(static_cast<int>(std::lround(2.0 * std::cos(cloud.wind)))),
        cells_(cells),
        seed_(seed) {
    constexpr double kCellsAcross = 5.0;  // of the grid, by a fibre and the gap beside it
    const double most = cloud.period / (kCellsAcross * cloud.detail * std::hypot(a_, b_));
    for (int across = std::max(1, 5 * cells.x / 4); across <= most && octaves_.size() < 5; across *= 2) {
      const int along = std::max(1, cells.x / 4) + static_cast<int>(octaves_.size());
      octaves_.push_back({along, across});
    }
  }

  // 1 on the middle line of a fibre, less beside it.
  double at(double x, double y, double z) const {
    const double bend = 0.03 * (value_octaves(x * cells_.x, y * cells_.y, 0.5, cells_, 2, seed_) - 0.5);
    const double u = a_ * x + b_ * y;
    const double v = a_ * y - b_ * x + bend;
    double sum = 0.0;
    double weights = 0.0;
    double weight = 1.0;
    for (const NoisePeriod& octave : octaves_) {
      const double noise =
          value_noise(u * octave.x, v * octave.y, 1.5 * z, octave, seed_ + static_cast<std::uint32_t>(octave.y));
      sum += weight * (1.0 - 2.0 * std::abs(noise - 0.5));
      weights += weight;
      weight *= 0.7;
    }
    return weights > 0.0 ? sum / weights : 1.0;
  }

 private:
  int a_;
  int b_;
  NoisePeriod cells_;
  std::uint32_t seed_;
  std::vector<NoisePeriod> octaves_;
};

CloudGrid cirrus_grid(const Cloud& cloud) {
  Field field(cloud);
  const NoisePeriod cells = field.cells(cloud.cell);
  const NoisePeriod broad = field.cells(2.0 * cloud.cell);
  const Fibres fibres(cloud, cells, field.seed(4));
  ColumnMap map = field.map(
      [&](double x, double y) { return value_octaves(x * broad.x, y * broad.y, 0.5, broad, 4, field.seed(1)); });
  map.rank();
  const double wide = std::min(1.0, 1.4 * cloud.cover + 0.1);
  return std::move(field).fill(
      [&](double x, double y, double z) {
        const double strength = (map.between(x * field.side(), y * field.side()) - 1.0 + wide) / wide;
        if (strength <= 0.0) {
          return 0.0;
        }
        const double level = 1.0 - (2.0 * z - 1.0) * (2.0 * z - 1.0);
        const double fibre = fibres.at(x, y, z);
        return std::sqrt(strength) * level * (fibre * fibre * fibre - 0.25);
      },
      0.5);
}

}  // namespace airlight
