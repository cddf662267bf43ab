// Clouds in pictures by `orders`: level clouds against adding and doubling, what stands behind them, and what is
// refused.

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <numbers>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

#include "core/air/scene_block.h"
#include "core/base/error.h"
#include "core/methods/ready.h"
#include "core/render/render.h"
#include "core/scene/preset.h"
#include "core/scene/resolve.h"
#include "tests/methods/cloud_scene.h"
#include "tests/methods/render_fixture.h"
#include "tests/methods/slab.h"

namespace airlight::test {
namespace {

// Above and below, in directions all around, close to the sun as well; thick clouds and thin ones, by a high sun and a
// low one.
TEST(CloudPicture, LevelCloudsMeetAddingAndDoubling) {
  constexpr int kNodes = 24;
  for (const double depth : {0.5, 4.0, 16.0}) {
    for (const int sun : {5, 10, 20}) {
      const Slab judge({depth, 1.0, henyey_greenstein_moments(kAsymmetryOfDrops, 48), 0.0}, kNodes, sun);
      const double mu_sun = judge.nodes()[static_cast<std::size_t>(sun)];
      double error = 0.0;
      double found = 0.0;
      double expected = 0.0;
      double near_sun = 0.0;  // the largest error within 25 degrees
      int count = 0;
      for (const bool above : {true, false}) {
        Scene scene = under_level_cloud(depth, mu_sun);
        scene.camera.altitude = above ? 5.0 : 0.0;
        std::vector<Direction> directions;
        std::vector<double> truth;
        for (const std::size_t node : {8U, 12U, 16U, 20U, 23U}) {
          for (const double azimuth : {0.02, 0.4, 1.6, 2.9}) {
            directions.push_back({std::asin(judge.nodes()[node]) * (above ? -1.0 : 1.0), azimuth});
            truth.push_back(above ? judge.reflected(node, azimuth) : judge.transmitted(node, azimuth));
          }
        }
        const std::vector<ProbeResult> results = probe_now(scene, directions);
        for (std::size_t i = 0; i < truth.size(); ++i) {
          const double value = results[i].radiance[1] / scene.sun.irradiance[1];
          const double off = std::abs(value / truth[i] - 1.0);
          const double mu = std::sin(directions[i].elevation);
          const double across = std::sqrt((1.0 - mu * mu) * (1.0 - mu_sun * mu_sun)) * std::cos(directions[i].azimuth);
          near_sun = mu * mu_sun + across > std::cos(radians(25.0)) ? std::max(near_sun, off) : near_sun;
          error += off;
          found += value;
          expected += truth[i];
          ++count;
        }
      }
      std::printf("depth %4.1f, sun %.2f: bias %+.2f %%, mean relative error %.2f %%, near the sun at most %.1f %%\n",
                  depth, mu_sun, 100.0 * (found / expected - 1.0), 100.0 * error / count, 100.0 * near_sun);
      // Thin clouds send little light to the sides, and harmonics of degree 2 do not hold it. The light of a low sun
      // ends in the uppermost part of the first layer of cells, all of which counts as lit.
      const bool low = sun == 5;
      EXPECT_LT(error / count, low ? 0.17 : depth < 1.0 ? 0.08 : 0.04) << depth << " " << sun;
      EXPECT_NEAR(found / expected, 1.0, low ? 0.11 : depth < 1.0 ? 0.06 : 0.03) << depth << " " << sun;
      EXPECT_LT(near_sun, low ? 0.14 : 0.09) << depth << " " << sun;
    }
  }
}

// A level cloud below molecules, seen from above them. They send a seventh of the blue light that rises from it down on
// it again: without that light it would be 2, 4 and 9 % darker.
TEST(CloudPicture, GetsLightThatTheAirAboveSendsBack) {
  Scene scene = under_level_cloud(16.0, std::sin(radians(55.0)));
  scene.media = {medium(PhaseFunction::rayleigh, 0.0, {0.006, 0.0135, 0.033}, {0.0, 0.0, 0.0}, exponential(8.0))};
  scene.camera.altitude = 2.5;
  scene.camera.azimuth = radians(120.0);
  scene.camera.pitch = radians(-50.0);
  scene.camera.vertical_fov = radians(60.0);
  scene.image = {16, 9};
  const std::vector<float> found = rgb_of(render_now(scene).radiance.rgba);
  const std::vector<float> truth = rgb_of(render_now(by_path_trace(scene, 512)).radiance.rgba);
  expect_means(found, truth, {0.025, 0.025, 0.025});
}

// Sunlight scattered once, by a matter that scatters little: against the integral of the grid's own extinction along
// the ray and toward the sun.
TEST(CloudPicture, SunlightScatteredOnceIsItsIntegral) {
  constexpr double kAlbedo = 1e-3;
  constexpr double kStep = 0.016;
  Scene scene = under_level_cloud(1.0, std::sin(radians(35.0)));
  Cloud& cloud = scene.clouds.front();
  cloud.contents = field_of_balls();
  cloud.phase_g = 0.0;
  cloud.single_scattering_albedo = kAlbedo;
  scene.camera.altitude = 0.2;
  const CloudGrid grid = cloud_grid(cloud);
  const physics::vec3 to_sun(0.0, std::cos(radians(35.0)), std::sin(radians(35.0)));  // azimuth 0: north
  std::vector<Direction> directions;
  std::vector<double> truth;
  double seen = 0.0;
  for (const double elevation : {25.0, 40.0, 55.0, 70.0, 85.0}) {
    for (const double azimuth : {10.0, 100.0, 170.0, 250.0}) {
      const double across = std::cos(radians(elevation));
      const physics::vec3 d(across * std::sin(radians(azimuth)), across * std::cos(radians(azimuth)),
                            std::sin(radians(elevation)));
      double depth = 0.0;
      double light = 0.0;
      for (double t = 0.5 / d.z; t < 2.0 / d.z && depth < 9.0; t += kStep) {
        const physics::vec3 at = d * t + physics::vec3(0.0, 0.0, 0.2);
        const double here = kStep * grid.at(at.x, at.y, at.z);
        if (here > 0.0) {
          light += here * std::exp(-depth - 0.5 * here - water_depth_from(grid, at, to_sun, (2.0 - at.z) / to_sun.z));
          depth += here;
        }
      }
      directions.push_back({radians(elevation), radians(azimuth)});
      truth.push_back(light * kAlbedo / (4.0 * std::numbers::pi));
      seen += truth.back();
    }
  }
  const std::vector<ProbeResult> results = probe_now(scene, directions);
  double error = 0.0;
  double found = 0.0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const double value = results[i].radiance[1] / scene.sun.irradiance[1];
    found += value;
    error += std::abs(value - truth[i]);
    if (truth[i] > seen / static_cast<double>(truth.size())) {
      EXPECT_NEAR(value, truth[i], 0.3 * truth[i]) << i;
    }
  }
  std::printf("scattered once: bias %+.2f %%, error %.2f %%\n", 100.0 * (found / seen - 1.0), 100.0 * error / seen);
  EXPECT_NEAR(found / seen, 1.0, 0.08);
  EXPECT_LT(error / seen, 0.09);
}

// The cloud's shadow on white ground, which shows the table of the sun's depth alone, against the integral through the
// grid from each place on the ground.
TEST(CloudPicture, ItsShadowIsTheSunsDepth) {
  Scene scene = under_level_cloud(1.0, std::sin(radians(35.0)));
  Cloud& cloud = scene.clouds.front();
  cloud.contents = field_of_balls();
  cloud.phase_g = 0.0;
  cloud.single_scattering_albedo = 1e-3;
  scene.camera.altitude = 0.2;
  scene.planet.ground_albedo = {1.0, 1.0, 1.0};
  const CloudGrid grid = cloud_grid(cloud);
  const physics::vec3 to_sun(0.0, std::cos(radians(35.0)), std::sin(radians(35.0)));
  std::vector<Direction> directions;
  std::vector<double> truth;
  for (int i = 0; i < 60; ++i) {
    const double elevation = -9.0 - i % 12 * 6.0;
    const double azimuth = 10.0 + i * 67.0;
    const double reach = 0.2 / std::tan(radians(-elevation));
    const physics::vec3 place(reach * std::sin(radians(azimuth)), reach * std::cos(radians(azimuth)), 0.0);
    directions.push_back({radians(elevation), radians(azimuth)});
    truth.push_back(std::exp(-water_depth_from(grid, place, to_sun, 2.0 / to_sun.z)));
  }
  const std::vector<ProbeResult> results = probe_now(scene, directions);
  double error = 0.0;
  double seen = 0.0;
  int shaded = 0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const double lit = results[i].radiance[1] / scene.sun.irradiance[1] * std::numbers::pi / to_sun.z;
    error += std::abs(lit - truth[i]);
    seen += truth[i];
    shaded += truth[i] > 0.02 && truth[i] < 0.98 ? 1 : 0;
  }
  std::printf("shadow: %d of 60 between light and shade, error %.2f %%\n", shaded, 100.0 * error / seen);
  EXPECT_GE(shaded, 5);
  EXPECT_LT(error / seen, 0.012);  // linear steps through the table: 0.021
}

