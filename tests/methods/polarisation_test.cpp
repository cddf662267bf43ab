// Polarised light against published values and against path-trace.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "tests/methods/path_trace_scene.h"
#include "tests/methods/render_fixture.h"
#include "tests/this_build.h"

namespace airlight::test {
namespace {

// Natraj, Li and Yung, Rayleigh scattering in planetary atmospheres: corrected tables through accurate computation of X
// and Y functions, 2009: light out of the top of a level slab of optical depth 0.5 over black ground, for a sun of
// zenith cosine 0.2 and irradiance pi. The scalar values are those of the same slab without polarisation.
struct Published {
  double mu;
  double azimuth_deg;
  double polarised;
  double scalar;
};
constexpr Published kPublished[]{{0.02, 30.0, 0.39444956, 0.37965680}, {0.92, 60.0, 0.05643322, 0.06185836}};

Scene published_slab(bool polarised) {
  Scene scene = slab(0.5, 1.0, PhaseFunction::rayleigh, 0.0);
  scene.render.polarisation = polarised;
  scene.sun.elevation = std::asin(0.2);
  scene.sun.irradiance = {std::numbers::pi, std::numbers::pi, std::numbers::pi};
  scene.camera.altitude = scene.planet.atmosphere_height;
  return scene;
}

std::vector<Direction> published_directions() {
  std::vector<Direction> directions;
  for (const Published& p : kPublished) {
    directions.push_back({-std::asin(p.mu), radians(p.azimuth_deg)});
  }
  return directions;
}

TEST(Polarisation, OrdersMeetsPublishedSlabs) {
  for (const bool polarised : {true, false}) {
    Scene scene = with_method(published_slab(polarised), *find_method("orders"));
    scene.render.parameters["moments_lut"] = TableSize{256, 64};
    const std::vector<ProbeResult> found = probe_now(scene, published_directions());
    for (std::size_t i = 0; i < std::size(kPublished); ++i) {
      const double expected = polarised ? kPublished[i].polarised : kPublished[i].scalar;
      EXPECT_NEAR(found[i].radiance[1], expected, 1e-3 * expected) << i << (polarised ? ", polarised" : ", scalar");
    }
  }
}

TEST(Polarisation, PathTraceMeetsPublishedSlabs) {
  for (const bool polarised : {true, false}) {
    Scene scene = published_slab(polarised);
    set(scene, "samples", 4096);
    const HostPicture picture = trace(scene, published_directions());
    for (int i = 0; i < static_cast<int>(std::size(kPublished)); ++i) {
      const double expected = polarised ? kPublished[i].polarised : kPublished[i].scalar;
      const auto error = static_cast<double>(picture.standard_error.at(i, 0)[1]);
      EXPECT_LT(error, 0.01 * expected);
      EXPECT_NEAR(static_cast<double>(picture.radiance.at(i, 0)[1]), expected, 4.0 * error)
          << i << (polarised ? ", polarised" : ", scalar");
    }
  }
}

struct Sky {
  const char* name;
  double sun_deg;
  double aerosol;         // over that of Hillaire 2020
  double scattering;      // the molecules', likewise
  double depolarisation;  // gamma
  double bound;           // of the mean error
};

Scene sky(const Sky& s) {
  Scene scene = airlight::earth(s.sun_deg, 0.001, 0.1);
  for (double& x : scene.media[0].scattering) x *= s.scattering;
  for (double& x : scene.media[0].depolarization) x = s.depolarisation;
  for (double& x : scene.media[1].scattering) x *= s.aerosol;
  for (double& x : scene.media[1].absorption) x *= s.aerosol;
  return scene;
}

// Both theories against their own judge: what polarisation changes is several times the bound.
TEST(Polarisation, OrdersAgreesWithPathTrace) {
  const Sky skies[]{{"clear, sun at 20", 20.0, 1.0, 1.0, 0.0, 0.004},
                    {"clear, sun at -2", -2.0, 1.0, 1.0, 0.0, 0.008},
                    {"no aerosol, depolarised, sun at 60", 60.0, 0.0, 1.0, 0.05, 0.004},
                    {"hazy, sun at 20", 20.0, 10.0, 1.0, 0.0, 0.01},
                    {"by shells, sun at 20", 20.0, 0.0, 6.0, 0.0, 0.01}};
  std::vector<Direction> directions;
  for (const double elevation : {4.0, 25.0, 60.0, 90.0}) {
    for (const double azimuth : {0.0, 80.0, 180.0}) {
      directions.push_back({radians(elevation), radians(azimuth)});
    }
  }
  for (const Sky& s : skies) {
    Scene traced = sky(s);
    set(traced, "samples", sanitized() ? 32 : 2048);
    const HostPicture truth = trace(traced, directions);
    traced.render.polarisation = false;
    const HostPicture scalar = trace(traced, directions);
    const std::vector<ProbeResult> found = probe_now(with_method(sky(s), *find_method("orders")), directions);
    double error = 0.0;
    double noise = 0.0;
    double effect = 0.0;
    for (std::size_t i = 0; i < directions.size(); ++i) {
      constexpr std::size_t kBlue = 2;
      const auto at = [&](const RadianceImage& image) {
        return static_cast<double>(image.at(static_cast<int>(i), 0)[kBlue]);
      };
      const double share = 1.0 / static_cast<double>(directions.size());
      error += std::abs(found[i].radiance[kBlue] / at(truth.radiance) - 1.0) * share;
      noise += 0.8 * at(truth.standard_error) / at(truth.radiance) * share;
      effect += std::abs(at(scalar.radiance) / at(truth.radiance) - 1.0) * share;
    }
    std::printf("%s: mean error %.4f, of it noise %.4f; polarisation changes %.4f\n", s.name, error, noise, effect);
    EXPECT_LT(error, s.bound + (sanitized() ? 3.0 : 1.0) * noise) << s.name;
    if (!sanitized()) {
      EXPECT_GT(effect, 2.0 * s.bound) << s.name;
    }
  }
}

}  // namespace
}  // namespace airlight::test
