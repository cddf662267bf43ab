// The planet's edge in pictures: each pixel on it is the mean over its area.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/methods/render_fixture.h"
#include "tests/of_scene.h"

namespace airlight::test {
namespace {

// A bright ground under a clear sky, with a slanting horizon.
Scene aslant(const SkyMethod& method, double altitude) {
  Scene scene = with_method(earth(), method, true);
  scene.planet.ground_albedo = {0.7, 0.5, 0.3};
  scene.sun.elevation = 40.0 * kDegree;
  scene.sun.azimuth = 150.0 * kDegree;
  scene.sun.disc.visible = false;
  scene.bloom.enabled = false;
  scene.camera.altitude = altitude;
  scene.camera.azimuth = 0.0;
  scene.camera.pitch = 0.0;
  scene.camera.roll = 17.0 * kDegree;
  scene.camera.vertical_fov = 30.0 * kDegree;
  scene.image = {16, 12};
  return scene;
}

Scene times(Scene scene, int side) {
  scene.image = {scene.image.width * side, scene.image.height * side};
  return scene;
}

double mean_of_block(const RadianceImage& fine, int x, int y, int side, std::size_t c) {
  double sum = 0.0;
  for (int k = 0; k < side * side; ++k) {
    sum += channel_of(fine, x * side + k % side, y * side + k / side, c);
  }
  return sum / (side * side);
}

TEST(HorizonPixels, AreMeansOverTheirAreaByEveryMethod) {
  constexpr int kSide = 8;
  for (const SkyMethod& method : methods()) {
    if (!on_device(method)) {
      continue;
    }
    const Scene scene = aslant(method, 0.05);
    const RadianceImage coarse = render_now(scene).radiance;
    const RadianceImage fine = render_now(times(scene, kSide)).radiance;
    physics::Physics p = make_physics(scene);
    int crossed = 0;
    for (int y = 0; y < 12; ++y) {
      for (int x = 0; x < 16; ++x) {
        const auto above = [&](double u, double v) {
          return p.above_horizon(p.scene.planet, scene.camera.altitude,
                                 p.view_ray(p.scene.camera, 0, x + u, y + v).direction) > 0.0;
        };
        if (above(0.0, 0.0) == above(1.0, 1.0) && above(0.0, 1.0) == above(1.0, 0.0)) {
          continue;
        }
        ++crossed;
        for (std::size_t c = 0; c < 3; ++c) {
          const double truth = mean_of_block(fine, x, y, kSide, c);
          // A pixel is 2.5 degrees high, over which the sky above the horizon is curved: `analytic` is the worst with
          // 3.4 %.
          EXPECT_NEAR(channel_of(coarse, x, y, c), truth, 0.045 * truth) << method.info.name << " " << x << ", " << y;
        }
      }
    }
    EXPECT_GE(crossed, 15);
  }
}

// The halo of a planet seen from three radii, thinner than a few pixels, keeps its light whatever the picture's size.
TEST(HorizonPixels, AThinHaloKeepsItsLight) {
  Scene scene = with_method(earth(), *find_method("orders"));
  scene.planet.ground_albedo = {0.0, 0.0, 0.0};
  scene.sun.disc.visible = false;
  scene.sun.elevation = 30.0 * kDegree;
  scene.camera.altitude = 2.0 * scene.planet.ground_radius;
  scene.camera.pitch = -70.5 * kDegree;
  scene.camera.vertical_fov = 10.0 * kDegree;
  scene.image = {4, 36};  // 93 km a pixel: all of the halo in one
  constexpr int kSide = 12;
  const RadianceImage coarse = render_now(scene).radiance;
  const RadianceImage fine = render_now(times(scene, kSide)).radiance;
  for (int x = 0; x < 4; ++x) {
    double sum = 0.0;
    double truth = 0.0;
    for (int y = 0; y < 36; ++y) {
      sum += channel_of(coarse, x, y, 2);
      truth += mean_of_block(fine, x, y, kSide, 2);
    }
    EXPECT_NEAR(sum, truth, 0.01 * truth) << x;
  }
}

}  // namespace
}  // namespace airlight::test
