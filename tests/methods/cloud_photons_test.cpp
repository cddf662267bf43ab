// Light in the cells of a field of clouds by discrete ordinates, against photons that are counted cell by cell.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "core/luts/cloud_light.h"
#include "core/methods/orders_cloud_tables.h"
#include "core/methods/path_trace/cloud_trace.h"
#include "core/plan/bytes.h"
#include "tests/methods/cloud_scene.h"
#include "tests/shared_executor.h"

namespace airlight::test {
namespace {

using physics::vec3;
using std::numbers::pi;

constexpr double kSunElevation = 20.0;  // degrees
constexpr double kFlat = 1e6;           // km, radius of a planet that is as good as level

Executor& photon_executor() {
  static auto* shared = new SharedExecutor();
  static const bool added = testing::AddGlobalTestEnvironment(shared) != nullptr;
  (void)added;
  return shared->get();
}

// Places as path-trace has them: east, up from the planet's centre, south.
vec3 toward_sun(const Scene& scene) {
  const double across = std::cos(scene.sun.elevation);
  return {across * std::sin(scene.sun.azimuth), std::sin(scene.sun.elevation), -across * std::cos(scene.sun.azimuth)};
}

// Meetings with drops in each cell: of the sun's light, and of light that has been scattered.
struct Meetings {
  std::vector<double> first;
  std::vector<double> later;
};

// Photons that fall on the top, evenly, and are scattered evenly into all directions until they leave.
Meetings met(const std::shared_ptr<const CloudGrid>& grid, const CloudCells& cells, vec3 to_sun, std::uint64_t seed,
             int photons) {
  const TracedCloud cloud(grid, kFlat);
  const double width = grid->nx * grid->cell_x;
  const double depth = grid->ny * grid->cell_y;
  Meetings meetings{std::vector<double>(cells.count()), std::vector<double>(cells.count())};
  for (int n = 0; n < photons; ++n) {
    Random random(seed, static_cast<std::uint64_t>(n), 0);
    vec3 place(grid->west + width * random.uniform(), kFlat + grid->top - 1e-6,
               -grid->south - depth * random.uniform());
    vec3 direction = -to_sun;
    std::vector<double>* count = &meetings.first;
    while (true) {
      const double rise = direction.y > 0.0 ? kFlat + grid->top - place.y : place.y - kFlat - grid->base;
      const auto distance = cloud.collide(place, direction, rise / std::max(std::abs(direction.y), 1e-9), random);
      if (!distance) {
        break;
      }
      place = place + direction * *distance;
      const auto cell = [](double share, std::uint32_t cells_across) {
        return std::min(static_cast<std::uint32_t>((share - std::floor(share)) * cells_across), cells_across - 1);
      };
      const std::uint32_t i = cell((place.x - grid->west) / width, cells.nx);
      const std::uint32_t j = cell((-place.z - grid->south) / depth, cells.ny);
      const std::uint32_t k = cell((place.y - kFlat - grid->base) / (grid->top - grid->base), cells.nz);
      (*count)[(std::size_t{k} * cells.ny + j) * cells.nx + i] += 1.0;
      count = &meetings.later;
      const double y = 2.0 * random.uniform() - 1.0;
      const double azimuth = 2.0 * pi * random.uniform();
      const double across = std::sqrt(1.0 - y * y);
      direction = {across * std::cos(azimuth), y, across * std::sin(azimuth)};
    }
  }
  return meetings;
}

double water_of(const CloudCells& cells, std::size_t at) {
  return static_cast<double>(cells.extinction[at]) * cells.cell_x * cells.cell_y * cells.cell_z;
}

// The photons' sunlight on cells of twice the size.
std::vector<double> on_coarser(const CloudCells& cells, const CloudCells& coarser,
                               const std::vector<double>& sunlight) {
  std::vector<double> light(coarser.count());
  for (std::size_t at = 0; at < cells.count(); ++at) {
    const std::size_t i = at % cells.nx / 2;
    const std::size_t j = at / cells.nx % cells.ny / 2;
    const std::size_t k = at / cells.nx / cells.ny / 2;
    const std::size_t to = (k * coarser.ny + j) * coarser.nx + i;
    light[to] += sunlight[at] * water_of(cells, at) / std::max(water_of(coarser, to), 1e-12);
  }
  return light;
}

// Light scattered more than once, all directions together, in each cell, found as pictures do, but from the photons'
// own sunlight there.
std::vector<double> swept(const CloudCells& cells, vec3 to_sun, const std::vector<double>& sunlight) {
  const CloudDrops even{.single_scattering_albedo = 1.0, .legendre = {1.0, 0.0, 0.0, 0.0, 0.0}};
  const CloudCells coarser = coarsened(cells, cells.nx / 2, cells.ny / 2, cells.nz / 2);
  Plan plan;
  const CloudTables tables = add_cloud_tables(plan, even, {-to_sun.x, to_sun.z, -to_sun.y});
  const LaidCells laid = add_cloud_cells(plan, "cells", cells, even);
  const LaidCells laid_coarser = add_cloud_cells(plan, "coarser_cells", coarser, even);
  const auto add = [&](const std::string& name, const LaidCells& on, const std::vector<double>& light,
                       const SweepSettings& settings) {
    const std::vector<float> beam(light.begin(), light.end());
    const BufferId lit = plan.add_buffer(filled_buffer(name + "_beam", bytes_of(beam)));
    return add_cloud_field(plan, on, even, {.name = name, .sun = true}, settings, tables, lit, {});
  };
  const CloudField start = add("start", laid_coarser, on_coarser(cells, coarser, sunlight), {});
  const CloudField field = add("sun", laid, sunlight, {.host_readable = true, .start = {{start, laid_coarser}}});
  const std::vector<float> moments = values_of<float>(photon_executor().run(plan).contents(field.moments));
  std::vector<double> light;
  for (std::size_t at = 0; at < cells.count(); ++at) {
    light.push_back(static_cast<double>(moments[at]) * std::sqrt(4.0 * pi));
  }
  return light;
}

// Of the cells that hold at least half as much water as the fullest, by eighths from the darkest to the brightest: the
// light by ordinates over that by photons, less 1. Photons of one half say how bright a cell is, those of the other how
// much light it has: else noise would sort them.
std::vector<double> errors_by_eighths(const std::shared_ptr<const CloudGrid>& grid, vec3 to_sun, CellValues values,
                                      const char* name) {
  constexpr int kPhotons = 200000;  // of a half
  const CloudCells fine = orders::cells_of(*grid);
  const CloudCells cells = coarsened(fine, 72, 72, 14, values);
  const Meetings one = met(grid, cells, to_sun, 1, kPhotons);
  const Meetings other = met(grid, cells, to_sun, 2, kPhotons);
  const double per_photon = to_sun.y * grid->nx * grid->cell_x * grid->ny * grid->cell_y / (2.0 * kPhotons);
  std::vector<double> sunlight(cells.count());
  std::vector<double> truth(cells.count());
  std::vector<std::size_t> full;
  const float most = *std::ranges::max_element(cells.extinction);
  for (std::size_t at = 0; at < cells.count(); ++at) {
    const double water = water_of(cells, at);
    if (water > 0.0) {
      sunlight[at] = (one.first[at] + other.first[at]) * per_photon / water;
      truth[at] = other.later[at] * 2.0 * per_photon / water;
    }
    if (cells.extinction[at] > 0.5F * most) {
      full.push_back(at);
    }
  }
  std::ranges::sort(full, {},
                    [&](std::size_t at) { return one.later[at] / static_cast<double>(cells.extinction[at]); });
  const std::vector<double> light = swept(with_lumps(cells, fine, values), to_sun, sunlight);
  std::vector<double> errors;
  std::printf("%s, %zu cells:", name, full.size());
  for (std::size_t part = 0; part < 8; ++part) {
    double found = 0.0;
    double expected = 0.0;
    for (std::size_t n = full.size() * part / 8; n < full.size() * (part + 1) / 8; ++n) {
      found += light[full[n]] * static_cast<double>(cells.extinction[full[n]]);
      expected += truth[full[n]] * static_cast<double>(cells.extinction[full[n]]);
    }
    errors.push_back(found / expected - 1.0);
    std::printf(" %+.1f", 100.0 * errors.back());
  }
  std::printf(" %%\n");
  return errors;
}

// In water as smooth as the grid's means cells of any light are right to 4 %. Where noise carves lobes finer than the
// cells, these count as evenly full, and light goes too far into the shade.
TEST(CloudPhotons, SweepsMeetPhotonsCellByCell) {
  const Scene scene = among_cumulus(kSunElevation, 0.35);
  const auto carved = std::make_shared<const CloudGrid>(cloud_grid(scene.clouds.front()));
  CloudGrid means = *carved;
  means.edge = {};
  const vec3 to_sun = toward_sun(scene);
  for (const double error : errors_by_eighths(carved, to_sun, CellValues::means, "carved water")) {
    EXPECT_NEAR(error, 0.0, 0.2);
  }
  for (const double error :
       errors_by_eighths(std::make_shared<const CloudGrid>(means), to_sun, CellValues::middles, "its means")) {
    EXPECT_NEAR(error, 0.0, 0.05);
  }
}

// The sun's light in the cells, level by level, by pictures' own plan.
void expect_sunlight_of_photons(Scene scene, const char* name) {
  constexpr int kPhotons = 300000;
  constexpr double kMuch = 0.05;  // of all water
  const auto grid = std::make_shared<const CloudGrid>(cloud_grid(scene.clouds.front()));
  const CloudCells shape = orders::light_shape(*grid, scene.render.get<TableSize>("cloud_lut"));
  const CloudCells cells = coarsened(orders::cells_of(*grid), shape.nx, shape.ny, shape.nz);
  const vec3 to_sun = toward_sun(scene);
  const Meetings photons = met(grid, cells, to_sun, 3, kPhotons);
  const double per_photon = to_sun.y * grid->nx * grid->cell_x * grid->ny * grid->cell_y / kPhotons;
  Plan plan = plan_for(ready(scene), {});
  const auto named = std::ranges::find(plan.buffers(), "cloud_beam", &BufferDesc::name);
  const BufferId beam{static_cast<std::uint32_t>(named - plan.buffers().begin())};
  plan.make_readable(beam);
  const std::vector<float> light = values_of<float>(photon_executor().run(plan).contents(beam));
  double all_water = 0.0;
  for (std::size_t at = 0; at < cells.count(); ++at) {
    all_water += water_of(cells, at);
  }
  const std::size_t plane = std::size_t{cells.nx} * cells.ny;
  for (std::uint32_t k = 0; k < cells.nz; ++k) {
    double water = 0.0;
    double found = 0.0;
    double expected = 0.0;
    for (std::size_t at = k * plane; at < (k + 1) * plane; ++at) {
      water += water_of(cells, at);
      found += static_cast<double>(light[at]) * water_of(cells, at);
      expected += photons.first[at] * per_photon;
    }
    if (water > kMuch * all_water) {
      std::printf("%s, level %u: %+.1f %%\n", name, k, 100.0 * (found / expected - 1.0));
      EXPECT_NEAR(found / expected, 1.0, 0.06) << name << ", level " << k;
    }
  }
}

// What the cells take is what the photons leave there. With means that count the water beside a cell as well, and with
// the light of the water in place of what it takes, cells of a sheet under a sun of 4 degrees would take 1.2 times as
// much.
TEST(CloudPhotons, LeaveTheSunsLightWhereCellsTakeIt) {
  expect_sunlight_of_photons(among_cumulus(20.0, 0.35), "cumulus");
  expect_sunlight_of_photons(among_sheets(5.0, 0.6), "a sheet");
}

}  // namespace
}  // namespace airlight::test