// The table of the sun's depth outlives the program on a processor, and the picture is the same to the bit: of a carved
// field, and of one that is thin all over.
TEST(CloudPicture, TheSunsDepthIsKeptForLaterStarts) {
  std::string name = (std::filesystem::temp_directory_path() / "airlight-depths-XXXXXX").string();
  ASSERT_NE(::mkdtemp(name.data()), nullptr);
  Scene carved = among_cumulus(30.0, 0.35);
  carved.clouds = {carved_cloud(CloudKind::cumulus, 0.35)};
  Scene thin = among_cumulus(20.0, 0.35);
  Cloud& veil = thin.clouds.front();
  veil = under_level_cloud(1.0, 1.0).clouds.front();
  auto contents = std::make_shared<CloudFile>(*field_of_balls());
  for (float& extinction : contents->extinction) extinction *= 0.1F;
  contents->identity = "thin balls";
  veil.contents = contents;
  struct Start {
    bool follows_rays;  // of the sun
    std::vector<float> picture;
  };
  const auto start = [&name](const Scene& scene, std::optional<bool> stores) {
    Executor own{DeviceOptions{.cache_folder = name, .stores_tables = true, .stores_buffers = stores}};
    const Rendering rendering = render([&]() -> Executor& { return own; }, scene, {});
    const bool follows = std::ranges::any_of(
        rendering.passes, [](const PassTiming& pass) { return pass.name.find("cloud_shadow") != std::string::npos; });
    return Start{follows, rendering.radiance.rgba};
  };
  for (const Scene& scene : {carved, thin}) {
    const Start first = start(scene, {});
    EXPECT_TRUE(first.follows_rays);
    const Start second = start(scene, {});
    EXPECT_EQ(second.follows_rays, !executor().device().is_cpu);
    EXPECT_EQ(second.picture, first.picture);
    const Start as_a_gpu = start(scene, false);
    EXPECT_TRUE(as_a_gpu.follows_rays);
    EXPECT_EQ(as_a_gpu.picture, first.picture);
    Scene later = scene;
    later.sun.azimuth += radians(1.0);
    EXPECT_TRUE(start(later, {}).follows_rays) << "another sun";
  }
  std::filesystem::remove_all(name);
}

