// Spheres in the picture of `orders`: their light against the light of the sky without them, their shadows against the
// hidden sunlight, their edges against finer pictures.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/methods/path_trace/optical_depth.h"
#include "core/post/post.h"
#include "core/things/bodies.h"
#include "tests/methods/render_fixture.h"
#include "tests/of_scene.h"

namespace airlight::test {
namespace {

using physics::dot;
using physics::Physics;
using physics::vec3;

constexpr double kMetre = 1e-3;

Sphere sphere_of(SphereMaterial material, double azimuth, double elevation, double distance, double radius) {
  Sphere sphere;
  sphere.azimuth = azimuth * kDegree;
  sphere.elevation = elevation * kDegree;
  sphere.distance = distance;
  sphere.radius = radius;
  sphere.material = material;
  sphere.albedo = {0.6, 0.5, 0.4};
  return sphere;
}

// A ball of a metre's radius 8 m ahead, the sun behind the camera on the left.
Scene ball_scene(SphereMaterial material, const char* shells = "never") {
  Scene scene = with_method(earth(), *find_method("orders"));
  scene.render.parameters.find("shells")->second = std::string(shells);
  scene.planet.ground_albedo = {0.3, 0.25, 0.2};
  scene.sun.elevation = 35.0 * kDegree;
  scene.sun.azimuth = 200.0 * kDegree;
  scene.sun.disc.visible = false;
  scene.bloom.enabled = false;
  scene.camera.altitude = 2.0 * kMetre;
  scene.camera.azimuth = 0.0;
  scene.camera.pitch = 0.0;
  scene.camera.vertical_fov = 24.0 * kDegree;
  scene.image = {12, 12};
  scene.spheres = {sphere_of(material, 0.0, 0.0, 8.0 * kMetre, 1.0 * kMetre)};
  return scene;
}

Scene without_spheres(Scene scene) {
  scene.spheres.clear();
  return scene;
}

struct Touch {
  Direction direction;
  vec3 view;
  vec3 normal;
  vec3 point;
};

Touch touch(const Scene& scene, double elevation, double azimuth) {
  Physics p = make_physics(scene);
  p.spheres = spheres_of(scene);
  Touch t{{elevation * kDegree, azimuth * kDegree}, {}, {}, {}};
  t.view = p.direction_from_angles(t.direction.elevation, t.direction.azimuth);
  const auto hit = p.nearest_body(vec3(0.0), t.view, physics::kNoBody);
  EXPECT_TRUE(hit.hit);
  t.point = t.view * hit.distance_;
  t.normal = (t.point - p.spheres[0].centre) / p.spheres[0].radius;
  return t;
}

Direction direction_of(const vec3& d) {
  return {std::asin(d.y), std::atan2(d.x, -d.z)};
}

// Irradiance of a surface by sun and sky without the ball: by a picture of all directions and the sun's transmittance.
vec3 irradiance_on(const Scene& scene, const vec3& normal) {
  const Scene bare = without_spheres(scene);
  const Scene round = all_round(bare, scene.camera.altitude, 96, 48);
  const RadianceImage sky = render_now(round).radiance;
  Physics p = make_physics(round);
  vec3 sum(0.0);
  for (int y = 0; y < 48; ++y) {
    for (int x = 0; x < 96; ++x) {
      const vec3 d = p.view_ray(p.scene.camera, physics::kProjectionEquirectangular, x + 0.5, y + 0.5).direction;
      const double weight = std::max(dot(d, normal), 0.0) * solid_angle(round, x, y);
      sum = sum + vec3(channel_of(sky, x, y, 0), channel_of(sky, x, y, 1), channel_of(sky, x, y, 2)) * weight;
    }
  }
  const ProbeResult sun = probe_now(bare, {{scene.sun.elevation, scene.sun.azimuth}}).front();
  const double facing = std::max(dot(p.scene.sun.direction, normal), 0.0);
  return sum + vec3(sun.transmittance[0], sun.transmittance[1], sun.transmittance[2]) * p.scene.sun.irradiance * facing;
}

double channel_at(const vec3& v, std::size_t c) {
  return c == 0 ? v.x : c == 1 ? v.y : v.z;
}

TEST(SphereSky, MatteOnesSendBackWhatReachesThem) {
  for (const char* shells : {"never", "always"}) {
    const Scene scene = ball_scene(SphereMaterial::matte, shells);
    for (const auto& [elevation, azimuth] : {std::pair(0.0, 0.0), {5.0, 1.0}, {-5.0, -3.0}, {1.0, 6.0}}) {
      const Touch t = touch(scene, elevation, azimuth);
      const ProbeResult seen = probe_now(scene, {t.direction}).front();
      const vec3 truth = irradiance_on(scene, t.normal) / std::numbers::pi;
      for (std::size_t c = 0; c < 3; ++c) {
        const double light = channel_at(truth, c) * scene.spheres[0].albedo[c];
        EXPECT_NEAR(seen.radiance[c], light, 0.03 * light) << shells << " " << elevation << " " << azimuth << " " << c;
      }
    }
  }
}

TEST(SphereSky, MirrorsShowSkyAndGround) {
  for (const char* shells : {"never", "always"}) {
    const Scene scene = ball_scene(SphereMaterial::mirror, shells);
    for (const auto& [elevation, azimuth] : {std::pair(5.5, 0.0), {3.0, 5.0}, {-4.0, 1.0}, {-1.0, -6.0}}) {
      const Touch t = touch(scene, elevation, azimuth);
      const vec3 mirrored = t.view - t.normal * (2.0 * dot(t.view, t.normal));
      Scene there = without_spheres(scene);
      there.camera.altitude += t.point.y;
      const ProbeResult seen = probe_now(scene, {t.direction}).front();
      const ProbeResult truth = probe_now(there, {direction_of(mirrored)}).front();
      for (std::size_t c = 0; c < 3; ++c) {
        const double light = truth.radiance[c] * scene.spheres[0].albedo[c];
        // The 8 m of air before the ball shine too. The ball hides sky from the ground next to it and shines on it.
        const double near = mirrored.y < 0.0 ? 0.06 : 0.004;
        EXPECT_NEAR(seen.radiance[c], light, near * light) << shells << " " << elevation << " " << azimuth << " " << c;
      }
    }
  }
}

// A ball far away sends as much of the sun to the camera as a mirrored sphere does: E r^2 / (4 d^2).
TEST(SphereSky, MirrorsShowTheDiscWithItsLight) {
  Scene scene = ball_scene(SphereMaterial::mirror);
  scene.camera.vertical_fov = 3.0 * kDegree;
  scene.spheres[0].distance = 100.0 * kMetre;
  scene.image = {32, 32};
  Scene shining = scene;
  shining.sun.disc.visible = true;
  const RadianceImage with = render_now(shining).radiance;
  const RadianceImage without = render_now(scene).radiance;
  const ProbeResult sun = probe_now(without_spheres(scene), {{scene.sun.elevation, scene.sun.azimuth}}).front();
  for (std::size_t c = 0; c < 3; ++c) {
    double light = 0.0;
    for (int k = 0; k < 32 * 32; ++k) {
      light += (channel_of(with, k % 32, k / 32, c) - channel_of(without, k % 32, k / 32, c)) *
               solid_angle(scene, k % 32, k / 32);
    }
    const double truth = scene.sun.irradiance[c] * sun.transmittance[c] * scene.spheres[0].albedo[c] / (4.0 * 1e4);
    EXPECT_NEAR(light, truth, 0.1 * truth) << c;
  }
}

TEST(SphereSky, TranslucentOnesAreLitFromBehind) {
  Scene scene = ball_scene(SphereMaterial::translucent);
  scene.sun.azimuth = 0.0;  // behind the ball
  Scene matte = scene;
  matte.spheres[0].material = SphereMaterial::matte;
  const Touch t = touch(scene, 0.0, 0.0);
  const ProbeResult seen = probe_now(scene, {t.direction}).front();
  const ProbeResult dull = probe_now(matte, {t.direction}).front();
  const vec3 poles[] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  vec3 sky(0.0);
  Scene dark = scene;
  dark.sun.irradiance = scene.sun.irradiance;
  for (const vec3& pole : poles) {
    sky = sky + irradiance_on(dark, pole) / 6.0;
  }
  // Six normals yield the sky's mean; the sun's mean is a quarter of the irradiance of a surface that faces it.
  Physics p = make_physics(scene);
  const ProbeResult sun = probe_now(without_spheres(scene), {{scene.sun.elevation, scene.sun.azimuth}}).front();
  double facing = 0.0;
  for (const vec3& pole : poles) {
    facing += std::max(dot(pole, p.scene.sun.direction), 0.0) / 6.0;
  }
  for (std::size_t c = 0; c < 3; ++c) {
    const double direct = scene.sun.irradiance[c] * sun.transmittance[c];
    const double mean = channel_at(sky, c) + direct * (0.25 - facing);
    const double truth = 0.3 * dull.radiance[c] + 0.7 * scene.spheres[0].albedo[c] * mean / std::numbers::pi;
    EXPECT_NEAR(seen.radiance[c], truth, 0.02 * truth) << c;
    EXPECT_GT(seen.radiance[c], 1.3 * dull.radiance[c]) << c;
  }
}

// Behind the ball, on the line from the sun through it, the sky alone lights the ground, of which the ball hides little
// and to which it adds little.
TEST(SphereSky, ThrowShadowsOnTheGround) {
  Scene scene = ball_scene(SphereMaterial::matte);
  scene.sun.azimuth = 90.0 * kDegree;  // the shadow falls to the left
  Physics p = make_physics(scene);
  const vec3 centre = spheres_of(scene)[0].centre;
  const vec3 sun = p.scene.sun.direction;
  const vec3 spot = centre - sun * ((centre.y + scene.camera.altitude) / sun.y);
  const Direction there = direction_of(physics::normalize(spot));
  const Direction beside{there.elevation, there.azimuth - 30.0 * kDegree};
  const std::vector<ProbeResult> with = probe_now(scene, {there, beside});
  const std::vector<ProbeResult> without = probe_now(without_spheres(scene), {there, beside});
  const ProbeResult through = probe_now(without_spheres(scene), {{scene.sun.elevation, scene.sun.azimuth}}).front();
  for (std::size_t c = 0; c < 3; ++c) {
    const double direct =
        scene.sun.irradiance[c] * through.transmittance[c] * sun.y * scene.planet.ground_albedo[c] / std::numbers::pi;
    EXPECT_NEAR(without[0].radiance[c] - with[0].radiance[c], direct, 0.02 * direct) << c;
    EXPECT_NEAR(without[1].radiance[c], with[1].radiance[c], 2.5e-3 * with[1].radiance[c]) << c;
  }
}

// Under a low sun the shade of a black ball lacks the bright sky about the sun: its ground sends back what a picture of
// all directions of the sky holds beside the ball.
TEST(SphereSky, ShadesLackTheSkyThatTheBallHides) {
  Scene scene = ball_scene(SphereMaterial::matte);
  scene.sun.elevation = 7.0 * kDegree;
  scene.sun.azimuth = 90.0 * kDegree;
  scene.spheres = {sphere_of(SphereMaterial::matte, 0.0, -7.0, 8.0 * kMetre, 1.0 * kMetre)};
  scene.spheres[0].albedo = {0.0, 0.0, 0.0};
  const Scene round = all_round(without_spheres(scene), 0.0, 256, 128);
  const RadianceImage sky = render_now(round).radiance;
  Physics p = make_physics(round);
  const physics::SphereData ball = spheres_of(scene)[0];
  const vec3 west(-1.0, 0.0, 0.0);
  for (const double behind : {1.5, 3.0, 6.0, 12.0}) {
    vec3 spot = ball.centre + west * (behind * kMetre);
    spot.y = -scene.camera.altitude;
    vec3 beside(0.0);
    for (int y = 0; y < 64; ++y) {
      for (int x = 0; x < 256; ++x) {
        const vec3 d = p.view_ray(p.scene.camera, physics::kProjectionEquirectangular, x + 0.5, y + 0.5).direction;
        const vec3 light = vec3(channel_of(sky, x, y, 0), channel_of(sky, x, y, 1), channel_of(sky, x, y, 2)) *
                           (std::max(d.y, 0.0) * solid_angle(round, x, y));
        beside = beside + light * (p.distance_to_sphere(ball, spot, d) > 0.0 ? 0.0 : 1.0);
      }
    }
    const ProbeResult seen = probe_now(scene, {direction_of(physics::normalize(spot))}).front();
    for (std::size_t c = 0; c < 3; ++c) {
      const double truth = scene.planet.ground_albedo[c] / std::numbers::pi * channel_at(beside, c);
      EXPECT_NEAR(seen.radiance[c], truth, 0.02 * truth) << behind << " m, " << c;
    }
  }
}

// A ball of kilometres in haze. Its shadow takes from the air behind it the single scattering of the hidden sunlight,
// computed at points along the ray with the disc's penumbra.
TEST(SphereSky, ShaftsAreTheSunlightThatIsHidden) {
  for (const char* shells : {"never", "always"}) {
    Scene scene = ball_scene(SphereMaterial::matte, shells);
    scene.media[1].scattering = {0.03, 0.03, 0.03};
    scene.sun.elevation = 12.0 * kDegree;
    scene.sun.azimuth = 0.0;
    scene.camera.altitude = 0.1;
    scene.spheres = {sphere_of(SphereMaterial::matte, 0.0, 30.0, 6.0, 2.0)};
    std::vector<Direction> directions;
    for (const double elevation : {5.0, 12.0, 50.0}) {
      for (const double azimuth : {-8.0, 0.0, 3.0}) {
        directions.push_back({elevation * kDegree, azimuth * kDegree});
      }
    }
    directions.push_back({20.0 * kDegree, 150.0 * kDegree});
    const std::vector<ProbeResult> with = probe_now(scene, directions);
    Scene open = scene;
    open.render.parameters.find("volumetric_shadows")->second = std::string("false");
    const std::vector<ProbeResult> without = probe_now(open, directions);
    Physics p = make_physics(scene);
    p.spheres = spheres_of(scene);
    const OpticalDepth depth(p);
    double greatest_share = 0.0;
    for (std::size_t k = 0; k < directions.size(); ++k) {
      const vec3 view = p.direction_from_angles(directions[k].elevation, directions[k].azimuth);
      const auto ray = p.ray_from(p.scene.planet, scene.camera.altitude, vec3(0.0), view, p.scene.sun.direction);
      const auto hit = p.nearest_body(vec3(0.0), view, physics::kNoBody);
      const double end = hit.hit ? hit.distance_ : 60.0;
      vec3 hidden(0.0);
      constexpr int kSteps = 3000;
      for (int i = 0; i < kSteps; ++i) {
        const double t = end * (i + 0.5) / kSteps;
        const auto point = p.point_on_ray(p.scene.planet, ray, t);
        const double lit =
            p.sun_past_bodies(view * t, p.scene.sun.direction, p.scene.sun.angular_radius, physics::kNoBody);
        const vec3 through = exp(-(depth.along(ray.h, ray.mu, t) + depth.to_top(point.h, point.mu_sun)));
        hidden = hidden + through * p.air_at(point.h, p.phases(ray.nu)).phase_scattering * ((1.0 - lit) * end / kSteps);
      }
      for (std::size_t c = 0; c < 3; ++c) {
        const double taken = without[k].radiance[c] - with[k].radiance[c];
        const double truth = channel_at(hidden, c);
        greatest_share = std::max(greatest_share, truth / without[k].radiance[c]);
        EXPECT_NEAR(taken, truth, 0.05 * truth + 0.002 * without[k].radiance[c]) << shells << " " << k << ", " << c;
      }
    }
    EXPECT_GT(greatest_share, 0.1);
  }
}

TEST(SphereSky, HideTheDisc) {
  Scene scene = ball_scene(SphereMaterial::matte);
  scene.sun.disc.visible = true;
  scene.bloom.enabled = true;
  scene.sun.azimuth = 0.0;
  scene.sun.elevation = 20.0 * kDegree;
  scene.camera.pitch = 20.0 * kDegree;
  scene.camera.vertical_fov = 6.0 * kDegree;
  EXPECT_GT(greatest(render_now(scene).radiance), 1e3);
  EXPECT_TRUE(sun_glares(part_of(scene)));
  scene.spheres[0].elevation = scene.sun.elevation;
  EXPECT_LT(greatest(render_now(scene).radiance), 1.0);
  EXPECT_FALSE(sun_glares(part_of(scene)));
}

// Rays that meet no ball show the sky as without them; along the balls' edges a pixel is the mean over its area.
TEST(SphereSky, EdgesAreMeansAndTheRestIsTheSky) {
  constexpr int kSide = 8;
  for (const SphereMaterial material : {SphereMaterial::matte, SphereMaterial::mirror}) {
    const Scene scene = ball_scene(material);
    Scene finer = scene;
    finer.image = {12 * kSide, 12 * kSide};
    const RadianceImage made = render_now(scene).radiance;
    const RadianceImage fine = render_now(finer).radiance;
    const RadianceImage bare = render_now(without_spheres(scene)).radiance;
    for (int k = 0; k < 144; ++k) {
      const int x = k % 12;
      const int y = k / 12;
      double truth = 0.0;
      for (int i = 0; i < kSide * kSide; ++i) {
        truth += channel_of(fine, x * kSide + i % kSide, y * kSide + i / kSide, 1) / (kSide * kSide);
      }
      // A sixteenth of the step from lit ground to shadow.
      EXPECT_NEAR(channel_of(made, x, y, 1), truth, 0.06 * truth + 0.04 / 16.0) << x << ", " << y;
      if (std::hypot(x - 5.5, y - 5.5) > 5.0 && y < 6) {
        EXPECT_NEAR(channel_of(made, x, y, 1), channel_of(bare, x, y, 1), 1e-5 * channel_of(bare, x, y, 1));
      }
    }
  }
}

// A mirror's pixels are means whatever they show: sky, ground, the horizon, the sun, another ball and the edge of its
// shadow. Five of a hundred hold an edge, which eight rays resolve to some percent; two of a thousand the sun's image.
TEST(SphereSky, MirrorsAreMeans) {
  constexpr int kSide = 8;
  constexpr int kPixels = 48;
  Scene scene = ball_scene(SphereMaterial::mirror);
  scene.camera.vertical_fov = 13.0 * kDegree;
  scene.image = {kPixels, kPixels};
  scene.sun.elevation = 25.0 * kDegree;
  scene.sun.disc.visible = true;
  scene.spheres.push_back(sphere_of(SphereMaterial::matte, 30.0, -4.0, 6.0 * kMetre, 0.8 * kMetre));
  Scene finer = scene;
  finer.image = {kPixels * kSide, kPixels * kSide};
  const RadianceImage made = render_now(scene).radiance;
  const RadianceImage fine = render_now(finer).radiance;
  std::vector<double> off;
  for (int k = 0; k < kPixels * kPixels; ++k) {
    const int x = k % kPixels;
    const int y = k / kPixels;
    if (std::hypot(x - 23.5, y - 23.5) > 23.5) {
      continue;
    }
    double truth = 0.0;
    for (int i = 0; i < kSide * kSide; ++i) {
      truth += channel_of(fine, x * kSide + i % kSide, y * kSide + i / kSide, 1) / (kSide * kSide);
    }
    off.push_back(std::abs(channel_of(made, x, y, 1) / truth - 1.0));
  }
  std::sort(off.begin(), off.end());
  for (const auto& [share, bound] : {std::pair(0.95, 0.009), {0.99, 0.06}, {0.995, 0.11}, {0.998, 0.3}}) {
    EXPECT_LT(off[static_cast<std::size_t>(share * static_cast<double>(off.size()))], bound) << share;
  }
}

}  // namespace
}  // namespace airlight::test
