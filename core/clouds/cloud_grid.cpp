#include "core/clouds/cloud_grid.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <utility>

#include "core/base/text.h"
#include "core/gpu/kept_values.h"
#include "core/spectra/drops.h"

namespace airlight {
namespace {

// The two cells between whose middles a place lies, and how far on it is.
struct Between {
  int low = 0;
  int high = 0;
  double share = 0.0;
};

// `x`: in cells from the grid's edge; `repeats`: any; else 0 to count.
Between between(double x, int count, bool repeats) {
  const double place = x - 0.5;
  const double low = std::floor(place);
  if (repeats) {
    const double first = low - count * std::floor(low / count);
    const int i = std::min(static_cast<int>(first), count - 1);
    return {i, i + 1 == count ? 0 : i + 1, place - low};
  }
  const int i = static_cast<int>(low);
  return {std::clamp(i, 0, count - 1), std::clamp(i + 1, 0, count - 1), place - low};
}

int cell_of(double x, int count, bool repeats) {
  const double low = std::floor(x);
  const double first = repeats ? low - count * std::floor(low / count) : low;
  return std::clamp(static_cast<int>(first), 0, count - 1);
}

CloudGrid volume_grid(const Cloud& cloud) {
  const CloudFile& file = *cloud.contents;
  CloudGrid grid;
  grid.nx = file.nx;
  grid.ny = file.ny;
  grid.nz = file.nz;
  grid.cell_x = file.dx;
  grid.cell_y = file.dy;
  grid.base = cloud.base;
  grid.top = cloud.top;
  grid.repeats = cloud.repeats;
  grid.extinction = file.extinction;
  grid.smooth = !file.in_cells;
  return grid;
}

CloudGrid field_by_seed(const Cloud& cloud) {
  return cloud.kind == CloudKind::cumulus         ? cumulus_grid(cloud)
         : cloud.kind == CloudKind::stratocumulus ? stratocumulus_grid(cloud)
                                                  : cirrus_grid(cloud);
}

// What a field is beside its values, as files keep it.
struct FieldHead {
  int nx;
  int ny;
  int nz;
  int carved;  // 1: the values inside the cloud's edge follow those of the extinction
  double cell_x;
  double cell_y;
  double base;
  double top;
  physics::CloudEdge edge;
};
constexpr std::size_t kHeadWords = sizeof(FieldHead) / sizeof(std::uint32_t);
static_assert(std::is_trivially_copyable_v<FieldHead> && kHeadWords * sizeof(std::uint32_t) == sizeof(FieldHead));

std::vector<std::uint32_t> words_of(const CloudGrid& grid) {
  const FieldHead head{.nx = grid.nx,
                       .ny = grid.ny,
                       .nz = grid.nz,
                       .carved = grid.inside.empty() ? 0 : 1,
                       .cell_x = grid.cell_x,
                       .cell_y = grid.cell_y,
                       .base = grid.base,
                       .top = grid.top,
                       .edge = grid.edge};
  std::vector<std::uint32_t> words(kHeadWords + grid.extinction.size() + grid.inside.size());
  std::memcpy(words.data(), &head, sizeof head);
  auto at = words.begin() + kHeadWords;
  for (const std::vector<float>* values : {&grid.extinction, &grid.inside}) {
    at = std::ranges::transform(*values, at, [](float value) { return std::bit_cast<std::uint32_t>(value); }).out;
  }
  return words;
}

CloudGrid grid_of(const std::vector<std::uint32_t>& words) {
  FieldHead head{};
  std::memcpy(&head, words.data(), sizeof head);
  CloudGrid grid;
  grid.nx = head.nx;
  grid.ny = head.ny;
  grid.nz = head.nz;
  grid.cell_x = head.cell_x;
  grid.cell_y = head.cell_y;
  grid.base = head.base;
  grid.top = head.top;
  grid.repeats = true;
  grid.edge = head.edge;
  const std::size_t count = grid.index(0, 0, grid.nz);
  const auto values_from = [&](std::size_t first) {
    std::vector<float> values(count);
    std::memcpy(values.data(), &words[first], count * sizeof(float));
    return values;
  };
  grid.extinction = values_from(kHeadWords);
  if (head.carved == 1) {
    grid.inside = values_from(kHeadWords + count);
    grid.noise = std::make_shared<const CarvingNoise>(carving_noise());
  }
  return grid;
}

CloudGrid grid_of_kind(const Cloud& cloud) {
  if (cloud.kind == CloudKind::volume) {
    return volume_grid(cloud);
  }
  return grid_of(kept_words("field " + cloud_shape_key(cloud), [&cloud] { return words_of(field_by_seed(cloud)); }));
}

// drops_phase(), kept: the numbers of angles and wavelengths, these themselves, and the rows.
PhaseTable kept_drops(double radius) {
  const std::vector<std::uint32_t> words = kept_words("drops " + shortest(radius), [radius] {
    const PhaseTable table = drops_phase(radius);
    std::vector<double> all{static_cast<double>(table.angles_deg.size()),
                            static_cast<double>(table.wavelengths_nm.size())};
    all.insert(all.end(), table.angles_deg.begin(), table.angles_deg.end());
    all.insert(all.end(), table.wavelengths_nm.begin(), table.wavelengths_nm.end());
    for (const std::vector<double>& row : table.rows) all.insert(all.end(), row.begin(), row.end());
    std::vector<std::uint32_t> bits(2 * all.size());
    std::memcpy(bits.data(), all.data(), all.size() * sizeof(double));
    return bits;
  });
  std::vector<double> values(words.size() / 2);
  std::memcpy(values.data(), words.data(), values.size() * sizeof(double));
  auto at = values.begin() + 2;
  const auto next = [&at](double count) {
    const auto first = std::exchange(at, at + static_cast<std::ptrdiff_t>(count));
    return std::vector<double>(first, at);
  };
  PhaseTable table;
  table.angles_deg = next(values[0]);
  table.wavelengths_nm = next(values[1]);
  while (at < values.end()) table.rows.push_back(next(values[0]));
  return table;
}

struct Corner {
  double west;
  double south;
};

Corner corner_of(const CloudGrid& grid, const Cloud& cloud) {
  return {cloud.east - 0.5 * grid.nx * grid.cell_x, cloud.north - 0.5 * grid.ny * grid.cell_y};
}

}  // namespace

double CloudGrid::at(double east, double north, double h) const {
  if (!(h >= base && h <= top)) {
    return 0.0;
  }
  const double x = (east - west) / cell_x;
  const double y = (north - south) / cell_y;
  const double z = (h - base) / cell_z();
  if (!repeats && !(x >= 0.0 && x <= nx && y >= 0.0 && y <= ny)) {
    return 0.0;
  }
  if (!smooth) {
    return static_cast<double>(
        extinction[index(cell_of(x, nx, repeats), cell_of(y, ny, repeats), cell_of(z, nz, false))]);
  }
  const Between a = between(x, nx, repeats);
  const Between b = between(y, ny, repeats);
  const Between c = between(z, nz, false);
  const std::vector<float>& values = edge.tiles > 0.0 ? inside : extinction;
  const auto row = [&](int j, int k) {
    const auto low = static_cast<double>(values[index(a.low, j, k)]);
    return low + a.share * (static_cast<double>(values[index(a.high, j, k)]) - low);
  };
  const auto level = [&](int k) {
    const double low = row(b.low, k);
    return low + b.share * (row(b.high, k) - low);
  };
  const double low = level(c.low);
  const double value = low + c.share * (level(c.high) - low);
  if (!(edge.tiles > 0.0) || value <= 0.0) {
    return std::max(value, 0.0);
  }
  const bool deep = value >= edge.carving + edge.soft;
  return physics::CloudEdgePhysics{}.edge_extinction(edge, z / nz, value, deep ? 0.0 : carved(x / nx, y / ny, z / nz));
}

double CloudGrid::carved(double x, double y, double z) const {
  physics::CloudEdgePhysics p;
  const auto noise_at = [&](double tiles, double levels) { return noise->at(x * tiles, y * tiles, z * levels); };
  return p.edge_carved(z, noise_at(edge.tiles, edge.tile_levels),
                       noise_at(edge.tiles * p.kCloudFiner, edge.tile_levels * p.kCloudFiner));
}

double CloudGrid::most_around(int i, int j, int k) const {
  const std::size_t at = index(i, j, k);
  if (!(edge.tiles > 0.0)) {
    return static_cast<double>(extinction[at]);
  }
  constexpr double kAboveRounding = 1.0 + 1e-6;
  const double height = edge.high > edge.low ? 1.0 : 0.0;
  return kAboveRounding *
         physics::CloudEdgePhysics{}.edge_extinction(edge, height, static_cast<double>(inside[at]), 0.0);
}

CloudGrid cloud_grid(const Cloud& cloud) {
  CloudGrid grid = grid_of_kind(cloud);
  const auto [west, south] = corner_of(grid, cloud);
  grid.west = west;
  grid.south = south;
  return grid;
}

std::shared_ptr<const CloudGrid> placed_at(const std::shared_ptr<const CloudGrid>& grid, const Cloud& cloud) {
  const auto [west, south] = corner_of(*grid, cloud);
  if (grid->west == west && grid->south == south) {
    return grid;
  }
  auto moved = std::make_shared<CloudGrid>(*grid);
  moved->west = west;
  moved->south = south;
  return moved;
}

std::string cloud_key(const Cloud& cloud) {
  std::string text = std::to_string(static_cast<int>(cloud.kind));
  for (const double value : {cloud.cover, cloud.base, cloud.top, cloud.cell, cloud.detail, cloud.period, cloud.water,
                             cloud.shear, cloud.wind, static_cast<double>(cloud.seed), cloud.effective_radius,
                             cloud.east, cloud.north, cloud.repeats ? 1.0 : 0.0}) {
    text += " " + shortest(value);
  }
  return text + (cloud.contents ? " " + cloud.contents->identity : "");
}

std::string cloud_shape_key(Cloud cloud) {
  cloud.east = 0.0;
  cloud.north = 0.0;
  return cloud_key(cloud);
}

Medium cloud_medium(const Cloud& cloud, const Spectrum& channels) {
  Medium medium;
  medium.name = "cloud";
  medium.scattering.fill(cloud.single_scattering_albedo);
  medium.absorption.fill(1.0 - cloud.single_scattering_albedo);
  medium.density.profile = DensityProfile::tent;
  medium.density.center = -2.0 * medium.density.half_width;  // under the ground
  medium.phase_g = cloud.phase_g;
  medium.phase = PhaseFunction::henyey_greenstein;
  if (cloud.phase == CloudPhase::drops) {
    medium.phase = PhaseFunction::table;
    medium.effective_radius = cloud.effective_radius;
    medium.phase_table = kept_drops(cloud.effective_radius);
    medium.phase_wavelengths = channels[1] > 0.0 ? channels : kDropChannels;
  }
  return medium;
}

}  // namespace airlight