// The light of the air among black balls of cloud, by listed rays and by froxels of a picture.
struct AirAmongBalls {
  double left = 0.0;     // over the clear air's
  double by_rays = 0.0;  // error
  double by_froxels = 0.0;
};

// In 40 pixels of a picture of 24 x 16 times `finer` pixels.
AirAmongBalls air_among_balls(Scene scene, int finer) {
  scene.clouds.front().contents = field_of_balls();
  const CloudGrid grid = cloud_grid(scene.clouds.front());
  const physics::vec3 to_sun(0.0, std::cos(radians(35.0)), std::sin(radians(35.0)));  // azimuth 0: north
  const physics::vec3 camera(0.0, 0.0, scene.camera.altitude);
  scene.image = {24 * finer, 16 * finer};
  scene.camera.azimuth = radians(110.0);
  scene.camera.vertical_fov = radians(50.0);
  physics::Physics p = geometry_of(scene);
  std::vector<Direction> directions;
  std::vector<std::size_t> pixels;
  std::vector<double> truth;
  double clear = 0.0;
  for (int i = 0; i < 40; ++i) {
    const int x = finer * (i * 7 % 24) + finer / 2;
    const int y = finer * (i * 5 % 16) + finer / 2;
    const physics::vec3 d = p.view_ray(p.scene.camera, 0, x + 0.5, y + 0.5).direction;
    const physics::vec3 way(d.x, -d.z, d.y);
    const double nu = dot(way, to_sun);
    const double end = d.y > 0.0 ? 2.0 / d.y : camera.z / -d.y;
    truth.push_back(scattered_by_air(scene, d.y, nu, [&](double t, double h) {
      const double above = std::max(2.0 - h, 0.0) / to_sun.z;
      const double before = water_depth_from(grid, camera, way, std::min(t, end));
      return std::exp(-before - water_depth_from(grid, way * t + camera, to_sun, above));
    }));
    clear += scattered_by_air(scene, d.y, nu, [](double, double) { return 1.0; });
    directions.push_back({std::asin(d.y), std::atan2(d.x, -d.z)});
    pixels.push_back(static_cast<std::size_t>(y * scene.image.width + x));
  }
  const double all = std::accumulate(truth.begin(), truth.end(), 0.0);
  const std::vector<ProbeResult> rays = probe_now(scene, directions);
  const Rendering picture = render_now(scene);
  AirAmongBalls found{.left = all / clear};
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const double unit = scene.sun.irradiance[1];
    found.by_rays += std::abs(rays[i].radiance[1] / unit - truth[i]) / all;
    found.by_froxels += std::abs(picture.radiance.rgba[4 * pixels[i] + 1] / unit - truth[i]) / all;
  }
  std::printf("air among clouds: %.2f of the clear air's, error by rays %.2f %%, by froxels %.2f %%\n", found.left,
              100.0 * found.by_rays, 100.0 * found.by_froxels);
  return found;
}

