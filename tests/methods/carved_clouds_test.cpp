// Fields of clouds whose edges noise carves finer than their grid.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <numeric>
#include <vector>

#include "core/clouds/noise.h"
#include "tests/methods/cloud_scene.h"

namespace airlight::test {
namespace {

// A number of a sequence that is even over 0 to 1.
double even(std::uint32_t n, std::uint32_t axis) {
  return hashed(n, axis, 0, 77);
}

// The grid's means are those of its places: the light by means is that of as much water.
TEST(CarvedClouds, MeansHoldAsMuchWaterAsPlaces) {
  const CloudGrid grid = cloud_grid(carved_cloud(CloudKind::cumulus, 0.5));
  double cells = 0.0;
  for (const float value : grid.extinction) {
    cells += static_cast<double>(value) / static_cast<double>(grid.extinction.size());
  }
  constexpr std::uint32_t kPlaces = 400000;
  double places = 0.0;
  for (std::uint32_t n = 0; n < kPlaces; ++n) {
    places += grid.at(6.0 * even(n, 0), 6.0 * even(n, 1), 1.0 + even(n, 2)) / kPlaces;
  }
  std::printf("water by places over that by means: %+.2f %%\n", 100.0 * (places / cells - 1.0));
  EXPECT_NEAR(places / cells, 1.0, 0.02);
}

// Null collisions are unbiased as long as no place has more extinction than its block may have.
TEST(CarvedClouds, NoPlaceHasMoreThanItsBound) {
  Cloud cloud = carved_cloud(CloudKind::cumulus, 0.5);
  cloud.period = 3.0;
  cloud.detail = 0.025;  // a bound is the closer, the less the distance to the edge changes from cell to cell
  const CloudGrid grid = cloud_grid(cloud);
  int full = 0;
  for (std::uint32_t n = 0; n < 200000; ++n) {
    const double x = 3.0 * even(n, 0);
    const double y = 3.0 * even(n, 1);
    const double h = 1.0 + even(n, 2);
    const auto cell = [](double place, int count) {
      return (static_cast<int>(std::floor(place)) % count + count) % count;
    };
    const int i = cell((x - grid.west) / grid.cell_x, grid.nx);
    const int j = cell((y - grid.south) / grid.cell_y, grid.ny);
    const int k = std::min(static_cast<int>((h - grid.base) / grid.cell_z()), grid.nz - 1);
    double bound = 0.0;
    for (int part = 0; part < 27; ++part) {
      bound = std::max(
          bound, grid.most_around((i + part % 3 + grid.nx - 1) % grid.nx, (j + part / 3 % 3 + grid.ny - 1) % grid.ny,
                                  std::clamp(k + part / 9 - 1, 0, grid.nz - 1)));
    }
    const double value = grid.at(x, y, h);
    ASSERT_LE(value, bound) << x << " " << y << " " << h;
    full += value > 0.5 * bound && value > 0.0 ? 1 : 0;
  }
  EXPECT_GT(full, 2000);
}

// The march takes the noise's mean where the noise is too fine to be seen (shaders/shared/cloud_water.glsl).
TEST(CarvedClouds, TheNoiseHasItsMean) {
  const CarvingNoise noise = carving_noise();
  double mean = 0.0;
  for (const float value : noise.values) {
    ASSERT_GE(value, 0.0F);
    ASSERT_LE(value, 1.0F);
    mean += static_cast<double>(value) / static_cast<double>(noise.values.size());
  }
  EXPECT_NEAR(mean, 0.547, 0.001);
  EXPECT_NEAR(noise.at(0.3, 0.999, -0.2), noise.at(1.3, -0.001, 3.8), 1e-6);
}

// Light that a thin cloud scatters once along a ray, by short steps through the grid.
double scattered_once(const CloudGrid& grid, const physics::vec3& d, const physics::vec3& to_sun) {
  constexpr double kStep = 0.008;
  constexpr double kCamera = 0.2;
  double depth = 0.0;
  double light = 0.0;
  for (double t = (1.0 - kCamera) / d.z; t < (2.0 - kCamera) / d.z && depth < 9.0; t += kStep) {
    const physics::vec3 at = d * t + physics::vec3(0.0, 0.0, kCamera);
    const double here = kStep * grid.at(at.x, at.y, at.z);
    if (here > 0.0) {
      light += here * std::exp(-depth - 0.5 * here - water_depth_from(grid, at, to_sun, (2.0 - at.z) / to_sun.z));
      depth += here;
    }
  }
  return light * 1e-3 / (4.0 * std::numbers::pi);
}

// The device sees the edge that the grid tells the host and path-trace, and not its cells' means.
TEST(CarvedClouds, ThePictureShowsTheGridsEdge) {
  Scene scene = under_level_cloud(1.0, std::sin(radians(35.0)));
  scene.clouds = {carved_cloud(CloudKind::cumulus, 0.6)};
  scene.camera.altitude = 0.2;
  const CloudGrid grid = cloud_grid(scene.clouds.front());
  CloudGrid means = grid;
  means.edge.tiles = 0.0;
  const physics::vec3 to_sun(0.0, std::cos(radians(35.0)), std::sin(radians(35.0)));
  std::vector<Direction> directions;
  std::vector<double> carved;
  std::vector<double> coarse;
  for (int n = 0; n < 60; ++n) {
    const double elevation = radians(25.0 + 60.0 * even(static_cast<std::uint32_t>(n), 3));
    const double azimuth = radians(6.0 * n);
    const double across = std::cos(elevation);
    const physics::vec3 d(across * std::sin(azimuth), across * std::cos(azimuth), std::sin(elevation));
    directions.push_back({elevation, azimuth});
    carved.push_back(scattered_once(grid, d, to_sun));
    coarse.push_back(scattered_once(means, d, to_sun));
  }
  const std::vector<ProbeResult> results = probe_now(scene, directions);
  double seen = 0.0;
  double found = 0.0;
  double off_carved = 0.0;
  double off_coarse = 0.0;
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const double value = results[i].radiance[1] / scene.sun.irradiance[1];
    seen += carved[i];
    found += value;
    off_carved += std::abs(value - carved[i]);
    off_coarse += std::abs(value - coarse[i]);
  }
  std::printf("scattered once: bias %+.2f %%, %.2f %% off the edge, %.2f %% off the means\n",
              100.0 * (found / seen - 1.0), 100.0 * off_carved / seen, 100.0 * off_coarse / seen);
  EXPECT_NEAR(found / seen, 1.0, 0.05);
  EXPECT_LT(off_carved / seen, 0.15);
  EXPECT_GT(off_coarse, 2.0 * off_carved);
}

// The edges of coarse cells are those of the cloud, or lie amid it: the light that it sends back is much the same.
// Water that is spread over the whole of a cell 300 m high makes it 8 % brighter.
TEST(CarvedClouds, CoarseCellsHoldTheLightOfTheirWater) {
  Scene scene = under_level_cloud(1.0, std::sin(radians(50.0)));
  Cloud& cloud = scene.clouds.front();
  auto contents = std::make_shared<CloudFile>();
  contents->nx = contents->ny = 4;
  contents->nz = 48;
  contents->dx = contents->dy = 1.0;
  contents->dz = 0.05;
  contents->lowest = 1.0;
  cloud.base = 1.0;
  cloud.top = 3.4;
  for (int k = 0; k < contents->nz; ++k) {
    contents->extinction.insert(contents->extinction.end(), 16, k >= 9 && k < 39 ? 40.0F : 0.0F);
  }
  contents->identity = "level, of 30 layers amid 48";
  cloud.contents = contents;
  scene.camera.altitude = 5.0;
  std::vector<Direction> directions;
  for (const double elevation : {-85.0, -60.0, -40.0, -25.0}) {
    for (const double azimuth : {20.0, 90.0, 160.0}) {
      directions.push_back({radians(elevation), radians(azimuth)});
    }
  }
  const auto sum_with = [&](int levels) {
    Scene with = scene;
    with.render.parameters.find("cloud_lut")->second = TableSize{4, levels};
    double sum = 0.0;
    for (const ProbeResult& result : probe_now(with, directions)) {
      sum += result.radiance[1];
    }
    return sum;
  };
  const double fine = sum_with(48);
  const double coarse = sum_with(8);  // the cloud begins and ends in the middle of a cell
  std::printf("half-empty cells: %+.2f %%\n", 100.0 * (coarse / fine - 1.0));
  EXPECT_NEAR(coarse / fine, 1.0, 0.12);
}

double sum_of_picture(const Scene& scene) {
  double sum = 0.0;
  for (const float value : rgb_of(render_now(scene).radiance.rgba)) {
    sum += static_cast<double>(value);
  }
  return sum;
}

// All light of a field of cumulus without air, above black ground, under a low sun, by the cells that presets leave
// alone. Scattering is isotropic, with as much extinction as delta scaling leaves drops: less noise for the judge.
// Sunlit sides of heaps are somewhat too dark: in cells at the cloud's edge water is spread thin, and is lit less.
TEST(CarvedClouds, AFieldIsAsBrightAsByPathTrace) {
  Scene scene = among_cumulus(20.0, 0.35);
  scene.render.parameters.find("cloud_resolution")->second = std::string("full");
  const double ratio = sum_of_picture(scene) / sum_of_picture(by_path_trace(scene, 32));
  std::printf("a field of cumulus: %+.2f %%\n", 100.0 * (ratio - 1.0));
  EXPECT_NEAR(ratio, 1.0, 0.04);
}

// A broken sheet under so low a sun that one ray stands for each place of the table of its depths is 20 % too dark on
// its sunlit side: cells that spread the water of its edge let light out too soon.
TEST(CarvedClouds, ASheetUnderALowSunIsAsBrightAsByPathTrace) {
  Scene scene = among_sheets(6.0, 0.6);
  EXPECT_GT(cloud_grid(scene.clouds.front()).edge.tiles, 0.0);
  scene.render.parameters.find("cloud_resolution")->second = std::string("full");
  const double ratio = sum_of_picture(scene) / sum_of_picture(by_path_trace(scene, 64));
  std::printf("a broken sheet: %+.2f %%\n", 100.0 * (ratio - 1.0));
  EXPECT_NEAR(ratio, 1.0, 0.23);
}

// Sums of green over blocks of pixels.
std::vector<double> blocks_of(const Scene& scene) {
  constexpr int kSide = 3;
  const std::vector<float> values = rgb_of(render_now(scene).radiance.rgba);
  const int across = scene.image.width / kSide;
  std::vector<double> blocks(static_cast<std::size_t>(across * (scene.image.height / kSide)));
  for (int y = 0; y < scene.image.height; ++y) {
    for (int x = 0; x < scene.image.width; ++x) {
      blocks[static_cast<std::size_t>(y / kSide * across + x / kSide)] +=
          static_cast<double>(values[static_cast<std::size_t>(3 * (y * scene.image.width + x) + 1)]);
    }
  }
  return blocks;
}

// Light falls toward sides that the sun does not reach. Were it looked up as even from the outermost cells with water
// outward, the darkest quarter of the blocks would be 1.18 times as bright beside the brightest as it is.
TEST(CarvedClouds, ShadedSidesAreDark) {
  Scene scene = among_cumulus(25.0, 0.25);
  scene.clouds.front().seed = 17;
  scene.camera.azimuth = radians(220.0);
  scene.render.parameters.find("cloud_resolution")->second = std::string("full");
  const std::vector<double> found = blocks_of(scene);
  const std::vector<double> truth = blocks_of(by_path_trace(scene, 96));
  std::vector<std::size_t> seen;
  const double least = 0.02 * *std::ranges::max_element(truth);
  for (std::size_t i = 0; i < truth.size(); ++i) {
    if (truth[i] > least) {
      seen.push_back(i);
    }
  }
  std::ranges::sort(seen, {}, [&](std::size_t i) { return truth[i]; });
  const auto ratio = [&](std::size_t from, std::size_t to) {
    double sum = 0.0;
    double expected = 0.0;
    for (std::size_t n = from; n < to; ++n) {
      sum += found[seen[n]];
      expected += truth[seen[n]];
    }
    return sum / expected;
  };
  const double dark = ratio(0, seen.size() / 4);
  const double bright = ratio(3 * seen.size() / 4, seen.size());
  std::printf("%zu blocks, the darkest quarter %+.1f %%, the brightest %+.1f %%\n", seen.size(), 100.0 * (dark - 1.0),
              100.0 * (bright - 1.0));
  EXPECT_LT(dark / bright, 1.14);
}

// Clouds are lit by the sky from above their tops and by ground and air from below their bases. The air between tops
// and bases is shaded and ends at the next cloud: were all that it sends to a level plane counted too, the darkest
// third of a field's pixels under a low sun would be 14 % too bright in green and blue.
TEST(CarvedClouds, ShadeInAirIsDark) {
  Scene scene = with_method(earth(), *find_method("orders"));
  scene.sun.elevation = radians(12.0);
  scene.sun.azimuth = radians(130.0);
  scene.sun.disc.visible = false;
  scene.camera.altitude = 0.1;
  scene.camera.azimuth = radians(180.0);
  scene.camera.pitch = radians(24.0);
  scene.camera.vertical_fov = radians(40.0);
  scene.planet.ground_albedo = {0.07, 0.09, 0.05};
  scene.image = {24, 14};
  const std::vector<float> clear = rgb_of(render_now(scene).radiance.rgba);
  scene.clouds = among_cumulus(12.0, 0.35).clouds;
  scene.clouds.front().seed = 13;
  scene.clouds.front().phase_g = kAsymmetryOfDrops;
  scene.render.parameters.find("cloud_resolution")->second = std::string("full");
  const std::vector<float> found = rgb_of(render_now(scene).radiance.rgba);
  const std::vector<float> truth = rgb_of(render_now(by_path_trace(scene, 96)).radiance.rgba);
  scene.clouds.front().single_scattering_albedo = 0.0;
  const std::vector<float> black = rgb_of(render_now(scene).radiance.rgba);
  std::vector<std::size_t> clouds;  // pixels
  for (std::size_t i = 0; i < found.size() / 3; ++i) {
    if (black[3 * i] < 0.35F * clear[3 * i]) {
      clouds.push_back(i);
    }
  }
  std::ranges::sort(clouds, {}, [&](std::size_t i) { return found[3 * i + 1]; });
  for (std::size_t c = 0; c < 3; ++c) {
    double sum = 0.0;
    double expected = 0.0;
    for (std::size_t n = 0; n < clouds.size() / 3; ++n) {
      sum += static_cast<double>(found[3 * clouds[n] + c]);
      expected += static_cast<double>(truth[3 * clouds[n] + c]);
    }
    std::printf("the darkest third of %zu pixels, channel %zu: %+.1f %%\n", clouds.size(), c,
                100.0 * (sum / expected - 1.0));
    EXPECT_NEAR(sum / expected, 1.0, c == 0 ? 0.18 : 0.11) << c;
  }
}

// Ground below a broken sheet without air, seen straight down in blocks of pixels: it gets what falls on it. By the
// mean of the field it would be 9.9 % off.
TEST(CarvedClouds, LightTheGroundWhereTheyStand) {
  Scene scene = among_sheets(30.0, 0.7);
  scene.planet.ground_albedo = {0.3, 0.3, 0.3};
  scene.camera.altitude = 0.6;
  scene.camera.pitch = radians(-90.0);
  scene.camera.vertical_fov = radians(100.0);
  const std::vector<double> found = blocks_of(scene);
  const std::vector<double> truth = blocks_of(by_path_trace(scene, 96));
  double error = 0.0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    error += std::abs(found[i] / truth[i] - 1.0) / static_cast<double>(truth.size());
  }
  std::printf(
      "%zu blocks of ground: %.1f %% off, in all %+.1f %%\n", truth.size(), 100.0 * error,
      100.0 *
          (std::accumulate(found.begin(), found.end(), 0.0) / std::accumulate(truth.begin(), truth.end(), 0.0) - 1.0));
  EXPECT_LT(error, 0.085);
}

