#pragma once
// Clouds of simple shape over level ground, for tests.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/clouds/cloud_grid.h"
#include "tests/methods/path_trace_scene.h"
#include "tests/methods/render_fixture.h"

namespace airlight::test {

inline constexpr double kAsymmetryOfDrops = 0.85;

// An even cloud round a planet so large that it is level, in air that hardly scatters.
inline Scene under_level_cloud(double optical_depth, double sun_mu) {
  Scene scene = vacuum();
  scene.planet.ground_radius = 1e6;
  scene.planet.atmosphere_height = 20.0;
  scene.planet.ground_albedo = {0.0, 0.0, 0.0};
  scene.media = {medium(PhaseFunction::rayleigh, 0.0, {1e-9, 1e-9, 1e-9}, {0.0, 0.0, 0.0}, exponential(8.0))};
  scene.sun.elevation = std::asin(sun_mu);
  scene.sun.azimuth = 0.0;
  scene.sun.disc.visible = false;
  Cloud cloud;
  cloud.kind = CloudKind::volume;
  cloud.base = 1.0;
  cloud.top = 2.0;
  cloud.repeats = true;
  cloud.phase = CloudPhase::henyey_greenstein;
  cloud.phase_g = kAsymmetryOfDrops;
  auto contents = std::make_shared<CloudFile>();
  contents->nx = 4;
  contents->ny = 4;
  contents->nz = 20;
  contents->dx = 1.0;
  contents->dy = 1.0;
  contents->dz = 0.05;
  contents->lowest = 1.0;
  contents->extinction.assign(4 * 4 * 20, static_cast<float>(optical_depth));
  contents->identity = "level " + std::to_string(optical_depth);
  cloud.contents = contents;
  scene.clouds = {cloud};
  return with_method(scene, *find_method("orders"));
}

// A ball that fades outward, in a field that repeats itself.
inline std::shared_ptr<CloudFile> field_of_balls() {
  constexpr int kSide = 20;
  auto contents = std::make_shared<CloudFile>();
  contents->nx = contents->ny = kSide;
  contents->nz = 10;
  contents->dx = contents->dy = contents->dz = 0.1;
  contents->lowest = 1.05;
  for (int k = 0; k < contents->nz; ++k) {
    for (int j = 0; j < kSide; ++j) {
      for (int i = 0; i < kSide; ++i) {
        const double r = std::hypot(i + 0.5 - 10.0, j + 0.5 - 10.0, 1.4 * (k + 0.5 - 5.0)) / 6.0;
        contents->extinction.push_back(static_cast<float>(15.0 * std::clamp(3.0 * (1.0 - r), 0.0, 1.0)));
      }
    }
  }
  contents->identity = "ball";
  return contents;
}

// The optical depth from a place above level ground, km east, north and up, by short steps.
inline double water_depth_from(const CloudGrid& grid, const physics::vec3& from, const physics::vec3& d, double limit) {
  constexpr double kStep = 0.008;
  double depth = 0.0;
  for (double t = 0.5 * kStep; t < limit; t += kStep) {
    depth += kStep * grid.at(from.x + t * d.x, from.y + t * d.y, from.z + t * d.z);
  }
  return depth;
}

// Air that scatters sunlight once among black clouds: L over the irradiance, by short steps along the ray and toward
// the sun. `shade`: what a cloud leaves of light from a place of the ray, at its distance.
template <class Shade>
double scattered_by_air(const Scene& scene, double mu, double nu, Shade shade) {
  const double radius = scene.planet.ground_radius;
  const double from = radius + scene.camera.altitude;
  const Medium& air = scene.media.front();
  const double phase = 3.0 / (16.0 * std::numbers::pi) * (1.0 + nu * nu);
  double light = 0.0;
  double t = 0.0;
  double altitude = scene.camera.altitude;
  while (altitude > 0.0 && altitude < scene.planet.atmosphere_height) {
    const double step = 0.01 + 0.002 * t;
    t += 0.5 * step;
    const double r = std::sqrt(from * from + t * (2.0 * from * mu + t));
    altitude = scene.camera.altitude + t * (2.0 * from * mu + t) / (from + r);
    light += step * air.scattering[1] * std::exp(-altitude / air.density.scale_height) * phase * shade(t, altitude);
    t += 0.5 * step;
  }
  return light;
}

inline Scene among_black_clouds(double sun_elevation_deg) {
  Scene scene = under_level_cloud(1.0, std::sin(radians(sun_elevation_deg)));
  scene.sun.elevation = radians(sun_elevation_deg);
  scene.media.front().density = exponential(1.2);
  scene.clouds.front().single_scattering_albedo = 0.0;
  scene.camera.altitude = 0.05;
  return scene;
}

inline Scene by_path_trace(const Scene& scene, int samples) {
  Scene judge = with_method(scene, *find_method("path-trace"));
  judge.render.parameters.find("samples")->second = samples;
  return judge;
}

// The means of red, green and blue are off by no more than these shares.
inline void expect_means(const std::vector<float>& found, const std::vector<float>& truth,
                         const std::array<double, 3>& bounds) {
  for (std::size_t c = 0; c < 3; ++c) {
    double sum = 0.0;
    double expected = 0.0;
    for (std::size_t i = c; i < found.size(); i += 3) {
      sum += static_cast<double>(found[i]);
      expected += static_cast<double>(truth[i]);
    }
    std::printf("channel %zu: %+.1f %%\n", c, 100.0 * (sum / expected - 1.0));
    EXPECT_NEAR(sum / expected, 1.0, bounds[c]) << c;
  }
}

// The method `orders` refuses it in these words and names path-trace.
inline void expect_cloud_refused(const Scene& scene, const std::string& words) {
  try {
    render_now(scene);
    FAIL() << "not refused: " << words;
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("path-trace"), std::string::npos) << error.what();
  }
}