TEST(CloudPicture, ShadesTheAir) {
  Scene scene = among_black_clouds(35.0);
  scene.camera.pitch = radians(35.0);
  const AirAmongBalls found = air_among_balls(scene, 1);
  EXPECT_LT(found.left, 0.8);
  EXPECT_LT(found.by_rays, 0.03);
  EXPECT_LT(found.by_froxels, 0.025);
}

// From above, a ray through gaps ends on the ground, far below where the shade begins.
TEST(CloudPicture, ShadesTheAirSeenFromAbove) {
  Scene scene = among_black_clouds(35.0);
  scene.camera.altitude = 6.0;
  scene.camera.pitch = radians(-40.0);
  const AirAmongBalls found = air_among_balls(scene, 4);
  EXPECT_LT(found.left, 0.8);
  EXPECT_LT(found.by_rays, 0.03);
  EXPECT_LT(found.by_froxels, 0.03);
}

// Worst relative difference between a picture's froxels and listed rays, in the pixels that `takes(x, y, direction)`.
template <class Takes>
double froxels_off_rays(const Scene& scene, Takes takes) {
  physics::Physics p = geometry_of(scene);
  std::vector<Direction> directions;
  std::vector<std::size_t> pixels;
  for (int y = 0; y < scene.image.height; ++y) {
    for (int x = 0; x < scene.image.width; ++x) {
      const physics::vec3 d = p.view_ray(p.scene.camera, 0, x + 0.5, y + 0.5).direction;
      if (takes(x, y, d)) {
        directions.push_back({std::asin(d.y), std::atan2(d.x, -d.z)});
        pixels.push_back(static_cast<std::size_t>(y * scene.image.width + x));
      }
    }
  }
  EXPECT_GT(pixels.size(), 100U);
  const std::vector<ProbeResult> rays = probe_now(scene, directions);
  const Rendering picture = render_now(scene);
  double worst = 0.0;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const double shown = static_cast<double>(picture.radiance.rgba[4 * pixels[i] + 1]);
    worst = std::max(worst, std::abs(shown / rays[i].radiance[1] - 1.0));
  }
  std::printf("air: froxels and rays differ by %.2f %% at most in %zu pixels\n", 100.0 * worst, pixels.size());
  return worst;
}

