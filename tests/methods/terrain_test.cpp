// Terrain in the picture of `orders`: against the picture without it, and its shadow in the air against single
// scattering along the ray by quadrature.
#include "core/things/terrain.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/methods/path_trace/optical_depth.h"
#include "core/post/post.h"
#include "tests/methods/terrain_scene.h"
#include "tests/of_scene.h"

namespace airlight::test {
namespace {

// The range, with a camera that looks at it.
Scene range(double elevation) {
  Scene scene = range_in_haze("orders", elevation);
  scene.camera.azimuth = 90.0 * kDegree;
  scene.bloom.enabled = false;
  scene.terrain->albedo = {0.2, 0.2, 0.2};
  return scene;
}

// High sun, looking away from the range: the march with terrain is the march without.
TEST(TerrainSky, FarFromItNothingChanges) {
  for (const char* shells : {"never", "always"}) {
    Scene with = range(60.0);
    with.render.parameters.find("shells")->second = std::string(shells);
    with.render.parameters.find("steps")->second = 96;
    with.camera.azimuth = 270.0 * kDegree;
    with.camera.pitch = 5.0 * kDegree;
    with.image = {12, 8};
    Scene without = with;
    without.terrain.reset();
    const Rendering a = render_now(with);
    const Rendering b = render_now(without);
    for (int y = 0; y < 8; ++y) {
      for (int x = 0; x < 12; ++x) {
        for (std::size_t c = 0; c < 3; ++c) {
          const double truth = channel_of(b.radiance, x, y, c);
          EXPECT_NEAR(channel_of(a.radiance, x, y, c), truth, 0.01 * truth) << shells << " " << x << ", " << y;
        }
      }
    }
  }
}

// Half a degree behind the crest the disc is gone, glare and all; from above the crest it is whole.
TEST(TerrainSky, HidesTheDisc) {
  for (const bool above : {false, true}) {
    Scene scene = range(above ? 12.0 : 3.0);
    scene.camera.pitch = scene.sun.elevation;
    scene.camera.vertical_fov = 6.0 * kDegree;
    scene.image = {24, 24};
    Scene dark = scene;
    dark.sun.disc.visible = false;
    const RadianceImage with = render_now(scene).radiance;
    const RadianceImage without = render_now(dark).radiance;
    EXPECT_EQ(greatest(with) > 2.0 * greatest(without), above);
    EXPECT_EQ(sun_glares(part_of(scene)), above);
  }
}

// The shadow's effect on the sky over the range: the radiances with and without it differ by the single scattering of
// the sunlight that the terrain hides.
TEST(TerrainSky, ShaftsAreTheSunlightThatIsHidden) {
  for (const char* shells : {"never", "always"}) {
    Scene scene = range(4.0);
    scene.render.parameters.find("shells")->second = std::string(shells);
    std::vector<Direction> directions;
    for (const double elevation : {7.5, 9.0, 14.0}) {
      for (const double azimuth : {80.0, 90.0, 97.0}) {
        directions.push_back({elevation * kDegree, azimuth * kDegree});
      }
    }
    const std::vector<ProbeResult> with = probe_now(scene, directions);
    Scene open = scene;
    open.render.parameters.find("volumetric_shadows")->second = std::string("false");
    const std::vector<ProbeResult> without = probe_now(open, directions);
    physics::Physics p = make_physics(scene);
    p.terrain_maps = shadowed_terrain(scene);
    const OpticalDepth depth(p);
    double greatest_share = 0.0;
    for (std::size_t k = 0; k < directions.size(); ++k) {
      const physics::vec3 view = p.direction_from_angles(directions[k].elevation, directions[k].azimuth);
      const auto track = p.ground_track(scene.camera.altitude, view);
      ASSERT_FALSE(p.terrain_hit(p.scene.planet, track).hit);
      const auto ray = p.ray_in_atmosphere(p.scene.planet, scene.camera.altitude, view.y, p.scene.sun.direction.y,
                                           physics::dot(view, p.scene.sun.direction));
      physics::vec3 hidden(0.0);
      constexpr int kSteps = 4000;
      const double end = 80.0;
      for (int i = 0; i < kSteps; ++i) {
        const double t = end * (i + 0.5) / kSteps;
        const auto point = p.point_on_ray(p.scene.planet, ray, t);
        const double s = p.ground_distance(p.scene.planet, ray.h, ray.mu, t);
        const double lit = p.terrain_sunlit(p.terrain_shape(), track.east * s, track.north * s, point.h);
        const physics::vec3 through = exp(-(depth.along(ray.h, ray.mu, t) + depth.to_top(point.h, point.mu_sun)));
        hidden = hidden + through * p.air_at(point.h, p.phases(ray.nu)).phase_scattering * ((1.0 - lit) * end / kSteps);
      }
      for (std::size_t c = 0; c < 3; ++c) {
        const double taken = without[k].radiance[c] - with[k].radiance[c];
        const double truth = c == 0 ? hidden.x : c == 1 ? hidden.y : hidden.z;
        greatest_share = std::max(greatest_share, truth / without[k].radiance[c]);
        EXPECT_NEAR(taken, truth, 0.05 * truth + 0.002 * without[k].radiance[c]) << shells << " " << k << ", " << c;
      }
    }
    EXPECT_GT(greatest_share, 0.1) << "no shaft to see";
  }
}

// An edge is a mixture: no pixel of the crest is outside the range of the values above and below it, and the crest's
// pixels have many values, not two.
TEST(TerrainSky, EdgesAreSmooth) {
  Scene scene = range(30.0);
  scene.sun.azimuth = 270.0 * kDegree;
  scene.terrain->albedo = {};
  scene.media = {scene.media[2]};  // ozone: a black sky
  scene.planet.ground_albedo = {};
  scene.terrain->albedo = {1.0, 1.0, 1.0};
  scene.camera.pitch = 4.0 * kDegree;
  scene.camera.vertical_fov = 10.0 * kDegree;
  scene.image = {48, 27};
  const RadianceImage picture = render_now(scene).radiance;
  int partial = 0;
  int whole = 0;
  for (int x = 0; x < 48; ++x) {
    int y = 0;
    while (y < 26 && channel_of(picture, x, y, 1) == 0.0) {
      ++y;
    }
    const double edge = channel_of(picture, x, y, 1);
    const double below = channel_of(picture, x, std::min(y + 1, 26), 1);
    partial += edge < 0.8 * below ? 1 : 0;
    whole += edge > 0.0 ? 1 : 0;
  }
  EXPECT_GE(whole, 40);
  EXPECT_GE(partial, 20);
}

}  // namespace
}  // namespace airlight::test
