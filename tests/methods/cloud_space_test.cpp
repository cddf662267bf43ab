// Clouds seen from above the air.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numbers>
#include <utility>
#include <vector>

#include "core/scene/cloud_pixels.h"
#include "tests/methods/bent_scene.h"
#include "tests/methods/cloud_scene.h"

namespace airlight::test {
namespace {

using physics::vec3;

// A place's altitude, and where the grid has it: on the plane under the camera (x east, y up, z south).
double extinction_at(const CloudGrid& grid, double radius, const vec3& from_centre) {
  const double onto = radius / from_centre.y;
  return grid.at(from_centre.x * onto, -from_centre.z * onto, length(from_centre) - radius);
}

double depth_along(const CloudGrid& grid, double radius, const vec3& from, const vec3& direction, double length) {
  constexpr double kStep = 0.01;
  double depth = 0.0;
  for (double t = 0.5 * kStep; t < length; t += kStep) {
    depth += kStep * extinction_at(grid, radius, from + direction * t);
  }
  return depth;
}

vec3 toward(const Direction& d) {
  return {std::cos(d.elevation) * std::sin(d.azimuth), std::sin(d.elevation),
          -std::cos(d.elevation) * std::cos(d.azimuth)};
}

// White ground under black balls: what it sends has passed them twice. Up to 12 degrees round the planet, where the
// plane of the grid and the ground below it are no longer alike.
TEST(CloudsFromSpace, HideAndShadeTheGroundWhereTheyStand) {
  constexpr double kRadius = 6371.0;
  for (const double pitch : {-90.0, -45.0}) {
    Scene scene = under_level_cloud(1.0, std::sin(radians(50.0)));
    scene.planet.ground_radius = kRadius;
    scene.planet.ground_albedo = {1.0, 1.0, 1.0};
    scene.sun.azimuth = radians(70.0);
    Cloud& cloud = scene.clouds.front();
    cloud.contents = field_of_balls();
    cloud.phase_g = 0.0;
    cloud.single_scattering_albedo = 1e-3;
    scene.camera.altitude = 400.0;
    scene.camera.pitch = radians(pitch);
    scene.camera.azimuth = radians(20.0);
    const CloudGrid grid = cloud_grid(cloud);
    const vec3 camera(0.0, kRadius + scene.camera.altitude, 0.0);
    const vec3 sun = toward({scene.sun.elevation, scene.sun.azimuth});
    std::vector<Direction> directions;
    std::vector<double> truth;
    for (int k = 0; k < 60; ++k) {
      const Direction d{radians(std::max(pitch - 1.0, -88.0) + 0.031 * k), radians(20.0 + 0.13 * k)};
      const vec3 view = toward(d);
      const double b = dot(camera, view);
      const double t = -b - std::sqrt(b * b - (length(camera) - kRadius) * (length(camera) + kRadius));
      const vec3 ground = camera + view * t;
      const double facing = dot(sun, ground) / length(ground);
      const double depth =
          depth_along(grid, kRadius, ground, -view, 8.0) + depth_along(grid, kRadius, ground, sun, 8.0);
      directions.push_back(d);
      truth.push_back(facing / std::numbers::pi * std::exp(-depth));
    }
    const std::vector<ProbeResult> found = probe_now(scene, directions);
    double error = 0.0;
    double all = 0.0;
    for (std::size_t i = 0; i < truth.size(); ++i) {
      error += std::abs(found[i].radiance[1] / scene.sun.irradiance[1] - truth[i]);
      all += truth[i];
    }
    std::printf("pitch %g: %.2f %% off, %.3f of the light\n", pitch, 100.0 * error / all,
                all / static_cast<double>(truth.size()) * std::numbers::pi / std::sin(scene.sun.elevation));
    EXPECT_LT(error / all, 0.03) << pitch;
  }
}

// An opaque black cloud is ground of its top's height: the air before it is that over a planet as much larger, and as
// much thinner at the ground. The air bends light.
TEST(CloudsFromSpace, HaveTheAirBeforeThemThatIsThere) {
  constexpr double kTop = 2.0;
  constexpr double kScaleHeight = 8.0;
  for (const double camera : {60.0, 101.0, 400.0, 2000.0}) {
    Scene scene = clear_and_bent("orders", camera);
    scene.planet.ground_albedo = {0.0, 0.0, 0.0};
    scene.planet.refraction->density.scale_height = kScaleHeight;
    scene.media.front().density = exponential(kScaleHeight);
    scene.sun.elevation = radians(40.0);
    scene.sun.azimuth = radians(100.0);
    scene.sun.disc.visible = false;
    scene.clouds = under_level_cloud(1000.0, 0.5).clouds;
    scene.clouds.front().single_scattering_albedo = 0.0;
    Scene ground = scene;
    const double thinner = std::exp(-kTop / kScaleHeight);
    ground.clouds.clear();
    ground.planet.ground_radius += kTop;
    ground.planet.atmosphere_height -= kTop;
    ground.camera.altitude -= kTop;
    ground.planet.refraction->n_minus_1 *= thinner;
    for (double& coefficient : ground.media.front().scattering) {
      coefficient *= thinner;
    }
    const double edge = std::acos(scene.planet.ground_radius / (scene.planet.ground_radius + camera));
    std::vector<Direction> directions;
    for (const double share : {1.0, 0.7, 0.4, 0.2, 0.08}) {
      directions.push_back({-edge - share * (0.5 * std::numbers::pi - edge), radians(37.0)});
    }
    const std::vector<ProbeResult> found = probe_now(scene, directions);
    const std::vector<ProbeResult> want = probe_now(ground, directions);
    for (std::size_t i = 0; i < directions.size(); ++i) {
      std::printf("%g km: %+.2f %%\n", camera, 100.0 * (found[i].radiance[1] / want[i].radiance[1] - 1.0));
      EXPECT_NEAR(found[i].radiance[1], want[i].radiance[1], 0.03 * want[i].radiance[1]) << camera << ", " << i;
    }
  }
}

// A level cloud far from the point under the camera sends what it would send to a camera above it, under the sun that
// it has there.
TEST(CloudsFromSpace, AreLitByTheSunThatTheyHave) {
  constexpr double kRadius = 6371.0;
  constexpr double kRound = 12.0;  // degrees from the point under the camera
  for (const auto& [sun_deg, azimuth] : {std::pair(8.0, 0.0), std::pair(40.0, 0.0), std::pair(40.0, 180.0)}) {
    const double sunward = azimuth == 0.0 ? 1.0 : -1.0;
    Scene far = under_level_cloud(8.0, std::sin(radians(sun_deg)));
    far.planet.ground_radius = kRadius;
    far.camera.altitude = 600.0;
    far.camera.azimuth = radians(azimuth);
    const double down = kRadius + far.camera.altitude - kRadius * std::cos(radians(kRound));
    const double pitch = -std::atan2(down, kRadius * std::sin(radians(kRound)));
    far.camera.pitch = pitch;
    Scene near = far;
    near.camera.altitude = 10.0;
    const double on_cloud = pitch + radians(kRound);
    const double steep = -std::acos(std::cos(on_cloud) * kRadius / (kRadius + near.camera.altitude));
    near.sun.elevation = radians(sun_deg) + sunward * (radians(kRound) - (on_cloud - steep));
    const double want = probe_now(near, {{steep, radians(azimuth)}}).front().radiance[1];
    const double middle = probe_now(far, {{pitch, radians(azimuth)}}).front().radiance[1];
    // Elsewhere in the picture light scattered more than once goes by the share that the field takes of the sun.
    far.camera.pitch = radians(-90.0);
    const double beside = probe_now(far, {{pitch, radians(azimuth)}}).front().radiance[1];
    std::printf("sun %g, %g: %+.2f %%, beside the middle %+.2f %%\n", sun_deg, azimuth, 100.0 * (middle / want - 1.0),
                100.0 * (beside / want - 1.0));
    EXPECT_NEAR(middle, want, 0.02 * want) << sun_deg << ", " << azimuth;
    EXPECT_NEAR(beside, want, 0.25 * want) << sun_deg << ", " << azimuth;
  }
}

TEST(CloudsFromSpace, TooFineForThePixelsAreTold) {
  Scene scene = under_level_cloud(1.0, 0.7);
  scene.image = {640, 360};
  scene.camera.vertical_fov = radians(40.0);
  scene.camera.altitude = 400.0;
  EXPECT_TRUE(cloud_warnings(scene).empty());  // an even cloud has no cells
  scene.clouds = {carved_cloud(CloudKind::cumulus, 0.4)};
  scene.clouds.front().cell = 2.0;
  EXPECT_TRUE(cloud_warnings(scene).empty());
  scene.clouds.front().cell = 1.5;  // a pixel is 0.805 km wide
  ASSERT_EQ(cloud_warnings(scene).size(), 1U);
  EXPECT_EQ(cloud_warnings(scene).front().find("/clouds/0/cell_km: a pixel sees 0.8 km of clouds that stand 1.5 km"),
            0U)
      << cloud_warnings(scene).front();
  scene.camera.altitude = 0.1;
  EXPECT_TRUE(cloud_warnings(scene).empty());
  EXPECT_NEAR(pixel_width({.projection = Projection::equirectangular}, {360, 180}, 180.0), std::numbers::pi, 1e-9);
  EXPECT_NEAR(pixel_width({.projection = Projection::cube}, {100, 600}, 50.0), 1.0, 1e-9);
}

}  // namespace
}  // namespace airlight::test
