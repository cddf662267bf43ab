// Q and U, and polarising filters, against path-trace, published values and what light cannot break.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "core/air/scene_block.h"
#include "tests/methods/path_trace_scene.h"
#include "tests/methods/render_fixture.h"
#include "tests/this_build.h"

namespace airlight::test {
namespace {

using physics::vec3;

vec3 direction_of(const Direction& d) {
  const double c = std::cos(d.elevation);
  return {std::sin(d.azimuth) * c, std::sin(d.elevation), -std::cos(d.azimuth) * c};
}

// The angle from the plane of direction and zenith to the filter's axis, as U leans: by rotation about the axis that
// takes the camera's forward direction into the ray's.
double filter_angle(const Camera& camera, const Direction& d) {
  const CameraBasis basis = camera_basis(camera);
  const vec3 ray = direction_of(d);
  vec3 across = basis.up * std::cos(*camera.polariser) + basis.right * std::sin(*camera.polariser);
  const vec3 turn = cross(basis.forward, ray);
  if (length(turn) > 1e-9) {
    const vec3 k = turn / length(turn);
    const double c = dot(basis.forward, ray);
    across = across * c + cross(k, across) * length(turn) + k * (dot(k, across) * (1.0 - c));
  }
  const vec3 toward_azimuth(std::cos(d.azimuth), 0.0, std::sin(d.azimuth));
  const vec3 down(std::sin(d.azimuth) * std::sin(d.elevation), -std::cos(d.elevation),
                  -std::cos(d.azimuth) * std::sin(d.elevation));
  return std::atan2(dot(across, toward_azimuth), dot(across, down));
}

// What the filter lets through of light of these Stokes parameters.
double filtered(const ProbeResult& light, std::size_t c, double angle) {
  return 0.5 * (light.radiance[c] + (*light.q)[c] * std::cos(2.0 * angle) + (*light.u)[c] * std::sin(2.0 * angle));
}

struct FilteredSky {
  const char* name;
  double sun_deg;
  double aerosol;     // over that of Hillaire 2020
  double scattering;  // the molecules', likewise
  double bound;       // of the mean error, over the mean light
};

Scene filtered_sky(const FilteredSky& s) {
  Scene scene = airlight::earth(s.sun_deg, 0.001, 0.1);
  scene.sun.azimuth = radians(40.0);
  scene.camera.projection = Projection::fisheye;
  scene.camera.vertical_fov = std::numbers::pi;
  scene.camera.azimuth = radians(200.0);
  scene.camera.pitch = radians(35.0);
  scene.camera.roll = radians(15.0);
  for (double& x : scene.media[0].scattering) x *= s.scattering;
  for (double& x : scene.media[1].scattering) x *= s.aerosol;
  for (double& x : scene.media[1].absorption) x *= s.aerosol;
  return scene;
}

std::vector<Direction> sky_directions() {
  std::vector<Direction> directions;
  for (const double elevation : {6.0, 35.0, 80.0}) {
    for (const double azimuth : {50.0, 130.0, 250.0}) {
      directions.push_back({radians(elevation), radians(azimuth)});
    }
  }
  return directions;
}

TEST(Stokes, OrdersAgreesWithPathTraceThroughFilters) {
  const FilteredSky skies[]{{"clear, sun at 20", 20.0, 1.0, 1.0, 0.004},
                            {"clear, sun at -2", -2.0, 1.0, 1.0, 0.01},
                            {"hazy, sun at 60", 60.0, 10.0, 1.0, 0.01},
                            {"by shells, sun at 20", 20.0, 0.0, 6.0, 0.01}};
  const std::vector<Direction> directions = sky_directions();
  for (const FilteredSky& s : skies) {
    const std::vector<ProbeResult> found = probe_now(with_method(filtered_sky(s), *find_method("orders")), directions);
    double error = 0.0;
    double noise = 0.0;
    double light = 0.0;
    double swing = 0.0;  // of the light, between the filters
    for (const double angle : {0.0, 45.0, 90.0, 135.0}) {
      Scene traced = filtered_sky(s);
      traced.camera.polariser = radians(angle);
      set(traced, "samples", sanitized() ? 32 : 1024);
      const HostPicture truth = trace(traced, directions);
      for (std::size_t i = 0; i < directions.size(); ++i) {
        constexpr std::size_t kBlue = 2;
        const auto at = [&](const RadianceImage& image) {
          return static_cast<double>(image.at(static_cast<int>(i), 0)[kBlue]);
        };
        const double expected = filtered(found[i], kBlue, filter_angle(traced.camera, directions[i]));
        error += std::abs(expected - at(truth.radiance));
        noise += 0.8 * at(truth.standard_error);
        light += at(truth.radiance);
        swing += std::abs(at(truth.radiance) - 0.5 * found[i].radiance[kBlue]);
        EXPECT_NEAR(expected, at(truth.radiance), 4.5 * at(truth.standard_error) + 0.03 * found[i].radiance[kBlue])
            << s.name << ", filter at " << angle << ", direction " << i;
      }
    }
    std::printf("%s: mean error %.4f, of it noise %.4f; filters change %.3f\n", s.name, error / light, noise / light,
                swing / light);
    EXPECT_LT(error, s.bound * light + (sanitized() ? 3.0 : 1.0) * noise) << s.name;
    EXPECT_GT(swing, 10.0 * s.bound * light) << s.name;
  }
}

// As in polarisation_test.cpp: Natraj, Li and Yung 2009. Q and U for the same directions are not printed there to many
// digits; what is known of the light is I, and that of the prototype's level slab.
}  // namespace
}  // namespace airlight::test
