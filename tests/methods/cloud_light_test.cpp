// Light scattered in a cloud by discrete ordinates, on the device: against published results of the intercomparison of
// radiation codes in three dimensions (I3RC), against the same sweeps on the host in double, and where nothing absorbs
// against what goes in.
#include "core/luts/cloud_light.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <numeric>
#include <random>

#include "core/air/air.h"
#include "core/clouds/cloud_grid.h"
#include "core/clouds/cloud_phase.h"
#include "core/plan/bytes.h"
#include "tests/shared_executor.h"

namespace airlight {
namespace {

using std::numbers::pi;

Executor& cloud_executor() {
  static auto* shared = new test::SharedExecutor();
  static const bool added = testing::AddGlobalTestEnvironment(shared) != nullptr;
  (void)added;
  return shared->get();
}

CloudDrops henyey_greenstein(double g, double albedo = 1.0) {
  CloudDrops drops{.single_scattering_albedo = albedo, .legendre = {}};
  for (int l = 0; l < 8; ++l) {
    drops.legendre.push_back(std::pow(g, l));
  }
  return drops;
}

// The step cloud of I3RC's first case: 0.25 km thick, optical depth 2 over one half and 18 over the other.
CloudCells step_cloud(std::uint32_t layers) {
  CloudCells cells{.nx = 32, .ny = 1, .nz = layers, .cell_x = 0.5 / 32, .cell_y = 1.0, .cell_z = 0.25 / layers};
  for (std::size_t at = 0; at < cells.count(); ++at) {
    cells.extinction.push_back(at % 32 < 16 ? 2.0F / 0.25F : 18.0F / 0.25F);
  }
  return cells;
}

// Mean of the sun's light over each cell and over each column of the base, by rays through points of it. The extinction
// is even in each cell.
struct HostBeam {
  std::vector<float> cells;
  std::vector<double> base;
};

double sunlight_at(const CloudCells& c, double scale, physics::vec3 to_sun, double x, double y, double z) {
  constexpr int kParts = 8;  // of a layer
  const double width = c.cell_z / kParts / to_sun.z;
  double depth = 0.0;
  for (double way = 0.5 * width; z + way * to_sun.z < c.cell_z * c.nz; way += width) {
    const auto wrapped = [](double at, double cell, std::uint32_t count) {
      const double period = cell * count;
      return static_cast<std::size_t>((at - period * std::floor(at / period)) / cell) % count;
    };
    const std::size_t i = wrapped(x + way * to_sun.x, c.cell_x, c.nx);
    const std::size_t j = wrapped(y + way * to_sun.y, c.cell_y, c.ny);
    const auto k = static_cast<std::size_t>((z + way * to_sun.z) / c.cell_z);
    depth += width * scale * c.extinction[(k * c.ny + j) * c.nx + i];
  }
  return std::exp(-depth);
}

HostBeam host_beam(const CloudCells& c, double scale, physics::vec3 to_sun) {
  constexpr int kPoints = 4;
  HostBeam beam;
  const int across = c.ny > 1 ? kPoints : 1;
  const auto mean = [&](std::uint32_t i, std::uint32_t j, double low, double high, int levels) {
    double sum = 0.0;
    for (int n = 0; n < kPoints * across * levels; ++n) {
      const double x = (i + (n % kPoints + 0.5) / kPoints) * c.cell_x;
      const double y = (j + (n / kPoints % across + 0.5) / across) * c.cell_y;
      const double z = low + (high - low) * (n / (kPoints * across) + 0.5) / levels;
      sum += sunlight_at(c, scale, to_sun, x, y, z);
    }
    return sum / (kPoints * across * levels);
  };
  for (std::uint32_t k = 0; k < c.nz; ++k) {
    for (std::uint32_t at = 0; at < c.nx * c.ny; ++at) {
      const double value = mean(at % c.nx, at / c.nx, k * c.cell_z, (k + 1) * c.cell_z, kPoints);
      beam.cells.push_back(static_cast<float>(value));
    }
  }
  for (std::uint32_t at = 0; at < c.nx * c.ny; ++at) {
    beam.base.push_back(mean(at % c.nx, at / c.nx, 0.0, 0.0, 1));
  }
  return beam;
}

constexpr int kOfSun = 0;
constexpr int kOfSky = 1;
constexpr int kOfGround = 2;

struct Solved {
  CloudCells cells;
  CloudDrops drops;
  physics::vec3 sun = {};  // the direction in which its light travels
  HostBeam beam = {};
  std::array<std::vector<float>, 3> moments = {};  // of sun, sky and ground: harmonic, cell
  std::array<std::vector<float>, 3> planes = {};
};

Solved solve(const CloudCells& cells, const CloudDrops& drops, double elevation, int sweeps = 0) {
  Solved s{.cells = cells, .drops = drops};
  s.sun = {std::cos(elevation), 0.0, -std::sin(elevation)};
  s.beam = host_beam(cells, delta_scale(drops), -s.sun);
  Plan plan;
  const BufferId lit = plan.add_buffer(filled_buffer("beam", bytes_of(s.beam.cells)));
  const CloudTables tables = add_cloud_tables(plan, drops, s.sun);
  const LaidCells laid = add_cloud_cells(plan, "cells", cells, drops);
  std::vector<CloudField> fields;
  for (const CloudIncident& incident :
       {CloudIncident{.name = "sun", .sun = true}, CloudIncident{.name = "sky", .above = 1.0},
        CloudIncident{.name = "ground", .below = 1.0}}) {
    const SweepSettings settings{.sweeps = sweeps, .host_readable = true};
    fields.push_back(add_cloud_field(plan, laid, drops, incident, settings, tables, lit, {}));
  }
  const RunResult result = cloud_executor().run(plan);
  for (std::size_t i = 0; i < 3; ++i) {
    s.moments.at(i) = values_of<float>(result.contents(fields[i].moments));
    s.planes.at(i) = values_of<float>(result.contents(fields[i].planes));
  }
  return s;
}

// The cells' sides, and the axis along which an ordinate is carried.
physics::vec3 sides_of(const CloudCells& c) {
  return {c.cell_x, c.cell_y, c.cell_z};
}

std::uint32_t axis_of(const CloudCells& c, physics::vec3 direction) {
  const physics::vec3 extent{c.cell_x * c.nx, c.cell_y * c.ny, c.cell_z * c.nz};
  return physics::CloudPhysics{}.sweep_axis(direction, extent, sides_of(c));
}

// Flux out of each column, the rays carried on to the plane itself; of the sun over that on level ground.
std::vector<double> fluxes(const Solved& s, bool up, int of) {
  const CloudCells& c = s.cells;
  const std::vector<physics::CloudOrdinate> ordinates = cloud_ordinates();
  const std::vector<float>& planes = s.planes.at(static_cast<std::size_t>(of));
  const std::size_t plane = std::size_t{c.nx} * c.ny;
  std::vector<double> flux(plane, 0.0);
  for (std::size_t o = 0; o < ordinates.size(); ++o) {
    const physics::vec3 d = ordinates[o].direction;
    if ((d.z > 0.0) != up) {
      continue;
    }
    const bool upright = axis_of(c, d) == 2;
    const double shift = upright ? -0.5 * d.x * c.cell_z / std::abs(d.z) / c.cell_x : -0.5;
    const std::size_t last = o * plane;
    for (std::size_t at = 0; at < plane; ++at) {
      const double from = static_cast<double>(at % c.nx) + shift;
      const double part = from - std::floor(from);
      const auto i = static_cast<std::size_t>(static_cast<int>(std::floor(from)) + 64 * static_cast<int>(c.nx)) % c.nx;
      const auto value = [&](std::size_t x) { return static_cast<double>(planes[last + at / c.nx * c.nx + x % c.nx]); };
      flux[at] += ordinates[o].weight * std::abs(d.z) * ((1.0 - part) * value(i) + part * value(i + 1));
    }
  }
  for (std::size_t at = 0; at < plane && of == kOfSun; ++at) {
    flux[at] = (flux[at] + (up ? 0.0 : -s.sun.z * s.beam.base[at])) / -s.sun.z;
  }
  return flux;
}

// pi I / (F mu0) that leaves the top in a direction, in columns of the grid: light scattered once with the whole phase
// function, and the rest from the moments, by the same steps through cells.
std::vector<double> radiances(const Solved& s, double g, physics::vec3 d) {
  physics::CloudPhysics p;
  const CloudCells& c = s.cells;
  const std::size_t plane = std::size_t{c.nx} * c.ny;
  const double scale = delta_scale(s.drops);
  const physics::CloudScattering scattering = cloud_scattering(s.drops, s.sun);
  const double once = s.drops.single_scattering_albedo / scale * p.phase_henyey_greenstein(g, dot(d, s.sun));
  const double way = c.cell_z / d.z;
  std::vector<double> light(plane, 0.0);
  const auto at_place = [&](const std::vector<double>& values, std::size_t j, double x) {
    const double part = x - std::floor(x);
    const auto i = static_cast<std::size_t>(static_cast<int>(std::floor(x)) + 64 * static_cast<int>(c.nx)) % c.nx;
    return (1.0 - part) * values[j * c.nx + i] + part * values[j * c.nx + (i + 1) % c.nx];
  };
  for (std::uint32_t k = 0; k < c.nz; ++k) {
    std::vector<double> next(plane);
    for (std::size_t at = 0; at < plane; ++at) {
      const std::size_t cell = k * plane + at;
      double source = once * static_cast<double>(s.beam.cells[cell]);
      for (std::uint32_t q = 0; q < physics::kCloudMoments; ++q) {
        const auto moment = static_cast<double>(s.moments[kOfSun][q * c.count() + cell]);
        source += scattering.kept[q] * moment * p.cloud_harmonic(q, d);
      }
      const double depth = scale * static_cast<double>(c.extinction[cell]) * way;
      const double entering = at_place(light, at / c.nx, static_cast<double>(at % c.nx) - d.x * way / c.cell_x);
      next[at] = entering * std::exp(-depth) + source * (1.0 - std::exp(-depth));
    }
    light = next;
  }
  std::vector<double> out(plane);
  for (std::size_t at = 0; at < plane; ++at) {
    out[at] = pi / -s.sun.z * at_place(light, at / c.nx, static_cast<double>(at % c.nx) - 0.5 * d.x * way / c.cell_x);
  }
  return out;
}

double mean_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

// Published values; empty where the folder is absent.
std::vector<double> published(const std::string& name) {
  std::ifstream in(std::filesystem::path(AIRLIGHT_SOURCE_DIR) / "../shared/clouds" / name);
  std::vector<double> values;
  for (double x = 0.0; in >> x;) {
    values.push_back(x);
  }
  return values;
}

struct Compared {
  double bias;
  double error;  // mean relative
};

Compared compared(const std::string& what, const std::vector<double>& found, const std::vector<double>& truth) {
  Compared c{mean_of(found) / mean_of(truth) - 1.0, 0.0};
  for (std::size_t i = 0; i < truth.size(); ++i) {
    c.error += std::abs(found[i] / truth[i] - 1.0) / static_cast<double>(truth.size());
  }
  std::printf("%-22s mean %.4f truth %.4f bias %+.2f %% mean relative error %.2f %%\n", what.c_str(), mean_of(found),
              mean_of(truth), 100.0 * c.bias, 100.0 * c.error);
  return c;
}

// The step cloud's columns as published by I3RC: means are facts of its tables.
TEST(CloudLight, MeetsTheStepCloud) {
  struct Bound {
    const char* name;
    double bias;
    double error;
  };
  const CloudCells cells = step_cloud(32);
  const CloudDrops drops = henyey_greenstein(0.85);
  for (const bool zenith : {true, false}) {
    const Solved s = solve(cells, drops, zenith ? pi / 2 : pi / 6);
    const std::string name = zenith ? "i3rc-case1-exp1-" : "i3rc-case1-exp2-";
    const double mean = mean_of(fluxes(s, true, 0));
    EXPECT_NEAR(mean / (zenith ? 0.3276 : 0.5804), 1.0, 0.013) << "mean reflectance";
    const std::vector<double> reflected = published(name + "R.txt");
    if (reflected.empty()) {
      GTEST_SKIP() << "no published columns at hand";
    }
    const Compared r = compared(name + "R", fluxes(s, true, 0), reflected);
    EXPECT_LT(r.error, 0.02);
    if (zenith) {
      const Compared t = compared(name + "T", fluxes(s, false, 0), published(name + "T.txt"));
      EXPECT_LT(std::abs(t.bias), 0.01);
      EXPECT_LT(t.error, 0.035);
    }
    const Compared up = compared(name + "Iu", radiances(s, 0.85, {0.0, 0.0, 1.0}), published(name + "Iu.txt"));
    EXPECT_LT(std::abs(up.bias), 0.04);
    EXPECT_LT(up.error, 0.06);
    const Compared back =
        compared(name + "I602", radiances(s, 0.85, {-std::sqrt(0.75), 0.0, 0.5}), published(name + "I602.txt"));
    EXPECT_LT(std::abs(back.bias), 0.035);
    EXPECT_LT(back.error, 0.035);
  }
}

CloudCells broken_cloud(std::uint32_t nx, std::uint32_t ny, std::uint32_t nz) {
  CloudCells cells{.nx = nx, .ny = ny, .nz = nz, .cell_x = 0.12, .cell_y = 0.1, .cell_z = 0.05};
  std::mt19937 random(7);
  std::uniform_real_distribution<float> share(0.0F, 1.0F);
  for (std::size_t at = 0; at < cells.count(); ++at) {
    const float x = share(random);
    cells.extinction.push_back(x < 0.5F ? 0.0F : 40.0F * x);
  }
  return cells;
}

// All light of sky and ground that comes in goes out, where nothing absorbs.
TEST(CloudLight, LosesNoLight) {
  constexpr int kMany = 24;
  const CloudCells cells = broken_cloud(12, 10, 8);
  const Solved s = solve(cells, henyey_greenstein(0.85), 1.0, kMany);
  for (const int of : {kOfSky, kOfGround}) {
    EXPECT_NEAR((mean_of(fluxes(s, true, of)) + mean_of(fluxes(s, false, of))) / pi, 1.0, 1e-3);
  }
  EXPECT_NEAR(mean_of(fluxes(s, true, kOfSun)) + mean_of(fluxes(s, false, kOfSun)), 1.0, 0.02)
      << "rays of the sun, sampled";
  const Solved absorbing = solve(cells, henyey_greenstein(0.85, 0.9), 1.0, kMany);
  EXPECT_LT(mean_of(fluxes(absorbing, true, kOfSky)) + mean_of(fluxes(absorbing, false, kOfSky)), 0.95 * pi);
}

// A cloud that stands on its head lets as much light through from above as it did from below.
TEST(CloudLight, TurnsUpsideDown) {
  const CloudCells cells = broken_cloud(8, 6, 5);
  CloudCells turned = cells;
  const std::size_t plane = std::size_t{cells.nx} * cells.ny;
  for (std::uint32_t k = 0; k < cells.nz; ++k) {
    std::copy_n(&cells.extinction[k * plane], plane, &turned.extinction[(cells.nz - 1 - k) * plane]);
  }
  const Solved upright = solve(cells, henyey_greenstein(0.85), 1.0);
  const Solved over = solve(turned, henyey_greenstein(0.85), 1.0);
  EXPECT_NEAR(mean_of(fluxes(upright, true, kOfGround)) / mean_of(fluxes(over, false, kOfSky)), 1.0, 1e-5);
  EXPECT_GT(mean_of(fluxes(upright, true, kOfGround)), 0.2);
}

// How the source of an ordinate rises along its way through a cell: toward each face that the way goes to, half a cell
// off, where diffusion through both cells carries the same flux.
double host_slope(const CloudCells& c, const std::vector<double>& source, const physics::vec3& d, std::size_t at) {
  const std::size_t plane = std::size_t{c.nx} * c.ny;
  const std::size_t i = at % c.nx;
  const std::size_t j = at / c.nx % c.ny;
  const std::size_t k = at / plane;
  const std::size_t x = k * plane + j * c.nx + (d.x > 0.0 ? i + 1 : i + c.nx - 1) % c.nx;
  const std::size_t y = k * plane + (d.y > 0.0 ? j + 1 : j + c.ny - 1) % c.ny * c.nx + i;
  const bool ends = d.z > 0.0 ? k + 1 == c.nz : k == 0;
  const std::size_t z = ends ? at : d.z > 0.0 ? at + plane : at - plane;
  const auto toward = [&](std::size_t other, double part, double cell) {
    const auto here = static_cast<double>(c.extinction[at]);
    const auto there = static_cast<double>(c.extinction[other]);
    return here > 0.0 ? std::abs(part) * (source[other] - source[at]) * here / (here + there) * 2.0 / cell : 0.0;
  };
  const double slope = toward(x, d.x, c.cell_x) + toward(y, d.y, c.cell_y) + toward(z, d.z, c.cell_z);
  const double most = 2.0 * std::max(source[at], 0.0);
  const double way = physics::CloudPhysics{}.sweep_way(d, sides_of(c), axis_of(c, d));
  return std::clamp(slope * way, -most, most);
}

// Light that leaves the planes of cells along an ordinate.
struct HostFront {
  std::array<std::uint32_t, 2> counts;
  bool ends;  // rows do not repeat themselves; beyond them is `outside`
  double outside;
  std::vector<double> light;

