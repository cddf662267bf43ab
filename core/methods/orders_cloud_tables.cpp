#include "core/methods/orders_cloud_tables.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <vector>

#include "core/base/error.h"
#include "core/gpu/kept_values.h"
#include "core/plan/bytes.h"
#include "core/scene/cloud_file.h"

namespace airlight::orders {
namespace {

BufferId add_values(Plan& plan, const std::string& name, Extent cells, std::function<std::vector<std::byte>()> values) {
  return plan.add_buffer({.name = name,
                          .bytes = std::size_t{cells.width} * cells.height * cells.depth * sizeof(float),
                          .contents_when_run = std::move(values)});
}

// Values of cells as an image that repeats itself in x and y, its second component of other values; `key` names it.
ImageId add_cells(Plan& plan, const std::string& name, Extent cells, BufferId values, BufferId second,
                  const std::string& key) {
  const Extent extent{cells.width + 1, cells.height + 1, cells.depth};
  const ImageId image = plan.add_image({.name = name,
                                        .extent = extent,
                                        .key = key,
                                        .half = true,
                                        .components = values == second ? 1U : 2U,
                                        .shared = true});
  plan.add_pass({.name = name,
                 .shader = "cloud_density",
                 .reads = {{"extinction", values}, {"inside", second}},
                 .writes = {{"density_out", image}},
                 .grid = extent,
                 .push_constants = {cells.width, cells.height, cells.depth}});
  return image;
}

// The noise that carves the edges of fields, the same for all; its first level is the last once more, as columns and
// rows are.
ImageId add_noise(Plan& plan, const std::shared_ptr<const CarvingNoise>& noise) {
  const std::string key = "cloud noise";
  if (const auto made = plan.shared_image(key)) {
    return *made;
  }
  constexpr std::uint32_t kSide = CarvingNoise::kSide;
  constexpr Extent kCells{kSide, kSide, kSide + 1};
  const BufferId values = add_values(plan, "cloud_noise_values", kCells, [noise] {
    std::vector<float> texels(noise->values.end() - kSide * kSide, noise->values.end());
    texels.insert(texels.end(), noise->values.begin(), noise->values.end());
    return bytes_of(texels);
  });
  return add_cells(plan, "cloud_noise", kCells, values, values, key);
}

}  // namespace

std::size_t corners_of(const CloudGrid& grid, std::size_t finer) {
  const auto count = [](int cells) { return static_cast<std::size_t>(cells); };
  return (count(grid.nx) + 1) * (count(grid.ny) + 1) * (finer * count(grid.nz) + 1);
}

std::shared_ptr<const CloudGrid> with_room(const Cloud& cloud, const std::shared_ptr<const CloudGrid>& alone,
                                           physics::vec3 to_sun) {
  const CloudGrid& grid = *alone;
  if (grid.repeats) {
    return alone;
  }
  const double reach = (grid.top - grid.base) * std::sqrt(1.0 - to_sun.z * to_sun.z) / to_sun.z;
  const double wide = std::min(reach, grid.nx * grid.cell_x);
  const double deep = std::min(reach, grid.ny * grid.cell_y);
  const int x = static_cast<int>(std::ceil(0.5 * wide / grid.cell_x)) + 1;
  const int y = static_cast<int>(std::ceil(0.5 * deep / grid.cell_y)) + 1;
  auto out = std::make_shared<CloudGrid>(grid);
  out->nx = grid.nx + 2 * x;
  out->ny = grid.ny + 2 * y;
  out->west = grid.west - x * grid.cell_x;
  out->south = grid.south - y * grid.cell_y;
  if (corners_of(*out, 1) > kMostCloudCells) {
    throw InputError("/clouds/" + std::to_string(cloud.index) +
                     "/file: with room for its shadow the cloud is a grid of " + std::to_string(out->nx + 1) + " x " +
                     std::to_string(out->ny + 1) + " x " + std::to_string(out->nz + 1) +
                     " points; the method \"orders\" takes at most " + std::to_string(kMostCloudCells) +
                     ": raise the sun, make the cells larger, or choose path-trace with render.method or --method");
  }
  out->extinction.assign(out->index(0, 0, out->nz), 0.0F);
  for (int k = 0; k < grid.nz; ++k) {
    for (int j = 0; j < grid.ny; ++j) {
      std::copy_n(&grid.extinction[grid.index(0, j, k)], grid.nx, &out->extinction[out->index(x, j + y, k)]);
    }
  }
  return out;
}

CloudCells shape_of(const CloudGrid& grid) {
  return {.nx = static_cast<std::uint32_t>(grid.nx),
          .ny = static_cast<std::uint32_t>(grid.ny),
          .nz = static_cast<std::uint32_t>(grid.nz),
          .cell_x = grid.cell_x,
          .cell_y = grid.cell_y,
          .cell_z = grid.cell_z()};
}

CloudCells light_shape(const CloudGrid& grid, TableSize most) {
  const bool carved = grid.edge.tiles > 0.0;
  const double spare = carved ? std::max(most[1] / static_cast<double>(grid.nz), 1.0) : 1.0;
  const auto across = static_cast<std::uint32_t>(most[0] * std::sqrt(spare));
  return coarse_shape(shape_of(grid), across, across, static_cast<std::uint32_t>(most[1]));
}

CloudCells cells_of(const CloudGrid& grid) {
  CloudCells cells = shape_of(grid);
  cells.extinction = grid.extinction;
  return cells;
}

std::string key_on(const std::string& cloud, const CloudCells& cells) {
  return cloud + " on " + std::to_string(cells.nx) + "x" + std::to_string(cells.ny) + "x" + std::to_string(cells.nz);
}

ImageId add_density(Plan& plan, const std::shared_ptr<const CloudGrid>& grid, const std::string& cloud) {
  const std::string key = cloud + " density";
  if (const auto made = plan.shared_image(key)) {
    return *made;
  }
  const Extent cells{static_cast<std::uint32_t>(grid->nx), static_cast<std::uint32_t>(grid->ny),
                     static_cast<std::uint32_t>(grid->nz)};
  const BufferId means = add_values(plan, "cloud_density_values", cells, [grid] { return bytes_of(grid->extinction); });
  const BufferId inside =
      grid->inside.empty() ? means : add_values(plan, "cloud_inside", cells, [grid] { return bytes_of(grid->inside); });
  return add_cells(plan, "cloud_density", cells, means, inside, key);
}

ImageId add_gaps(Plan& plan, const std::shared_ptr<const CloudGrid>& grid, const std::string& cloud) {
  const std::string key = cloud + " gaps";
  if (const auto made = plan.shared_image(key)) {
    return *made;
  }
  const auto half = [](int count) { return static_cast<std::uint32_t>(count + 1) / 2; };
  const Extent cells{half(grid->nx), half(grid->ny), std::max(half(grid->nz), 2U)};
  const BufferId gaps = add_values(plan, "cloud_gap_values", cells, [grid, cells, key] {
    return bytes_of(kept_floats(key_on(key, shape_of(*grid)), [&] {
      CloudCells fine = cells_of(*grid);
      for (std::size_t at = 0; at < grid->inside.size(); ++at) {
        fine.extinction[at] += std::max(grid->inside[at], 0.0F);
      }
      return gaps_of(coarsened(fine, cells.width, cells.height, cells.depth));
    }));
  });
  return add_cells(plan, "cloud_gap", cells, gaps, gaps, key);
}

EdgeInputs add_edge(Plan& plan, const CloudGrid& grid, ImageId any) {
  const bool carved = grid.edge.tiles > 0.0;
  return {{"cloud_noise_lut", carved ? add_noise(plan, grid.noise) : any}, {"kCarved", carved ? 1U : 0U}};
}

}  // namespace airlight::orders
