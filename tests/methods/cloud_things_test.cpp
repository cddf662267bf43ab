// Clouds among terrain, spheres and maps of the ground in pictures by `orders`.

#include <cmath>
#include <cstdio>
#include <numbers>

#include "core/air/scene_block.h"
#include "core/things/ground.h"
#include "tests/methods/cloud_scene.h"
#include "tests/of_scene.h"

namespace airlight::test {
namespace {

using physics::vec3;

// Black balls of cloud, in which light is only lost, over level ground.
Scene among_black_balls() {
  Scene scene = under_level_cloud(1.0, std::sin(radians(40.0)));
  Cloud& cloud = scene.clouds.front();
  auto contents = field_of_balls();
  for (float& extinction : contents->extinction) {
    extinction *= 0.15F;
  }
  contents->identity = "thin balls";
  cloud.contents = contents;
  cloud.single_scattering_albedo = 0.0;
  scene.sun.azimuth = radians(180.0);
  scene.camera.altitude = 0.2;
  return scene;
}

Sphere matte(double azimuth, double elevation, double distance, double radius) {
  Sphere sphere;
  sphere.azimuth = radians(azimuth);
  sphere.elevation = radians(elevation);
  sphere.distance = distance;
  sphere.radius = radius;
  sphere.albedo = {0.6, 0.6, 0.6};
  return sphere;
}

void put_range(Scene& scene) {
  Terrain terrain;
  terrain.ridge = Ridge{7, 1.9};
  terrain.width = 20.0;
  terrain.bearing = radians(0.0);
  terrain.distance = 8.0;
  terrain.albedo = {0.4, 0.4, 0.4};
  scene.terrain = terrain;
}

void put_even_map(Scene& scene) {
  auto files = std::make_shared<GroundFiles>();
  files->identity = "even";
  files->colour_rows = 4;
  files->colours.assign(3 * 4 * 8, 0.25F);
  scene.ground = GroundMap{.albedo_map = "even", .ocean = {}, .files = files};
  scene.planet.ground_albedo = mean_albedo(*files);
}

vec3 east_north_up(const vec3& d) {
  return {d.x, -d.z, d.y};
}

// What the cloud leaves of sunlight to the nearest surface along a ray, and from there to the camera, by short steps
// through its grid; 0: the ray meets none, or in too dark a shade.
double left_to_camera(physics::Physics& p, const Scene& scene, const CloudGrid& grid, const vec3& view) {
  const auto sight = p.sight_of(view);
  const auto hit = p.nearest_thing(p.scene.planet, sight, physics::kNoBody);
  if (hit.what == p.kMeetsSky || hit.distance_ > 40.0) {
    return 0.0;
  }
  const vec3 up(0.0, 0.0, scene.camera.altitude);
  const vec3 way = east_north_up(view);
  const vec3 at = way * hit.distance_ + up;
  const vec3 to_sun = east_north_up(p.scene.sun.direction);
  const double above = std::max(2.0 - at.z, 0.0) / to_sun.z;
  return std::exp(-water_depth_from(grid, up, way, hit.distance_) - water_depth_from(grid, at, to_sun, above));
}

struct Sum {
  double error = 0.0;
  double expected = 0.0;
  int shaded = 0;
};

// Surfaces at rays that a cloud dims: the light with it over the light without.
Sum dimming(const Scene& scene, const std::vector<Direction>& directions) {
  Scene clear = scene;
  clear.clouds.clear();
  clear.render.parameters.find("tabulate")->second = std::string("always");
  const CloudGrid grid = cloud_grid(scene.clouds.front());
  const Part part = part_of(scene);
  physics::Physics p = formulas_of(part.air, part.scene);
  part.things.put_into(p);
  const std::vector<ProbeResult> found = probe_now(scene, directions);
  const std::vector<ProbeResult> without = probe_now(clear, directions);
  Sum sum;
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const vec3 view = p.direction_from_angles(directions[i].elevation, directions[i].azimuth);
    const double left = left_to_camera(p, scene, grid, view);
    // A surface in the shade of things sends next to nothing.
    if (left > 0.0 && without[i].radiance[1] > 1e-3 * scene.sun.irradiance[1]) {
      sum.error += std::abs(found[i].radiance[1] / without[i].radiance[1] - left);
      sum.expected += left;
      sum.shaded += left < 0.9 ? 1 : 0;
    }
  }
  return sum;
}

std::vector<Direction> lattice(double lowest, double highest) {
  std::vector<Direction> directions;
  for (int i = 0; i < 400; ++i) {
    directions.push_back({radians(lowest + (highest - lowest) * (i % 16) / 15.0), radians(i * 0.9 - 180.0)});
  }
  return directions;
}

TEST(CloudThings, SurfacesLoseWhatTheCloudTakesOnBothWays) {
  Scene range = among_black_balls();
  put_range(range);
  Scene balls = among_black_balls();
  Scene map = among_black_balls();
  for (double azimuth = -180.0; azimuth < 180.0; azimuth += 12.0) {
    for (double elevation = 12.0; elevation < 80.0; elevation += 17.0) {
      // Below the cloud, in it and behind it.
      balls.spheres.push_back(matte(azimuth, elevation,
                                    (0.5 + std::fmod(elevation, 3.0)) / std::sin(radians(elevation)),
                                    0.07 / std::sin(radians(elevation))));
    }
  }
  put_even_map(map);
  map.camera.altitude = 3.0;
  struct Case {
    const char* name;
    const Scene& scene;
    std::vector<Direction> directions;
  };
  std::vector<Direction> centres;
  for (const Sphere& sphere : balls.spheres) {
    centres.push_back({sphere.elevation, sphere.azimuth});
  }
  for (const Case& one : {Case{"range", range, lattice(-4.0, 9.0)}, Case{"balls", balls, centres},
                          Case{"map", map, lattice(-80.0, -15.0)}}) {
    const Sum sum = dimming(one.scene, one.directions);
    std::printf("%s: %d dimmed rays, error %.2f %%\n", one.name, sum.shaded, 100.0 * sum.error / sum.expected);
    EXPECT_GE(sum.shaded, 15) << one.name;
    EXPECT_LT(sum.error / sum.expected, 0.02) << one.name;
  }
}

// Q and U are those of the air, in front of a black cloud and behind it.
TEST(CloudThings, PolarisedLightOfTheAirIsDimmedAsAllItsLight) {
  Scene scene = under_level_cloud(0.5, std::sin(radians(40.0)));
  scene.clouds.front().single_scattering_albedo = 0.0;
  scene.media.front().density = exponential(1.2);
  scene.spheres = {matte(0.0, -89.0, 5.0, 0.01)};  // out of sight
  std::vector<Direction> directions;
  for (const double azimuth : {20.0, 80.0, 140.0}) {
    directions.push_back({radians(50.0), radians(azimuth)});
  }
  for (const bool things : {true, false}) {
    if (!things) {
      scene.spheres.clear();
    }
    Scene clear = scene;
    clear.clouds.clear();
    const std::vector<ProbeResult> found = probe_now(scene, directions);
    const std::vector<ProbeResult> without = probe_now(clear, directions);
    for (std::size_t i = 0; i < directions.size(); ++i) {
      const double share = found[i].radiance[1] / without[i].radiance[1];
      EXPECT_LT(share, 0.8);
      EXPECT_NEAR(found[i].q->at(1) / without[i].q->at(1), share, 0.02 * share) << things << i;
      EXPECT_NEAR(found[i].u->at(1) / without[i].u->at(1), share, 0.02 * share) << things << i;
    }
  }
}

// Difference of a coarse picture from the mean of a finer one, over the mean.
double coarseness(Scene scene) {
  constexpr int kFiner = 8;
  const ImageSize coarse_size = scene.image;
  const Rendering coarse = render_now(scene);
  scene.image.width *= kFiner;
  scene.image.height *= kFiner;
  const Rendering fine = render_now(scene);
  double error = 0.0;
  double mean = 0.0;
  for (int y = 0; y < coarse_size.height; ++y) {
    for (int x = 0; x < coarse_size.width; ++x) {
      double sum = 0.0;
      for (int k = 0; k < kFiner * kFiner; ++k) {
        sum += fine.radiance.at(x * kFiner + k % kFiner, y * kFiner + k / kFiner)[1] / (kFiner * kFiner);
      }
      error += std::abs(coarse.radiance.at(x, y)[1] - sum);
      mean += sum;
    }
  }
  return error / mean;
}

// Pixels that things fill in part show the mean of both parts: edges of a level cloud's balls are as coarse as those of
// balls in clear air.
TEST(CloudThings, EdgesOfThingsAreMeans) {
  Scene scene = under_level_cloud(1.0, std::sin(radians(40.0)));
  scene.planet.ground_albedo = {0.3, 0.3, 0.3};
  scene.sun.azimuth = radians(180.0);
  scene.camera.altitude = 0.2;
  scene.camera.azimuth = radians(0.0);
  scene.camera.pitch = radians(35.0);
  scene.camera.vertical_fov = radians(40.0);
  scene.spheres = {matte(-8.0, 30.0, 1.2, 0.25), matte(9.0, 40.0, 2.0, 0.3), matte(0.0, 45.0, 4.0, 0.4)};
  scene.image = {24, 16};
  const double error = coarseness(scene);
  std::printf("edges: %.2f %%\n", 100.0 * error);
  EXPECT_LT(error, 0.01);
}

// A cloud without water is no cloud.
TEST(CloudThings, AnEmptyCloudChangesNothing) {
  Scene scene = under_level_cloud(0.0, std::sin(radians(25.0)));
  scene.media = earth().media;
  scene.planet.ground_radius = 6360.0;
  scene.planet.atmosphere_height = 100.0;
  put_range(scene);
  scene.spheres = {matte(5.0, 4.0, 3.0, 0.2)};
  scene.image = {24, 16};
  scene.camera.altitude = 0.3;
  scene.camera.vertical_fov = radians(40.0);
  scene.render.parameters.find("tabulate")->second = std::string("always");
  const Rendering found = render_now(scene);
  scene.clouds.clear();
  const Rendering clear = render_now(scene);
  double error = 0.0;
  for (std::size_t i = 0; i < clear.radiance.rgba.size(); ++i) {
    error = std::max(error, std::abs(found.radiance.rgba[i] / static_cast<double>(clear.radiance.rgba[i]) - 1.0));
  }
  std::printf("empty cloud: %.1e\n", error);
  EXPECT_LT(error, 2e-3);
}

// A ball of 5 m deep in the shadow of a black cloud, in a vacuum, sees ground in the same shadow: what it gets from
// ground is little, by how far away lit ground begins.
TEST(CloudThings, GroundInAShadowLightsLittle) {
  constexpr double kHeight = 0.01;  // km, of the ball's centre
  Scene scene = under_level_cloud(1.0, std::sin(radians(40.0)));
  scene.clouds.front().contents = field_of_balls();
  scene.clouds.front().single_scattering_albedo = 0.0;
  scene.planet.ground_albedo = {0.3, 0.3, 0.3};
  scene.camera.altitude = 0.2;
  const std::vector<Direction> directions = lattice(-60.0, -20.0);
  const std::vector<ProbeResult> ground = probe_now(scene, directions);
  const auto darker = [](const ProbeResult& a, const ProbeResult& b) { return a.radiance[1] < b.radiance[1]; };
  const auto darkest = std::ranges::min_element(ground, darker);
  const double lit = std::ranges::max_element(ground, darker)->radiance[1];
  ASSERT_LT(darkest->radiance[1], 0.001 * lit);
  const Direction toward = directions[static_cast<std::size_t>(darkest - ground.begin())];
  const double away = scene.camera.altitude / std::tan(-toward.elevation);
  const double down = kHeight - scene.camera.altitude;
  Sphere ball = matte(0.0, 0.0, std::hypot(away, down), 0.005);
  ball.azimuth = toward.azimuth;
  ball.elevation = std::atan2(down, away);
  scene.spheres = {ball};
  // Below its middle, half of what the ball sees and more is ground; wholly lit, it would send this.
  const double whole = 0.5 * ball.albedo[1] * lit;
  const double found =
      probe_now(scene, {{ball.elevation - 0.3 * ball.radius / ball.distance, ball.azimuth}})[0].radiance[1];
  std::printf("ground in a shadow lights a ball by %.1f %%\n", 100.0 * found / whole);
  EXPECT_LT(found, 0.1 * whole);
}

// All light of bodies below, in and above a level cloud, against path-trace.
TEST(CloudThings, ScatteredLightOnThingsIsPathTraces) {
  for (const double depth : {4.0, 16.0}) {
    Scene scene = under_level_cloud(depth, std::sin(radians(40.0)));
    scene.planet.ground_albedo = {0.3, 0.3, 0.3};
    scene.sun.azimuth = radians(180.0);
    scene.camera.altitude = 0.2;
    std::vector<Direction> directions;
    for (const double distance : {0.4, 0.9}) {
      scene.spheres.push_back(matte(100.0 * distance, 30.0, distance, 0.1));
      directions.push_back({radians(30.0), radians(100.0 * distance)});
    }
    directions.push_back({radians(-30.0), radians(70.0)});
    const std::vector<ProbeResult> found = probe_now(scene, directions);
    set_path_trace(scene);
    set(scene, "samples", 16384);
    const HostPicture truth = trace(scene, directions);
    for (std::size_t i = 0; i < directions.size(); ++i) {
      const double judge = truth.radiance.at(static_cast<int>(i), 0)[1];
      const double noise = truth.standard_error.at(static_cast<int>(i), 0)[1];
      std::printf("depth %.0f, direction %zu: %+.1f +- %.1f %%\n", depth, i,
                  100.0 * (found[i].radiance[1] / judge - 1.0), 100.0 * noise / judge);
      EXPECT_LT(noise, 0.04 * judge);
      // The light of the cloud's base is taken as even; a thick one's is less toward its horizon, which these sides of
      // the bodies face.
      EXPECT_NEAR(found[i].radiance[1], judge, 0.13 * judge + 3.0 * noise) << depth << " " << i;
    }
  }
}

}  // namespace
}  // namespace airlight::test