// Noise carves its edge finer than its grid.
inline Cloud carved_cloud(CloudKind kind, double cover) {
  Cloud cloud;
  cloud.kind = kind;
  cloud.cover = cover;
  cloud.base = 1.0;
  cloud.top = 2.0;
  cloud.cell = 1.5;
  cloud.period = 6.0;
  cloud.detail = 0.1;
  cloud.water = 0.1;
  cloud.effective_radius = 10.0;
  cloud.phase = CloudPhase::henyey_greenstein;
  cloud.phase_g = 0.0;
  cloud.single_scattering_albedo = 1e-3;
  return cloud;
}

// A field of cumulus without air, of which all is seen above the horizon.
inline Scene among_cumulus(double sun_elevation_deg, double cover) {
  Scene scene = under_level_cloud(1.0, std::sin(radians(sun_elevation_deg)));
  scene.planet.ground_radius = 6371.0;
  scene.sun.azimuth = radians(130.0);
  scene.image = {48, 27};
  scene.camera.altitude = 0.1;
  scene.camera.azimuth = radians(304.0);
  scene.camera.pitch = radians(12.0);
  scene.camera.vertical_fov = radians(38.0);
  Cloud cloud = carved_cloud(CloudKind::cumulus, cover);
  cloud.top = 2.4;
  cloud.cell = 2.0;
  cloud.period = 16.0;
  cloud.detail = 0.05;
  cloud.water = 0.2316;
  cloud.shear = 0.2;
  cloud.wind = radians(60.0);
  cloud.single_scattering_albedo = 1.0;
  scene.clouds = {cloud};
  return scene;
}

// The same among broken sheets, of stratocumulus.
inline Scene among_sheets(double sun_elevation_deg, double cover) {
  Scene scene = among_cumulus(sun_elevation_deg, cover);
  Cloud& cloud = scene.clouds.front();
  cloud.kind = CloudKind::stratocumulus;
  cloud.base = 0.8;
  cloud.top = 1.2;
  cloud.cell = 1.2;
  cloud.shear = 0.0;
  return scene;
}

}  // namespace airlight::test
