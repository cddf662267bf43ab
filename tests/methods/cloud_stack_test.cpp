// Several fields of cloud in pictures by `orders`: their shade and their order along rays against integrals, all their
// light against one cloud of their depth and against path-trace.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "core/render/render.h"
#include "tests/methods/cloud_scene.h"
#include "tests/methods/render_fixture.h"
#include "tests/methods/slab.h"

namespace airlight::test {
namespace {

using physics::vec3;

// The cloud between two altitudes, of even extinction, 1/km.
Cloud level_field(Cloud cloud, double base, double top, double per_km) {
  auto contents = std::make_shared<CloudFile>(*cloud.contents);
  contents->dz = (top - base) / contents->nz;
  contents->lowest = base + 0.5 * contents->dz;
  contents->extinction.assign(contents->extinction.size(), static_cast<float>(per_km));
  contents->identity = "even " + std::to_string(per_km);
  cloud.contents = contents;
  cloud.base = base;
  cloud.top = top;
  return cloud;
}

// Balls between two altitudes, moved toward the east.
Cloud balls_field(Cloud cloud, double base, double east, float thinner) {
  auto contents = field_of_balls();
  contents->lowest = base + 0.5 * contents->dz;
  for (float& extinction : contents->extinction) {
    extinction *= thinner;
  }
  contents->identity = "balls " + std::to_string(thinner);
  cloud.contents = contents;
  cloud.base = base;
  cloud.top = base + contents->dz * contents->nz;
  cloud.east = east;
  return cloud;
}

// Length of a ray up to the distance t that lies below an altitude.
double length_below(double radius, double h, double mu, double t, double altitude) {
  const double b = (radius + h) * mu;
  const double q = b * b - (h - altitude) * (2.0 * radius + h + altitude);
  return q <= 0.0 ? 0.0 : std::max(std::min(t, -b + std::sqrt(q)) - std::max(0.0, -b - std::sqrt(q)), 0.0);
}

double depth_of_stack(const Scene& scene, double h, double mu, double t) {
  const double radius = scene.planet.ground_radius;
  double depth = 0.0;
  for (const Cloud& cloud : scene.clouds) {
    const double inside = length_below(radius, h, mu, t, cloud.top) - length_below(radius, h, mu, t, cloud.base);
    depth += inside * static_cast<double>(cloud.contents->extinction.front());
  }
  return depth;
}

// A small planet: rays from a few km up dip below two black veils and rise through them once more. Which veil is before
// which shows in the air's light between them.
TEST(CloudStack, FieldsStandInOrderAlongEachRay) {
  Scene scene = among_black_clouds(35.0);
  scene.planet.ground_radius = 300.0;
  scene.media.front().density = exponential(4.0);
  const Cloud veil = scene.clouds.front();
  scene.clouds = {level_field(veil, 4.0, 5.0, 0.03), level_field(veil, 1.0, 2.0, 0.06)};
  struct Views {
    double altitude;
    std::vector<double> elevations;
  };
  for (const Views& views : {Views{0.05, {70.0, 20.0}}, Views{1.5, {30.0, -3.0}}, Views{3.0, {30.0, -7.0}},
                             Views{4.5, {10.0, -9.0}}, Views{7.0, {-11.5}}}) {
    scene.camera.altitude = views.altitude;
    std::vector<Direction> directions;
    for (const double elevation : views.elevations) {
      directions.push_back({radians(elevation), radians(70.0)});
    }
    for (const ProbeResult& found : probe_now(scene, directions)) {
      const double mu = std::sin(found.direction.elevation);
      const double nu = mu * std::sin(scene.sun.elevation) + std::cos(found.direction.elevation) *
                                                                 std::cos(scene.sun.elevation) *
                                                                 std::cos(found.direction.azimuth);
      const double radius = scene.planet.ground_radius;
      const double expected = scattered_by_air(scene, mu, nu, [&](double t, double h) {
        const double mu_sun = ((radius + views.altitude) * std::sin(scene.sun.elevation) + t * nu) / (radius + h);
        const double before = depth_of_stack(scene, views.altitude, mu, t);
        return std::exp(-before - depth_of_stack(scene, h, mu_sun, 1e9));
      });
      const double light = found.radiance[1] / scene.sun.irradiance[1];
      const double through = std::exp(-depth_of_stack(scene, views.altitude, mu, 1e9));
      const double degrees = found.direction.elevation / radians(1.0);
      std::printf("from %.2f km at %5.1f degrees: light %+.2f %%, beam %.4f for %.4f\n", views.altitude, degrees,
                  100.0 * (light / expected - 1.0), found.transmittance[1], through);
      EXPECT_NEAR(light, expected, 0.005 * expected) << views.altitude << " " << degrees;
      EXPECT_NEAR(found.transmittance[1], through, 0.01 * through) << views.altitude << " " << degrees;
    }
  }
}

// Black balls over black balls, of which the upper ones stand elsewhere, over white ground; as the planet's ground and
// as a map of it, which a pass over things draws.
TEST(CloudStack, ShadowsOfAllFieldsFallOnTheGround) {
  Scene scene = under_level_cloud(1.0, std::sin(radians(35.0)));
  scene.camera.altitude = 0.2;
  scene.planet.ground_albedo = {1.0, 1.0, 1.0};
  Cloud ball = scene.clouds.front();
  ball.single_scattering_albedo = 1e-3;
  scene.clouds = {balls_field(ball, 3.0, 0.7, 0.2F), balls_field(ball, 1.0, 0.0, 0.2F)};
  const CloudGrid high = cloud_grid(scene.clouds[0]);
  const CloudGrid low = cloud_grid(scene.clouds[1]);
  const vec3 to_sun(0.0, std::cos(radians(35.0)), std::sin(radians(35.0)));  // azimuth 0: north
  std::vector<Direction> directions;
  std::vector<double> truth;
  int both = 0;
  for (int i = 0; i < 60; ++i) {
    const double elevation = -9.0 - i % 12 * 6.0;
    const double azimuth = 10.0 + i * 67.0;
    const double reach = 0.2 / std::tan(radians(-elevation));
    const vec3 place(reach * std::sin(radians(azimuth)), reach * std::cos(radians(azimuth)), 0.0);
    const double by_high = water_depth_from(high, place, to_sun, 4.0 / to_sun.z);
    const double by_low = water_depth_from(low, place, to_sun, 2.0 / to_sun.z);
    directions.push_back({radians(elevation), radians(azimuth)});
    truth.push_back(std::exp(-by_high - by_low));
    both += by_high > 0.05 && by_low > 0.05 ? 1 : 0;
  }
  EXPECT_GE(both, 5);
  Scene mapped = scene;
  auto files = std::make_shared<GroundFiles>();
  files->identity = "white";
  files->colour_rows = 4;
  files->colours.assign(3 * 4 * 8, 1.0F);
  mapped.ground = GroundMap{.albedo_map = "white", .ocean = {}, .files = files};
  for (const Scene& one : {scene, mapped}) {
    const std::vector<ProbeResult> results = probe_now(one, directions);
    double error = 0.0;
    double seen = 0.0;
    for (std::size_t i = 0; i < truth.size(); ++i) {
      const double lit = results[i].radiance[1] / scene.sun.irradiance[1] * std::numbers::pi / to_sun.z;
      error += std::abs(lit - truth[i]);
      seen += truth[i];
    }
    std::printf("two shadows, %d of 60 in both, %s: error %.2f %%\n", both, one.ground ? "a map" : "plain ground",
                100.0 * error / seen);
    EXPECT_LT(error / seen, 0.015);
  }
}

// Two level clouds, however far apart, send and let through what one of their depth does: by adding and doubling.
TEST(CloudStack, TwoLevelCloudsAreOneOfTheirDepth) {
  constexpr int kNodes = 24;
  constexpr int kSun = 16;
  struct Depths {
    double high;
    double low;
  };
  for (const Depths& depths : {Depths{0.5, 4.0}, Depths{4.0, 0.5}, Depths{0.5, 16.0}, Depths{4.0, 4.0}}) {
    const Slab judge({depths.high + depths.low, 1.0, henyey_greenstein_moments(kAsymmetryOfDrops, 48), 0.0}, kNodes,
                     kSun);
    for (const bool above : {true, false}) {
      Scene scene = under_level_cloud(1.0, judge.nodes()[kSun]);
      scene.camera.altitude = above ? 8.0 : 0.0;
      const Cloud cloud = scene.clouds.front();
      scene.clouds = {level_field(cloud, 1.0, 2.0, depths.low), level_field(cloud, 5.0, 6.0, depths.high)};
      std::vector<Direction> directions;
      double expected = 0.0;
      for (const std::size_t node : {8U, 12U, 16U, 20U, 23U}) {
        for (const double azimuth : {0.4, 1.6, 2.9}) {
          const double elevation = std::asin(judge.nodes()[node]);
          const double mu_sun = judge.nodes()[kSun];
          const double across = std::cos(elevation) * std::sqrt(1.0 - mu_sun * mu_sun) * std::cos(azimuth);
          if (above || judge.nodes()[node] * mu_sun + across < std::cos(radians(25.0))) {
            directions.push_back({above ? -elevation : elevation, azimuth});
            expected += above ? judge.reflected(node, azimuth) : judge.transmitted(node, azimuth);
          }
        }
      }
      double found = 0.0;
      for (const ProbeResult& result : probe_now(scene, directions)) {
        found += result.radiance[1] / scene.sun.irradiance[1];
      }
      std::printf("depth %.1f over %.1f, %s: %+.1f %%\n", depths.high, depths.low, above ? "from above" : "from below",
                  100.0 * (found / expected - 1.0));
      EXPECT_NEAR(found / expected, 1.0, 0.08) << depths.high << " " << depths.low << " " << above;
    }
  }
}

Scene balls_under_a_veil() {
  Scene scene = under_level_cloud(1.0, std::sin(radians(40.0)));
  const Cloud cloud = scene.clouds.front();
  scene.clouds = {level_field(cloud, 7.0, 8.0, 0.3), balls_field(cloud, 1.0, 0.0, 1.0F)};
  scene.planet.ground_radius = 6371.0;
  scene.planet.atmosphere_height = 60.0;
  scene.planet.ground_albedo = {0.2, 0.2, 0.2};
  scene.media = {medium(PhaseFunction::rayleigh, 0.0, {5.8e-3, 1.36e-2, 3.31e-2}, {0.0, 0.0, 0.0}, exponential(8.0))};
  scene.camera.altitude = 0.1;
  return scene;
}

// All light among air, balls of cloud, a veil above them and the ground: the sum over directions.
TEST(CloudStack, IsPathTraces) {
  Scene scene = balls_under_a_veil();
  std::vector<Direction> directions;
  for (int i = 0; i < 48; ++i) {
    directions.push_back({radians(i % 6 == 5 ? -12.0 : 12.0 + i % 6 * 14.0), radians(60.0 + 41.0 * i)});
  }
  const std::vector<ProbeResult> found = probe_now(scene, directions);
  set_path_trace(scene);
  set(scene, "samples", 512);
  const HostPicture truth = trace(scene, directions);
  for (std::size_t c = 0; c < 3; ++c) {
    double sum = 0.0;
    double judge = 0.0;
    double variance = 0.0;
    for (std::size_t i = 0; i < directions.size(); ++i) {
      sum += found[i].radiance[c];
      judge += static_cast<double>(truth.radiance.at(static_cast<int>(i), 0)[c]);
      variance += std::pow(static_cast<double>(truth.standard_error.at(static_cast<int>(i), 0)[c]), 2.0);
    }
    std::printf("channel %zu: %+.1f +- %.1f %%\n", c, 100.0 * (sum / judge - 1.0), 100.0 * std::sqrt(variance) / judge);
    EXPECT_LT(std::sqrt(variance), 0.02 * judge) << c;
    EXPECT_NEAR(sum, judge, 0.1 * judge + 3.0 * std::sqrt(variance)) << c;
  }
}

Scene stack_in_a_picture() {
  Scene scene = balls_under_a_veil();
  scene.camera.pitch = radians(20.0);
  scene.camera.azimuth = radians(100.0);
  scene.camera.vertical_fov = radians(60.0);
  scene.image = {31, 17};
  return scene;
}

TEST(CloudStack, TheirOrderInTheFileDoesNotCount) {
  Scene scene = stack_in_a_picture();
  const std::vector<float> picture = render_now(scene).radiance.rgba;
  std::swap(scene.clouds[0], scene.clouds[1]);
  EXPECT_EQ(render_now(scene).radiance.rgba, picture);
}

// To the bit where a field is empty, and nearly where hardly anything is in it.
TEST(CloudStack, AFieldWithoutWaterIsNone) {
  Scene scene = stack_in_a_picture();
  const Cloud veil = scene.clouds[0];
  Scene alone = scene;
  alone.clouds.erase(alone.clouds.begin());
  const std::vector<float> picture = render_now(alone).radiance.rgba;
  scene.clouds[0] = level_field(veil, 7.0, 8.0, 0.0);
  EXPECT_EQ(render_now(scene).radiance.rgba, picture);
  for (const double base : {7.0, 0.4}) {  // over the balls, and under them
    scene.clouds[0] = level_field(veil, base, base + 0.5, 1e-6);
    const std::vector<float> found = render_now(scene).radiance.rgba;
    double error = 0.0;
    double sum = 0.0;
    for (std::size_t i = 0; i < found.size(); ++i) {
      error += std::abs(static_cast<double>(found[i]) - static_cast<double>(picture[i]));
      sum += static_cast<double>(picture[i]);
    }
    std::printf("next to nothing at %.1f km: %.3f %%\n", base, 100.0 * error / sum);
    EXPECT_LT(error / sum, 0.01) << base;
  }
}

TEST(CloudStack, TilesAreThePicture) {
  Scene scene = stack_in_a_picture();
  const Rendering whole = render_now(scene);
  expect_sound(whole, "two fields");
  std::vector<float> rgba;
  BandsRequest request{.tile = ImageSize{7, 5}, .picture = {}, .exposure_first = false, .sink = {}};
  request.sink = [&](const Band& band) {
    rgba.insert(rgba.end(), band.rows.radiance.rgba.begin(), band.rows.radiance.rgba.end());
  };
  render_bands([]() -> Executor& { return executor(); }, scene, request);
  EXPECT_EQ(rgba, whole.radiance.rgba);
}

TEST(CloudStack, RefusesFieldsThatOverlapAndNoOthers) {
  Scene scene = stack_in_a_picture();
  const Cloud veil = scene.clouds[0];
  scene.clouds = {level_field(veil, 1.5, 3.0, 1.0), level_field(veil, 1.0, 2.0, 1.0)};
  expect_cloud_refused(scene, "the one from 1.5 to 3 km begins below the top of the one from 1 to 2 km");
  scene.clouds.clear();
  for (int i = 0; i < kMaxClouds; ++i) {
    scene.clouds.push_back(level_field(veil, 0.5 * i + 0.5, 0.5 * i + 1.0, 1.0));
  }
  scene.image = {4, 4};
  EXPECT_GT(greatest(render_now(scene).radiance), 0.0);
}

}  // namespace
}  // namespace airlight::test