// Rays that pass the planet's edge have froxels of other distances than those that end on the ground. A black ball
// stands before both; the cloud that shades the air grows thinner toward it.
TEST(CloudPicture, ShadesTheAirAlikeOnBothSidesOfTheHorizon) {
  constexpr int kWidth = 48;
  Scene scene = among_black_clouds(35.0);
  scene.planet.ground_radius = 6371.0;
  auto thinning = std::make_shared<CloudFile>(*scene.clouds.front().contents);
  thinning->nx = thinning->ny = 8;
  thinning->nz = 10;
  thinning->dx = thinning->dy = 4.0;
  thinning->dz = 0.1;
  thinning->extinction.clear();
  for (int at = 0; at < 8 * 8 * 10; ++at) {
    thinning->extinction.push_back(0.4F * static_cast<float>(std::abs(at % 8 - 4)));
  }
  thinning->identity = "thinning";
  scene.clouds.front().contents = thinning;
  scene.image = {kWidth, 32};
  scene.camera.altitude = 0.5;
  scene.camera.azimuth = radians(90.0);
  scene.camera.vertical_fov = radians(12.0);
  Sphere ball;
  ball.azimuth = scene.camera.azimuth;
  ball.elevation = radians(-0.7);
  ball.distance = 10.0;
  ball.radius = 0.9;
  ball.albedo = {0.0, 0.0, 0.0};
  scene.spheres = {ball};
  const double worst = froxels_off_rays(
      scene, [](int x, int y, const physics::vec3&) { return y >= 13 && y < 22 && x >= 16 && x < 32; });
  EXPECT_LT(worst, 0.02);
}

// Seen from above, a ray that touches the top of a black cloud is next to one that misses it, below or above it in the
// picture.
TEST(CloudPicture, ShadesTheAirAlikeOnBothSidesOfTheCloudsHorizon) {
  for (const double roll : {0.0, std::numbers::pi}) {
    Scene scene = among_black_clouds(35.0);
    scene.planet.ground_radius = 6371.0;
    scene.image = {192, 108};
    scene.camera.altitude = 3.2;
    scene.camera.azimuth = radians(90.0);
    scene.camera.pitch = radians(-22.0);
    scene.camera.roll = roll;
    scene.camera.vertical_fov = radians(50.0);
    const double worst = froxels_off_rays(scene, [](int, int, const physics::vec3& d) {
      return d.y > -0.026 && d.y < -0.004;  // the planet's edge is at -0.032
    });
    EXPECT_LT(worst, 0.07) << roll;
  }
}

