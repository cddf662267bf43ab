#include "core/clouds/carved_field.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/in_parallel.h"

namespace airlight {
namespace {

// Depths over their slope: distances to the edge, km, at most `most` to both sides.
std::vector<float> distances(const CloudGrid& grid, double gentlest, double most) {
  std::vector<float> out(grid.extinction.size());
  const auto depth = [&](int i, int j, int k) { return static_cast<double>(grid.extinction[grid.index(i, j, k)]); };
  in_parallel(static_cast<std::size_t>(grid.nz), [&](std::size_t level) {
    const int k = static_cast<int>(level);
    const int low = std::max(k - 1, 0);
    const int high = std::min(k + 1, grid.nz - 1);
    for (int j = 0; j < grid.ny; ++j) {
      const int south = j > 0 ? j - 1 : grid.ny - 1;
      const int north = j + 1 < grid.ny ? j + 1 : 0;
      for (int i = 0; i < grid.nx; ++i) {
        const int west = i > 0 ? i - 1 : grid.nx - 1;
        const int east = i + 1 < grid.nx ? i + 1 : 0;
        const double x = (depth(east, j, k) - depth(west, j, k)) / (2.0 * grid.cell_x);
        const double y = (depth(i, north, k) - depth(i, south, k)) / (2.0 * grid.cell_y);
        const double z = (depth(i, j, high) - depth(i, j, low)) / ((high - low) * grid.cell_z());
        const double slope = std::max(std::sqrt(x * x + y * y + z * z), gentlest);
        out[grid.index(i, j, k)] = static_cast<float>(std::clamp(depth(i, j, k) / slope, -most, most));
      }
    }
  });
  return out;
}

// Moves the edge to where the share `cover` of the columns' middle lines meets water.
void cover_share(CloudGrid& grid, double cover, double most) {
  std::vector<double> deepest(grid.index(0, 0, 1), -2.0 * most);
  in_parallel(static_cast<std::size_t>(grid.ny), [&](std::size_t row) {
    const int j = static_cast<int>(row);
    for (int k = 0; k < grid.nz; ++k) {
      for (int i = 0; i < grid.nx; ++i) {
        const auto inside = static_cast<double>(grid.inside[grid.index(i, j, k)]);
        double& column = deepest[grid.index(i, j, 0)];
        if (inside > column) {  // else noise takes it no higher
          const double carved = grid.carved((i + 0.5) / grid.nx, (j + 0.5) / grid.ny, (k + 0.5) / grid.nz);
          column = std::max(column, inside - grid.edge.carving * carved);
        }
      }
    }
  });
  const auto clear = static_cast<std::size_t>(std::lround((1.0 - cover) * static_cast<double>(deepest.size())));
  if (clear >= deepest.size()) {
    std::ranges::fill(grid.inside, static_cast<float>(-most));
    return;
  }
  const auto at = deepest.begin() + static_cast<std::ptrdiff_t>(clear > 0 ? clear - 1 : 0);
  std::ranges::nth_element(deepest, at);
  // A cloud without holes: a little water in the thinnest column.
  const auto shift = static_cast<float>(clear > 0 ? *at : *at - grid.edge.soft);
  std::ranges::for_each(grid.inside, [shift](float& inside) { inside -= shift; });
}

// The base is nearly level: so far above it a place is inside the cloud at most, but for what noise takes.
void level_base(CloudGrid& grid) {
  constexpr double kRagged = 0.2;  // of the carving
  for (int k = 0; k < grid.nz; ++k) {
    const auto most = static_cast<float>((k + 0.5) * grid.cell_z() + kRagged * grid.edge.carving);
    for (std::size_t at = grid.index(0, 0, k); at < grid.index(0, 0, k + 1); ++at) {
      grid.inside[at] = std::min(grid.inside[at], most);
    }
  }
}

// The mean extinction of each cell, by the middles of its eighths.
void take_means(CloudGrid& grid) {
  const double full = grid.edge.carving + grid.edge.soft;
  const double spread = 2.0 * std::max({grid.cell_x, grid.cell_y, grid.cell_z()});
  in_parallel(static_cast<std::size_t>(grid.ny), [&](std::size_t row) {
    const int j = static_cast<int>(row);
    for (int k = 0; k < grid.nz; ++k) {
      for (int i = 0; i < grid.nx; ++i) {
        const std::size_t at = grid.index(i, j, k);
        const auto inside = static_cast<double>(grid.inside[at]);
        double mean = 0.0;
        if (inside > full + spread) {
          mean = physics::CloudEdgePhysics{}.edge_extinction(grid.edge, (k + 0.5) / grid.nz, inside, 0.0);
        } else if (inside > -spread) {
          for (int part = 0; part < 8; ++part) {
            const auto middle = [part](int cell, int bit) { return cell + (((part >> bit) & 1) != 0 ? 0.75 : 0.25); };
            mean += 0.125 * grid.at(grid.west + middle(i, 0) * grid.cell_x, grid.south + middle(j, 1) * grid.cell_y,
                                    grid.base + middle(k, 2) * grid.cell_z());
          }
        }
        grid.extinction[at] = static_cast<float>(mean);
      }
    }
  });
}

}  // namespace

void carve_field(CloudGrid& grid, double cover, double low, double high, const Carving& carving) {
  constexpr double kFarthest = 5.0;  // of the carving, the most by which distances to the edge are told
  const double width = grid.nx * grid.cell_x;
  const double tiles = std::max(1.0, std::round(width / carving.tile));
  grid.edge = {.tiles = tiles,
               .tile_levels = (grid.top - grid.base) * tiles / width,
               .carving = carving.most,
               .soft = carving.soft,
               .low = low,
               .high = high};
  grid.noise = std::make_shared<const CarvingNoise>(carving_noise());
  grid.inside = distances(grid, carving.gentlest, kFarthest * carving.most);
  cover_share(grid, cover, kFarthest * carving.most);
  level_base(grid);
  take_means(grid);
}

}  // namespace airlight
