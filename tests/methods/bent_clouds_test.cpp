// Clouds in air that bends light: pictures by `orders` against path-trace, whose rays are traced in pieces.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <memory>
#include <numbers>
#include <vector>

#include "tests/methods/bent_scene.h"

namespace airlight::test {
namespace {

// Bands of thin cloud from north to south, 32 km from one to the next, seen toward the east.
Scene under_bands(double sun_deg) {
  Scene scene = clear_and_bent("orders", 0.05);
  scene.planet.ground_albedo = {0.2, 0.2, 0.2};
  scene.sun.elevation = sun_deg * kDegree;
  scene.sun.azimuth = 130.0 * kDegree;
  scene.sun.disc.visible = false;
  Cloud cloud;
  cloud.kind = CloudKind::volume;
  cloud.base = 3.0;
  cloud.top = 3.3;
  cloud.repeats = true;
  cloud.phase = CloudPhase::henyey_greenstein;
  cloud.phase_g = 0.0;
  cloud.single_scattering_albedo = 0.9;
  auto contents = std::make_shared<CloudFile>();
  contents->nx = 16;
  contents->ny = 2;
  contents->nz = 6;
  contents->dx = 2.0;
  contents->dy = 2.0;
  contents->dz = 0.05;
  contents->lowest = cloud.base;
  for (int i = 0; i < contents->nx * contents->ny * contents->nz; ++i) {
    const double wave = std::sin(i * 2.0 * std::numbers::pi / contents->nx);
    contents->extinction.push_back(static_cast<float>(0.1 * (1.0 + wave)));
  }
  contents->identity = "bands";
  cloud.contents = contents;
  scene.clouds = {cloud};
  return scene;
}

// From 1 degree up, where the bands are 130 km away and lie 290 m lower over the horizon than by straight rays.
TEST(BentClouds, AreSeenAsByPathTrace) {
  constexpr int kSamples = 256;
  for (const double sun : {20.0, 4.0}) {
    const Scene scene = under_bands(sun);
    std::vector<Direction> directions;
    for (int k = 0; k < 24; ++k) {
      directions.push_back({(1.0 + 0.09 * k) * kDegree, (80.0 + 10.0 * (k % 3)) * kDegree});
    }
    Scene straight = scene;
    straight.planet.refraction.reset();
    const HostPicture truth = truth_of(scene, directions, kSamples);
    const HostPicture straight_truth = truth_of(straight, directions, kSamples);
    const double in_bent = mean_error(scene, truth, directions);
    const double in_straight = mean_error(straight, straight_truth, directions);
    const double by_straight = mean_error(straight, truth, directions);
    std::printf("sun %g: %.4f, in straight air %.4f, by straight rays %.4f, noise %.4f\n", sun, in_bent, in_straight,
                by_straight, noise_of(truth));
    EXPECT_LT(in_bent, in_straight + 0.01) << sun;
    EXPECT_LT(in_bent, 0.06) << sun;
    EXPECT_GT(by_straight, 2.0 * in_bent) << sun;
  }
}

// The sun's light scattered once by a thick cloud falls off from its top down, so that a few metres count where its
// drops are met. Air bends steep rays by little.
TEST(BentClouds, AreLitWhereTheirDropsAreMet) {
  constexpr int kSamples = 32768;
  Scene scene = under_bands(50.0);
  scene.media[0].scattering = {1e-9, 1e-9, 1e-9};
  scene.planet.ground_albedo = {};
  Cloud& cloud = scene.clouds.front();
  cloud.base = 1.0;
  cloud.top = 2.0;
  cloud.single_scattering_albedo = 1e-3;
  auto even = std::make_shared<CloudFile>(*cloud.contents);
  even->dz = 0.2;
  even->lowest = 1.0;
  even->extinction.assign(even->extinction.size(), 2.0F);
  even->identity = "even";
  cloud.contents = even;
  std::vector<Direction> directions;
  for (const double elevation : {15.0, 25.0, 45.0}) {
    directions.push_back({elevation * kDegree, 20.0 * kDegree});
  }
  const HostPicture bent = truth_of(scene, directions, kSamples);
  scene.planet.refraction.reset();
  const HostPicture straight = truth_of(scene, directions, kSamples);
  for (int i = 0; i < bent.radiance.width; ++i) {
    const double ratio = static_cast<double>(bent.radiance.at(i, 0)[1] / straight.radiance.at(i, 0)[1]);
    const double noise = static_cast<double>(bent.standard_error.at(i, 0)[1] / bent.radiance.at(i, 0)[1]);
    std::printf("direction %d: %.3f of straight air's, noise %.3f\n", i, ratio, noise);
    EXPECT_NEAR(ratio, 1.0, 0.01 + 4.0 * noise) << i;
  }
}

}  // namespace
}  // namespace airlight::test