// A bright sheet of cloud lights the air above it: rays that touch its top and rays that miss it find as much of it.
TEST(CloudPicture, LightsTheAirAlikeOnBothSidesOfTheCloudsHorizon) {
  Scene scene = resolve(load_preset(AIRLIGHT_SOURCE_DIR "/presets/above-the-clouds.json"), method_infos());
  scene.image = {96, 54};
  scene.camera.pitch = radians(-1.4);
  scene.camera.vertical_fov = radians(10.0);
  scene.render.parameters.insert_or_assign("cloud_resolution", "full");
  const double worst = froxels_off_rays(scene, [](int, int, const physics::vec3& d) {
    return d.y > -0.029 && d.y < -0.015;  // the planet's edge is at -0.032
  });
  EXPECT_LT(worst, 0.014);  // rays that stay above with slices from the camera on: 0.020
}

// The sun's rays fall through a thin veil and rise through it once more: its shade is the way through the shell times
// the extinction.
TEST(CloudPicture, ShadesTheAirOfALowSun) {
  constexpr double kDepth = 0.02;  // of a veil of 1 km
  for (const double elevation : {-1.5, -0.5, 0.5, 3.0}) {
    Scene scene = among_black_clouds(elevation);
    scene.planet.ground_radius = 6371.0;
    scene.media.front().density = exponential(4.0);
    auto contents = std::make_shared<CloudFile>(*scene.clouds.front().contents);
    contents->extinction.assign(contents->extinction.size(), static_cast<float>(kDepth));
    contents->identity = "veil";
    scene.clouds.front().contents = contents;
    const double radius = scene.planet.ground_radius;
    for (const double up : {90.0, 30.0}) {
      const double azimuth = 70.0;
      const double mu = std::sin(radians(up));
      const double nu = mu * std::sin(scene.sun.elevation) +
                        std::cos(radians(up)) * std::cos(scene.sun.elevation) * std::cos(radians(azimuth));
      const double expected = scattered_by_air(scene, mu, nu, [&](double t, double h) {
        const double r = radius + h;
        const double mu_sun = ((radius + scene.camera.altitude) * std::sin(scene.sun.elevation) + t * nu) / r;
        double inside = 0.0;
        constexpr double kStep = 0.1;
        for (double s = 0.5 * kStep; s < 700.0; s += kStep) {
          const double altitude = std::sqrt(r * r + s * (2.0 * r * mu_sun + s)) - radius;
          if (altitude < 0.0) {
            return 0.0;
          }
          inside += altitude > 1.0 && altitude < 2.0 ? kStep : 0.0;
        }
        const double before = std::clamp((h - 1.0) / mu, 0.0, 1.0 / mu);
        return std::exp(-kDepth * (before + inside));
      });
      const double found =
          probe_now(scene, {{radians(up), radians(azimuth)}}).front().radiance[1] / scene.sun.irradiance[1];
      std::printf("sun %4.1f, view %2.0f: %.3e for %.3e\n", elevation, up, found, expected);
      // At -1.5 degrees few slices of the ray cross the veil's shade.
      EXPECT_NEAR(found, expected, (elevation < -1.0 ? 0.15 : 0.03) * expected) << elevation << " " << up;
    }
  }
}

// A cloud without water is no cloud; one that is thick hides the sun's disc.
TEST(CloudPicture, HidesWhatStandsBehind) {
  Scene scene = under_level_cloud(30.0, 0.7);
  scene.sun.disc.visible = true;
  scene.image = {24, 24};
  scene.camera.azimuth = 0.0;
  scene.camera.pitch = scene.sun.elevation;
  scene.camera.vertical_fov = 4.0 * scene.sun.disc.angular_radius;
  const double behind = greatest(render_now(scene).radiance);
  auto empty = std::make_shared<CloudFile>(*scene.clouds.front().contents);
  empty->extinction.assign(empty->extinction.size(), 0.0F);
  empty->identity = "empty";
  scene.clouds.front().contents = empty;
  const double seen = greatest(render_now(scene).radiance);
  EXPECT_LT(behind, 1e-3 * seen);
  Scene clear = scene;
  clear.clouds.clear();
  EXPECT_NEAR(seen / greatest(render_now(clear).radiance), 1.0, 1e-5);
}

