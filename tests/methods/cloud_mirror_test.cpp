// Clouds in mirrors by `orders`: what a mirror near the camera shows is what the camera sees in that direction.

#include <cmath>
#include <cstdio>
#include <utility>
#include <vector>

#include "tests/methods/cloud_scene.h"

namespace airlight::test {
namespace {

using physics::vec3;

constexpr double kMirrorAlbedo = 0.6;

// A ball of 16 cm, 80 cm to the west: clouds stand where they do for the camera.
Sphere chrome() {
  Sphere sphere;
  sphere.azimuth = radians(270.0);
  sphere.elevation = radians(-5.0);
  sphere.distance = 0.0008;
  sphere.radius = 0.00008;
  sphere.material = SphereMaterial::mirror;
  sphere.albedo = {kMirrorAlbedo, kMirrorAlbedo, kMirrorAlbedo};
  return sphere;
}

// Balls of cloud in a haze over grey ground.
Scene under_balls() {
  Scene scene = under_level_cloud(1.0, std::sin(radians(40.0)));
  scene.clouds.front().contents = field_of_balls();
  scene.media.front().scattering = {0.01, 0.02, 0.04};
  scene.media.front().density = exponential(6.0);  // much of the light is that of air above all clouds
  scene.planet.ground_albedo = {0.3, 0.3, 0.3};
  scene.camera.altitude = 0.05;
  return scene;
}

// A level veil from 3 to 3.5 km.
constexpr double kVeilDepth = 0.4;
Cloud veil(Cloud cloud) {
  auto contents = std::make_shared<CloudFile>(*under_level_cloud(2.0 * kVeilDepth, 0.5).clouds.front().contents);
  contents->lowest = 3.0125;
  contents->dz = 0.025;
  contents->identity = "veil";
  cloud.contents = contents;
  cloud.base = 3.0;
  cloud.top = 3.5;
  cloud.index = 1;
  return cloud;
}

// Directions of pixels that the mirror fills, and those in which it sends their rays.
std::pair<std::vector<Direction>, std::vector<Direction>> mirrored_directions(const Scene& scene) {
  physics::Physics p = formulas_of(part_of(scene).air, scene);
  const Sphere& ball = scene.spheres.front();
  const vec3 centre = p.direction_from_angles(ball.elevation, ball.azimuth) * ball.distance;
  std::pair<std::vector<Direction>, std::vector<Direction>> both;
  for (double x = -0.9; x < 0.95; x += 0.1) {
    for (double y = -0.9; y < 0.95; y += 0.1) {
      const double scale = ball.radius / ball.distance;
      const Direction seen{ball.elevation + scale * y, ball.azimuth + scale * x};
      const vec3 view = p.direction_from_angles(seen.elevation, seen.azimuth);
      const double along = physics::dot(view, centre);
      const double inside = ball.radius * ball.radius - physics::dot(centre, centre) + along * along;
      if (inside < 0.1 * ball.radius * ball.radius) {
        continue;
      }
      const vec3 normal = (view * (along - std::sqrt(inside)) - centre) * (1.0 / ball.radius);
      const vec3 away = view - normal * (2.0 * physics::dot(view, normal));
      // Near the horizon a metre of height decides on what is seen.
      if (std::abs(away.y) > 0.05) {
        both.first.push_back(seen);
        both.second.push_back({std::asin(away.y), std::atan2(away.x, -away.z)});
      }
    }
  }
  return both;
}

TEST(CloudMirrors, ShowWhatTheCameraSees) {
  Scene stack = under_balls();
  stack.clouds.push_back(veil(stack.clouds.front()));
  Scene between = stack;
  between.camera.altitude = 2.5;
  for (const auto& [name, clouds] :
       {std::pair{"one field", under_balls()}, {"below two", stack}, {"between two", between}}) {
    Scene scene = clouds;
    scene.spheres = {chrome()};
    const auto [seen, mirrored] = mirrored_directions(scene);
    const std::vector<ProbeResult> found = probe_now(scene, seen);
    scene.spheres.clear();
    const std::vector<ProbeResult> truth = probe_now(scene, mirrored);
    double error = 0.0;
    double sum = 0.0;
    double all = 0.0;
    for (std::size_t i = 0; i < seen.size(); ++i) {
      const double light = kMirrorAlbedo * truth[i].radiance[1];
      error += std::abs(found[i].radiance[1] - light);
      sum += found[i].radiance[1];
      all += light;
    }
    std::printf("%s: %zu rays, %.2f %% off, %+.2f in all\n", name, seen.size(), 100.0 * error / all,
                100.0 * (sum / all - 1.0));
    EXPECT_GT(seen.size(), 100u);
    EXPECT_LT(error / all, 0.03) << name;
    EXPECT_NEAR(sum / all, 1.0, 0.01) << name;
  }
}

// Of the sun's disc a mirror shows what two level clouds leave of a beam.
TEST(CloudMirrors, ShowTheSunAsBrightAsItsBeam) {
  Scene scene = under_level_cloud(0.3, std::sin(radians(40.0)));
  scene.clouds.push_back(veil(scene.clouds.front()));
  scene.spheres = {chrome()};
  scene.camera.altitude = 0.05;
  physics::Physics p = formulas_of(part_of(scene).air, scene);
  // The normal halves the angle between the ways to the sun and back to the camera.
  const Sphere& ball = scene.spheres.front();
  const vec3 centre = p.direction_from_angles(ball.elevation, ball.azimuth) * ball.distance;
  vec3 point = centre;
  for (int i = 0; i < 20; ++i) {
    const vec3 half = p.scene.sun.direction - physics::normalize(point);
    point = centre + physics::normalize(half) * ball.radius;
  }
  const vec3 view = physics::normalize(point);
  const std::vector<Direction> at{{std::asin(view.y), std::atan2(view.x, -view.z)}};
  const auto disc_of = [&](Scene of) {
    const double without = probe_now(of, at)[0].radiance[1];
    of.sun.disc.visible = true;
    return probe_now(of, at)[0].radiance[1] - without;
  };
  Scene clear = scene;
  clear.clouds.clear();
  const double share = disc_of(scene) / disc_of(clear);
  EXPECT_NEAR(share, std::exp(-(0.3 + kVeilDepth) / std::sin(radians(40.0))), 0.01);
}

}  // namespace
}  // namespace airlight::test