// What bright ground adds to a dense field, whose shadows lie on the ground below it. It would be nearly twice as much,
// were the ground everywhere as bright as in its mean.
TEST(CarvedClouds, AreLitByGroundAmongShadows) {
  constexpr double kAlbedo = 0.3;
  Scene black = among_cumulus(30.0, 0.45);
  black.camera.azimuth = radians(320.0);
  black.camera.pitch = radians(22.0);
  black.clouds.front().seed = 12;
  Scene bright = black;
  bright.planet.ground_albedo = {kAlbedo, kAlbedo, kAlbedo};
  const double found = sum_of_picture(bright) - sum_of_picture(black);
  const double expected = sum_of_picture(by_path_trace(bright, 64)) - sum_of_picture(by_path_trace(black, 64));
  std::printf("light of the ground: %+.2f %%\n", 100.0 * (found / expected - 1.0));
  EXPECT_NEAR(found / expected, 1.0, 0.2);
}

// All light of the air over black heaps against path-trace. Blue is 6 % too dark where the share of light scattered
// more than once passes over the air between the heaps and over the way from them.
TEST(CarvedClouds, ShadeLightScatteredMoreThanOnce) {
  Scene scene = with_method(earth(), *find_method("orders"));
  scene.media.resize(1);  // molecules
  scene.planet.ground_albedo = {0.06, 0.08, 0.04};
  scene.sun.elevation = radians(60.0);
  scene.sun.azimuth = radians(130.0);
  scene.sun.disc.visible = false;
  scene.camera.altitude = 2.5;
  scene.camera.pitch = radians(25.0);
  scene.camera.vertical_fov = radians(45.0);
  scene.image = {32, 18};
  Cloud cloud = carved_cloud(CloudKind::cumulus, 0.35);
  cloud.top = 2.4;
  cloud.cell = 2.0;
  cloud.period = 16.0;
  cloud.water = 0.3;
  cloud.single_scattering_albedo = 0.0;
  scene.clouds = {cloud};
  const std::vector<float> found = rgb_of(render_now(scene).radiance.rgba);
  scene = with_method(scene, *find_method("path-trace"));
  scene.render.parameters.find("samples")->second = 64;
  const std::vector<float> judge = rgb_of(render_now(scene).radiance.rgba);
  expect_means(found, judge, {0.025, 0.025, 0.025});
}