// A field may be thinner than its cells are wide, and of one cell.
TEST(CloudPicture, TakesTheThinnestField) {
  Scene scene = under_level_cloud(1.0, 0.7);
  Cloud cloud;
  cloud.kind = CloudKind::stratocumulus;
  cloud.cover = 1.0;
  cloud.base = 1.0;
  cloud.top = 1.1;
  cloud.cell = 0.5;
  cloud.period = 1.0;
  cloud.detail = 1.0;
  cloud.water = 0.3;
  cloud.effective_radius = 8.0;
  cloud.phase = CloudPhase::henyey_greenstein;
  cloud.phase_g = kAsymmetryOfDrops;
  scene.clouds = {cloud};
  scene.image = {4, 4};
  scene.camera.pitch = 1.0;
  scene.camera.vertical_fov = 1.0;
  EXPECT_GT(greatest(render_now(scene).radiance), 0.0);
}

// Light in a cloud is kept for the next picture, of the same drops alone: the same matter under another name.
TEST(CloudPicture, OfOtherDropsIsAnother) {
  const auto light = [](double g, const std::string& name) {
    Scene scene = under_level_cloud(4.0, 0.7);
    auto contents = std::make_shared<CloudFile>(*scene.clouds.front().contents);
    contents->identity = name;
    scene.clouds.front().contents = contents;
    scene.clouds.front().phase_g = g;
    return probe_now(scene, {{1.2, 0.5}}).front().radiance[1];
  };
  const double first = light(0.85, "kept");
  const double other = light(0.4, "kept");
  EXPECT_NEAR(other, light(0.4, "anew"), 1e-6 * other);
  EXPECT_GT(std::abs(other / first - 1.0), 0.05);
  EXPECT_EQ(light(0.85, "kept"), first);
}

// So narrow a picture holds no star.
TEST(CloudPicture, StandsBeforeANightWithoutALightInView) {
  Scene scene = under_level_cloud(1.0, 0.7);
  scene.stars = Stars{6.5};
  scene.camera.julian_date = 2451545.0;
  scene.image = {4, 4};
  scene.camera.pitch = 1.0;
  scene.camera.vertical_fov = 1e-6;
  EXPECT_GT(greatest(render_now(scene).radiance), 0.0);
}

TEST(CloudPicture, RefusesWhatItDoesNotKnow) {
  Scene scene = under_level_cloud(1.0, 0.7);
  scene.image = {4, 4};
  Scene ball = scene;
  ball.spheres.push_back({.distance = 1.0, .radius = 0.1, .material = SphereMaterial::mirror});
  expect_cloud_refused(ball, "clouds in mirrors within 2 km");
  Scene low = scene;
  low.sun.elevation = radians(5.0);
  auto large = std::make_shared<CloudFile>(*scene.clouds.front().contents);
  large->nx = large->ny = 400;
  large->nz = 64;
  large->dx = large->dy = large->dz = 0.01;
  large->extinction.assign(400 * 400 * 64, 1.0F);
  large->identity = "large";
  low.clouds.front().contents = large;
  low.clouds.front().repeats = false;
  low.clouds.front().top = low.clouds.front().base + 0.64;
  expect_cloud_refused(low, "/clouds/0/file: with room for its shadow");
}

// Vulkan promises this much and no more.
TEST(CloudPicture, OfThickFieldsHasTablesThatFitEveryDevice) {
  constexpr std::size_t kMostBytes = std::size_t{1} << 27U;
  Scene scene = among_cumulus(8.0, 0.3);
  scene.clouds.front().top = 10.0;
  const Plan plan = plan_for(ready(scene), {});
  for (const BufferDesc& buffer : plan.buffers()) {
    EXPECT_LE(buffer.bytes, kMostBytes) << buffer.name;
  }
}

}  // namespace
}  // namespace airlight::test
