// Clouds by path-trace against brute force, adding and doubling, and the intercomparison of 3-D radiation codes.

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <numbers>

#include "core/clouds/noise.h"
#include "core/methods/path_trace/cloud_trace.h"
#include "path_trace_scene.h"
#include "slab.h"
#include "tests/methods/column_light.h"

namespace airlight {
namespace {

using physics::vec3;

constexpr double kRadius = 60.0;  // km: a planet so small that all is bent

// Uneven in all directions, with holes, of a number of cells that is no multiple of the blocks'.
CloudGrid uneven(bool repeats, bool smooth) {
  CloudGrid grid;
  grid.nx = 10;
  grid.ny = 7;
  grid.nz = 6;
  grid.cell_x = 0.4;
  grid.cell_y = 0.5;
  grid.base = 1.0;
  grid.top = 2.2;
  grid.west = -1.7;
  grid.south = -2.1;
  grid.repeats = repeats;
  grid.smooth = smooth;
  for (std::uint32_t k = 0; k < 10 * 7 * 6; ++k) {
    const double value = hashed(k, 0, 0, 5);
    grid.extinction.push_back(value < 0.5 ? 0.0F : static_cast<float>(3.0 * (value - 0.5)));
  }
  return grid;
}

struct Sight {
  const char* name;
  vec3 from;  // from the planet's centre, km
  vec3 direction;
  double limit;
};

const std::vector<Sight> kSights{
    {"up from the ground", {0.3, kRadius, -0.2}, {0.3, 0.9, 0.2}, 100.0},
    {"level below the base", {0.0, kRadius + 0.2, 0.0}, {0.8, 0.03, -0.6}, 40.0},
    {"straight down", {1.0, kRadius + 5.0, 0.7}, {0.0, -1.0, 0.0}, 5.0},
    {"from space past the ground", {-30.0, kRadius + 6.0, 3.0}, {1.0, -0.12, -0.05}, 100.0},
    {"within the cloud, westward", {0.0, kRadius + 1.5, 0.0}, {-0.9, 0.1, 0.3}, 30.0},
    {"within the cloud, dipping to below it", {0.0, kRadius + 1.3, 0.0}, {0.1, -0.08, 1.0}, 14.0},
    {"along north", {0.1, kRadius + 1.1, 3.0}, {0.0, 0.02, -1.0}, 9.0},
    {"cut short", {0.0, kRadius + 0.9, 0.0}, {0.2, 1.0, 0.1}, 0.7}};

// Points that are kept are those that are made when asked for, in grids that repeat themselves upward and in others.
TEST(Clouds, NoiseOfKeptPointsIsTheSame) {
  for (const int levels : {0, 5}) {
    const NoisePeriod period{7, 4, levels};
    const double most = levels > 0 ? 5.0 : 2.6;
    const StrewnPoints points(period, most, 11);
    const CellOctaves octaves(period, most, 3, 11);
    for (std::uint32_t n = 0; n < 3000; ++n) {
      const double x = 20.0 * hashed(n, 0, 0, 3) - 10.0;
      const double y = 20.0 * hashed(n, 1, 0, 3) - 10.0;
      const double z = most * hashed(n, 2, 0, 3);
      ASSERT_EQ(points.noise(x, y, z), cell_noise(x, y, z, period, 11)) << x << " " << y << " " << z;
      ASSERT_EQ(octaves.at(x, y, z), cell_octaves(x, y, z, period, 3, 11)) << x << " " << y << " " << z;
    }
  }
}

// The integral of the grid's extinction along the ray by short steps, each place found anew.
double brute_force_depth(const CloudGrid& grid, const Sight& sight) {
  constexpr int kSteps = 200000;
  const vec3 direction = normalize(sight.direction);
  double sum = 0.0;
  for (int k = 0; k < kSteps; ++k) {
    const vec3 p = sight.from + direction * (sight.limit * (k + 0.5) / kSteps);
    sum += grid.at(kRadius * p.x / p.y, -kRadius * p.z / p.y, length(p) - kRadius);
  }
  return sum * sight.limit / kSteps;
}

TEST(CloudTrace, FlightsAndTransmittanceMeetTheOpticalDepth) {
  constexpr int kCount = 20000;
  for (const bool repeats : {true, false}) {
    for (const bool smooth : {true, false}) {
      const auto grid = std::make_shared<const CloudGrid>(uneven(repeats, smooth));
      const TracedCloud cloud(grid, kRadius);
      int met = 0;
      for (const Sight& sight : kSights) {
        const vec3 direction = normalize(sight.direction);
        const double depth = brute_force_depth(*grid, sight);
        const double passes = std::exp(-depth);
        met += depth > 0.0 ? 1 : 0;
        // By steps across the edges of cells, of which there are few here.
        const double bound = smooth ? 0.003 * depth + 1e-6 : 0.06 * depth + 0.005;
        EXPECT_NEAR(cloud.optical_depth(sight.from, direction, sight.limit), depth, bound) << sight.name;
        Random random(1, 2, 3);
        double share = 0.0;
        double transmittance = 0.0;
        double squares = 0.0;
        for (int k = 0; k < kCount; ++k) {
          share += cloud.collide(sight.from, direction, sight.limit, random) ? 0.0 : 1.0 / kCount;
          const double t = cloud.transmittance(sight.from, direction, sight.limit, random);
          transmittance += t / kCount;
          squares += t * t / kCount;
        }
        const double flights = std::sqrt(passes * (1.0 - passes) / kCount);
        const double ratios = std::sqrt(std::max(squares - transmittance * transmittance, 0.0) / kCount);
        EXPECT_NEAR(share, passes, 4.0 * flights + 1e-4) << sight.name;
        EXPECT_NEAR(transmittance, passes, 4.0 * ratios + 1e-4) << sight.name;
      }
      EXPECT_GE(met, repeats ? 8 : 5);
    }
  }
}

// The even slab of the literature, as a cloud: in cells and between points.
TEST(PathTraceClouds, ALevelCloudMeetsAddingAndDoubling) {
  constexpr int kSun = 14;
  const Slab judge({4.0, 0.98, henyey_greenstein_moments(0.75, 48), 0.3}, 24, kSun);
  for (const bool cells : {true, false}) {
    Scene scene = slab(0.0, 1.0, PhaseFunction::isotropic, 0.0);
    scene.planet.ground_albedo = {0.3, 0.3, 0.3};
    auto contents = std::make_shared<CloudFile>();
    contents->nx = contents->ny = 5;
    contents->nz = 2;
    contents->dx = contents->dy = 0.7;
    contents->dz = 5.0;
    contents->lowest = 2.5;
    contents->in_cells = cells;
    contents->extinction.assign(5 * 5 * 2, 0.4F);
    Cloud cloud;
    cloud.kind = CloudKind::volume;
    cloud.contents = contents;
    cloud.base = 0.0;
    cloud.top = 10.0;
    cloud.single_scattering_albedo = 0.98;
    cloud.phase = CloudPhase::henyey_greenstein;
    cloud.phase_g = 0.75;
    scene.clouds = {cloud};
    scene.sun.elevation = std::asin(judge.nodes()[kSun]);
    set(scene, "samples", 16384);
    for (const bool top : {true, false}) {
      scene.camera.altitude = top ? 10.0 : 0.0;
      std::vector<Direction> directions;
      for (const std::size_t node : {4U, 12U, 23U}) {
        directions.push_back({(top ? -1.0 : 1.0) * std::asin(judge.nodes()[node]), 2.0});
      }
      const HostPicture picture = trace(scene, directions);
      int k = 0;
      for (const std::size_t node : {4U, 12U, 23U}) {
        const double expected = top ? judge.reflected(node, 2.0) : judge.transmitted(node, 2.0);
        const double error = picture.standard_error.at(k, 0)[1];
        EXPECT_LT(error, 0.03 * expected);
        EXPECT_NEAR(picture.radiance.at(k, 0)[1], expected, 0.002 * expected + 4.0 * error) << top << node;
        ++k;
      }
    }
  }
}

// Case 1 of the intercomparison of 3-D radiation codes (Cahalan and others 2005), means of its codes' consensus over
// the 32 columns: the sun at the zenith, and 60 degrees from it.
TEST(PathTraceClouds, TheStepCloudHasThePublishedMeans) {
  struct Published {
    double sun;
    double reflectance;
    double zenith;
  };
  for (const Published& published : {Published{90.0, 0.32760, 0.25640}, Published{30.0, 0.58044, 0.40607}}) {
    const test::ColumnLight light = test::column_light({test::step_cloud(), published.sun}, 400, 2);
    const double reflectance = test::mean_of(light.reflectance);
    const double transmittance = test::mean_of(light.transmittance);
    EXPECT_LT(light.reflectance_error, 0.01);
    EXPECT_NEAR(reflectance, published.reflectance, 0.002 * published.reflectance + 4.0 * light.reflectance_error);
    EXPECT_NEAR(transmittance, 1.0 - published.reflectance, 0.002 + 4.0 * light.transmittance_error);
    EXPECT_NEAR(test::mean_of(light.zenith), published.zenith, 0.01 * published.zenith + 4.0 * light.zenith_error);
  }
}

// What is neither sent back nor let through is absorbed: three estimates of their own.
TEST(PathTraceClouds, TheStepCloudLosesWhatItAbsorbs) {
  const test::ColumnLight light = test::column_light({test::step_cloud(), 30.0, 0.9}, 300, 2);
  const double sum =
      test::mean_of(light.reflectance) + test::mean_of(light.transmittance) + test::mean_of(light.absorptance);
  const double error = std::hypot(light.reflectance_error, light.transmittance_error, light.absorptance_error);
  EXPECT_LT(error, 0.01);
  EXPECT_GT(test::mean_of(light.absorptance), 0.2);
  EXPECT_NEAR(sum, 1.0, 4.0 * error);
}

// A field covers the share of the sky that it is asked to (along the columns' middle lines), repeats itself without a
// seam, and stays inside its heights.
TEST(CloudFields, CoverWhatTheyAreAskedTo) {
  for (const CloudKind kind : {CloudKind::cumulus, CloudKind::stratocumulus, CloudKind::cirrus}) {
    Cloud cloud;
    cloud.kind = kind;
    cloud.cover = 0.4;
    cloud.base = 1.0;
    cloud.top = 2.0;
    cloud.cell = 1.5;
    cloud.period = 7.3;
    cloud.detail = 0.1;
    cloud.water = 0.5;
    cloud.shear = 0.3;
    cloud.effective_radius = 10.0;
    const CloudGrid grid = cloud_grid(cloud);
    int covered = 0;
    double most = 0.0;
    double step = 0.0;
    double seam = 0.0;
    for (int j = 0; j < grid.ny; ++j) {
      for (int i = 0; i < grid.nx; ++i) {
        double deepest = 0.0;
        for (int k = 0; k < grid.nz; ++k) {
          const int next = i + 1 == grid.nx ? 0 : i + 1;
          const float here = grid.extinction[grid.index(i, j, k)];
          const auto jump = static_cast<double>(std::abs(here - grid.extinction[grid.index(next, j, k)]));
          (next == 0 ? seam : step) += jump;
          deepest = std::max(deepest, grid.at(grid.west + (i + 0.5) * grid.cell_x, grid.south + (j + 0.5) * grid.cell_y,
                                              grid.base + (k + 0.5) * grid.cell_z()));
        }
        covered += deepest > 1e-5 ? 1 : 0;
        most = std::max(most, deepest);
      }
    }
    EXPECT_NEAR(static_cast<double>(covered) / (grid.nx * grid.ny), 0.4, 0.001);
    // The highest cells of a carved field are its densest, and hold no more than a little of them.
    const double densest = kind == CloudKind::cirrus ? 75.0 / 0.917 : 75.0;
    EXPECT_LE(most, densest + 1e-3);
    EXPECT_GE(most, grid.edge.tiles > 0.0 ? 0.8 * densest : densest - 1e-3);
    // Neighbours across the seam differ no more than neighbours elsewhere do on the mean.
    EXPECT_LT(seam, 2.5 * step / (grid.nx - 1));
    EXPECT_EQ(grid.at(0.0, 0.0, 0.99), 0.0);
    EXPECT_EQ(grid.at(0.0, 0.0, 2.01), 0.0);
    EXPECT_NEAR(grid.at(0.33, -1.2, 1.5), grid.at(0.33 - 2 * 7.3, -1.2 + 7.3, 1.5), 1e-6);
  }
}

}  // namespace
}  // namespace airlight