// The air before black ground below dense black heaps, in haze under a low sun. What haze scatters a second time came
// mostly from about the sun, and the heaps shade it as they shade the sun. Were it taken as even over the sky, so that
// gaps anywhere let it through, red and green would be 9 to 10 % too bright.
TEST(CarvedClouds, ShadeLightFromAboutTheSun) {
  Scene scene = with_method(earth(), *find_method("orders"));
  scene.media.at(1).scattering = {0.05, 0.06, 0.07};  // 1/km: haze of depth 0.06 to 0.08
  scene.planet.ground_albedo = {};
  scene.sun.elevation = radians(12.0);
  scene.sun.azimuth = radians(130.0);
  scene.sun.disc.visible = false;
  scene.camera.altitude = 0.1;
  scene.camera.azimuth = radians(180.0);
  scene.camera.pitch = radians(-4.0);
  scene.camera.vertical_fov = radians(6.0);
  scene.image = {32, 6};
  scene.clouds = among_cumulus(12.0, 0.4).clouds;
  scene.clouds.front().seed = 13;
  scene.clouds.front().single_scattering_albedo = 0.0;
  const std::vector<float> found = rgb_of(render_now(scene).radiance.rgba);
  const std::vector<float> truth = rgb_of(render_now(by_path_trace(scene, 256)).radiance.rgba);
  expect_means(found, truth, {0.07, 0.07, 0.05});
}

}  // namespace
}  // namespace airlight::test