  double value(double column, double row) const {
    const auto repeated = [](double at, std::uint32_t count) {
      return static_cast<std::size_t>(at - count * std::floor(at / count));
    };
    if (ends && (row < 0.0 || row >= counts[1])) {
      return outside;
    }
    return light[repeated(row, counts[1]) * counts[0] + repeated(column, counts[0])];
  }
};

// One sweep of the host in double, cell by cell along each ordinate: moments of the means. `fronts`: by ordinate, what
// the sweep before has left on the last plane.
std::vector<double> host_sweep(const Solved& s, const CloudIncident& incident,
                               const std::vector<std::vector<double>>& sources,
                               std::vector<std::vector<double>>& fronts) {
  physics::CloudPhysics p;
  const CloudCells& c = s.cells;
  const std::vector<physics::CloudOrdinate> ordinates = cloud_ordinates();
  const std::array<std::uint32_t, 3> counts{c.nx, c.ny, c.nz};
  const std::array<double, 3> cells{c.cell_x, c.cell_y, c.cell_z};
  const std::array<std::size_t, 3> strides{1, c.nx, std::size_t{c.nx} * c.ny};
  std::vector<double> moments(physics::kCloudMoments * c.count());
  for (std::size_t o = 0; o < ordinates.size(); ++o) {
    const physics::vec3 d = ordinates[o].direction;
    const std::array<double, 3> parts{d.x, d.y, d.z};
    const std::size_t axis = axis_of(c, d);
    const std::size_t u = axis == 0 ? 1 : 0;
    const std::size_t v = axis == 2 ? 1 : 2;
    const double way = p.sweep_way(d, sides_of(c), static_cast<std::uint32_t>(axis));
    HostFront front{{counts.at(u), counts.at(v)}, v == 2, d.z > 0.0 ? incident.below : incident.above, fronts[o]};
    front.light.resize(std::size_t{counts.at(u)} * counts.at(v));
    for (std::uint32_t n = 0; n < counts.at(axis); ++n) {
      std::vector<double> after(front.light.size());
      for (std::size_t at = 0; at < std::size_t{counts.at(u)} * counts.at(v); ++at) {
        const auto column = static_cast<double>(at % counts.at(u));
        const auto row = static_cast<double>(at / counts.at(u));
        const double entering = axis == 2 && n == 0
                                    ? front.outside
                                    : front.value(column + p.sweep_move(-parts.at(u) * way / cells.at(u), n),
                                                  row + p.sweep_move(-parts.at(v) * way / cells.at(v), n));
        const std::size_t plane = parts.at(axis) > 0.0 ? n : counts.at(axis) - 1 - n;
        const std::size_t cell =
            plane * strides.at(axis) + at % counts.at(u) * strides.at(u) + at / counts.at(u) * strides.at(v);
        const double depth = delta_scale(s.drops) * static_cast<double>(c.extinction[cell]) * way;
        const double slope = host_slope(c, sources[o], d, cell);
        const auto light = p.through_cell(entering, sources[o][cell], slope, depth);
        after[at] = light.leaving;
        for (std::size_t q = 0; q < 9; ++q) {
          moments[q * c.count() + cell] += light.mean * ordinates[o].weight * ordinates[o].harmonics[q];
        }
      }
      front.light = after;
    }
    fronts[o] = front.light;
  }
  return moments;
}

TEST(CloudLight, DeviceSweepsAsTheHostDoes) {
  constexpr int kSweeps = 3;
  const CloudCells cells = broken_cloud(9, 7, 6);
  const Solved s = solve(cells, henyey_greenstein(0.85), 0.6, kSweeps);
  const physics::CloudScattering scattering = cloud_scattering(s.drops, s.sun);
  const std::vector<physics::CloudOrdinate> ordinates = cloud_ordinates();
  for (const int of : {kOfSun, kOfSky, kOfGround}) {
    const CloudIncident incident{
        .name = {}, .sun = of == kOfSun, .above = of == kOfSky ? 1.0 : 0.0, .below = of == kOfGround ? 1.0 : 0.0};
    std::vector<double> moments(physics::kCloudMoments * cells.count());
    std::vector<double> changes(physics::kCloudMoments * cells.count());
    std::vector<std::vector<double>> fronts(ordinates.size(), std::vector<double>(cells.count()));
    for (const ChebyshevStep& step : chebyshev_steps(light_kept(cells, s.drops), kSweeps)) {
      std::vector<std::vector<double>> sources(ordinates.size(), std::vector<double>(cells.count()));
      for (std::size_t o = 0; o < sources.size(); ++o) {
        for (std::size_t n = 0; n < physics::kCloudMoments * cells.count(); ++n) {
          const std::size_t q = n / cells.count();
          const double lit = of == kOfSun ? static_cast<double>(s.beam.cells[n % cells.count()]) : 0.0;
          sources[o][n % cells.count()] +=
              (moments[n] + scattering.sunlight[q] * lit) * scattering.kept[q] * ordinates[o].harmonics[q];
        }
      }
      const std::vector<double> next = host_sweep(s, incident, sources, fronts);
      for (std::size_t n = 0; n < next.size(); ++n) {
        changes[n] = next[n] - moments[n] + changes[n] * step.momentum;
        moments[n] += changes[n] * step.step;
      }
    }
    double worst = 0.0;
    for (std::size_t n = 0; n < moments.size(); ++n) {
      worst =
          std::max(worst, std::abs(moments[n] - static_cast<double>(s.moments.at(static_cast<std::size_t>(of))[n])));
    }
    EXPECT_LT(worst, 1e-4) << "of moments up to 12, light " << of;
  }
}

// Even light on a thick slab that scatters evenly and absorbs nothing: the share that diffuses through is
// 4/3 / (depth + 2 x 0.7104) [CZ67]. Sources that are even in each cell let more through 12 cells.
TEST(CloudLight, ThickCellsCarryNoLightTooFar) {
  for (const std::uint32_t layers : {12U, 48U}) {
    CloudCells cells{.nx = 2, .ny = 2, .nz = layers, .cell_x = 1.0, .cell_y = 1.0, .cell_z = 1.0 / layers};
    constexpr float kDepth = 96.0F;
    cells.extinction.assign(cells.count(), kDepth);
    const Solved s = solve(cells, henyey_greenstein(0.0), 1.0, 400);
    const double expected = 4.0 / 3.0 / (static_cast<double>(kDepth) + 1.4208);
    EXPECT_NEAR(mean_of(fluxes(s, false, kOfSky)) / pi / expected, 1.0, layers < 48 ? 0.15 : 0.03) << layers;
  }
}

// The mean over each cell of what is linear between the cells' middles, by points.
TEST(CloudLight, MeansBetweenAreMeans) {
  const CloudCells cells = broken_cloud(7, 6, 5);
  CloudGrid grid;
  grid.nx = static_cast<int>(cells.nx);
  grid.ny = static_cast<int>(cells.ny);
  grid.nz = static_cast<int>(cells.nz);
  grid.cell_x = cells.cell_x;
  grid.cell_y = cells.cell_y;
  grid.top = cells.cell_z * cells.nz;
  grid.repeats = true;
  grid.extinction = cells.extinction;
  const CloudCells means = coarsened(cells, cells.nx, cells.ny, cells.nz, CellValues::middles);
  constexpr int kPoints = 8;
  for (std::size_t at = 0; at < cells.count(); ++at) {
    double sum = 0.0;
    for (int n = 0; n < kPoints * kPoints * kPoints; ++n) {
      const auto place = [&](std::size_t cell, int part) {
        return static_cast<double>(cell) + (part % kPoints + 0.5) / kPoints;
      };
      sum +=
          grid.at(place(at % cells.nx, n) * cells.cell_x, place(at / cells.nx % cells.ny, n / kPoints) * cells.cell_y,
                  place(at / cells.nx / cells.ny, n / kPoints / kPoints) * cells.cell_z);
    }
    EXPECT_NEAR(static_cast<double>(means.extinction[at]), sum / (kPoints * kPoints * kPoints), 1e-4) << at;
  }
}

// All orders of small turns taken for one, against the series by the closed moments g^l.
TEST(CloudPhase, TakesAllOrdersOfTurnsAsTheSeriesSays) {
  constexpr double kG = 0.85;
  constexpr double kAlbedo = 0.95;
  Cloud cloud;
  cloud.phase = CloudPhase::henyey_greenstein;
  cloud.phase_g = kG;
  cloud.single_scattering_albedo = kAlbedo;
  const Air air({cloud_medium(cloud, Spectrum{})}, Planet{});
  physics::Physics p = air.formulas();
  const std::vector<device::vec3> rows = cloud_phase_rows(p, kAlbedo, kCloudDegree);
  const double peak = kG * kG * kG;
  const double scale = 1.0 - kAlbedo * peak;
  for (const std::uint32_t row : {0U, 5U, 12U, 23U}) {
    const double share = row / 23.0;
    const double met = 9.0 * share * share / scale * kAlbedo;
    for (const std::size_t i : {0U, 40U, 90U, 140U, 300U, 500U, 900U}) {
      const double x = static_cast<double>(i) / (physics::kPhaseSamples - 1);
      const double angle = pi * x * x;
      double sum = 0.0;
      double before = 0.0;
      double now = 1.0;
      for (int l = 0; l < 400; ++l) {
        double chi = std::pow(kG, l);
        if (met > 0.0 && angle < 0.5 * pi) {
          // An order at a time: chi_l m, (chi_l m)^2 / 2, ...
          double order = 1.0;
          double orders = 0.0;
          for (int n = 1; n < 200; ++n) {
            order *= (l > kCloudDegree ? chi : peak) * met / n;
            orders += order;
          }
          chi = std::exp(-peak * met) * orders / met + (l > kCloudDegree ? 0.0 : chi - peak);
        }
        sum += (2 * l + 1) / (4.0 * pi) * chi * now;
        const double after = ((2 * l + 1) * std::cos(angle) * now - l * before) / (l + 1);
        before = now;
        now = after;
      }
      const double expected = std::max(sum, 0.0) * kAlbedo / scale;
      EXPECT_NEAR(static_cast<double>(rows[row * physics::kPhaseSamples + i].y), expected, 0.015 * expected + 1e-5)
          << "row " << row << ", " << angle * 180.0 / pi << " degrees";
    }
  }
}

TEST(CloudLight, CoarseCellsHoldAsMuch) {
  const CloudCells cells = broken_cloud(10, 7, 5);
  const CloudCells coarse = coarsened(cells, 4, 3, 2);
  const auto mean = [](const CloudCells& c) {
    return std::accumulate(c.extinction.begin(), c.extinction.end(), 0.0) / static_cast<double>(c.count());
  };
  EXPECT_EQ(coarse.nx, 4U);
  EXPECT_NEAR(mean(coarse), mean(cells), 1e-5);
  EXPECT_NEAR(coarse.cell_x * coarse.nx, cells.cell_x * cells.nx, 1e-12);
}

}  // namespace
}  // namespace airlight
