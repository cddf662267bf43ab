// path-trace against closed forms and invariants.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/physics/gauss.h"
#include "path_trace_scene.h"

namespace airlight {
namespace {

const float* radiance(const HostPicture& picture, std::size_t k) {
  return picture.radiance.at(static_cast<int>(k), 0);
}

const float* standard_error(const HostPicture& picture, std::size_t k) {
  return picture.standard_error.at(static_cast<int>(k), 0);
}

// As the air thins, radiance becomes coefficient x phase function x length x irradiance.
TEST(PathTrace, ThinAirScattersOnce) {
  const double length = 10.0 / std::sin(radians(30));
  for (const double thin : {1e-4, 1e-7}) {
    Scene scene = slab(10.0 * thin, 0.8, PhaseFunction::henyey_greenstein, 0.6);
    scene.sun.elevation = radians(50);
    scene.sun.irradiance = {2.0, 3.0, 4.0};
    scene.camera.altitude = 0.0;
    const HostPicture picture = trace(scene, {{radians(30), radians(40)}});
    const double nu = std::sin(radians(30)) * std::sin(radians(50)) +
                      std::cos(radians(30)) * std::cos(radians(50)) * std::cos(radians(40));
    const double phase = (1.0 - 0.36) / (4.0 * std::numbers::pi * std::pow(1.0 + 0.36 - 1.2 * nu, 1.5));
    const double expected = 0.8 * thin * phase * length;
    EXPECT_NEAR(radiance(picture, 0)[0], 2.0 * expected, (40.0 * thin + 3e-5) * 2.0 * expected);
    EXPECT_NEAR(radiance(picture, 0)[2] / radiance(picture, 0)[0], 2.0, 1e-6);
  }
}

// Transmittance and single scattering by ten thousand midpoints, written for this test alone.
struct ByHand {
  static double rayleigh(double nu) { return 3.0 / (16.0 * std::numbers::pi) * (1.0 + nu * nu); }
  static double haze(double nu) { return (1.0 - 0.64) / (4.0 * std::numbers::pi * std::pow(1.64 - 1.6 * nu, 1.5)); }
  static double extinction(double h) {
    const double ozone = std::max(0.0, 1.0 - std::abs(h - 25.0) / 15.0);
    return 13.558e-3 * std::exp(-h / 8.0) + 4.44e-3 * std::exp(-h / 1.2) + 1.881e-3 * ozone;
  }
  // Optical depth from radius r along mu over length t.
  static double depth(double r, double mu, double t) {
    double sum = 0.0;
    constexpr int kSteps = 2000;
    for (int k = 0; k < kSteps; ++k) {
      const double x = t * (k + 0.5) / kSteps;
      sum += extinction(std::sqrt(r * r + x * x + 2.0 * r * mu * x) - 6360.0) * t / kSteps;
    }
    return sum;
  }
  static double to_top(double r, double mu) { return -r * mu + std::sqrt(r * r * mu * mu - r * r + 6460.0 * 6460.0); }
  // Single scattering along a ray up from the ground.
  static double single(double elevation, double azimuth, double sun) {
    const double r = 6360.001;
    const double mu = std::sin(elevation);
    const double nu = mu * std::sin(sun) + std::cos(elevation) * std::cos(sun) * std::cos(azimuth);
    const double length = to_top(r, mu);
    double sum = 0.0;
    double before = 0.0;
    constexpr int kSteps = 2000;
    for (int k = 0; k < kSteps; ++k) {
      // Steps grow along the ray, as the air thins.
      const auto at = [&](double j) { return length * (j / kSteps) * (j / kSteps); };
      const double t = at(k + 0.5);
      const double width = at(k + 1) - at(k);
      const double there = std::sqrt(r * r + t * t + 2.0 * r * mu * t);
      const double h = there - 6360.0;
      const double mu_sun = (r * std::sin(sun) + t * nu) / there;
      const bool dark = mu_sun < 0.0 && there * std::sqrt(1.0 - mu_sun * mu_sun) < 6360.0;
      const double here = extinction(h) * width;
      if (!dark) {
        const double scattering =
            13.558e-3 * std::exp(-h / 8.0) * rayleigh(nu) + 3.996e-3 * std::exp(-h / 1.2) * haze(nu);
        sum += scattering * width * std::exp(-before - 0.5 * here - depth(there, mu_sun, to_top(there, mu_sun)));
      }
      before += here;
    }
    return sum;
  }
};

TEST(PathTrace, FirstOrderMeetsQuadrature) {
  for (const double sun : {60.0, 5.0, -2.0}) {
    Scene scene = earth(sun, 0.001);
    set(scene, "max_orders", 1);
    std::vector<Direction> directions;
    for (const double elevation : {1.0, 30.0, 80.0}) {
      directions.push_back({radians(elevation), radians(20)});
    }
    const HostPicture picture = trace(scene, directions);
    for (std::size_t k = 0; k < directions.size(); ++k) {
      const double expected = ByHand::single(directions[k].elevation, directions[k].azimuth, radians(sun));
      // 2000 steps across the shadow's edge are good to 1e-3.
      EXPECT_NEAR(radiance(picture, k)[1], expected, (sun < 0.0 ? 3e-3 : 3e-5) * expected) << sun << " " << k;
      EXPECT_EQ(standard_error(picture, k)[1], 0.0f);
      const double r = 6360.001;
      const double mu = std::sin(directions[k].elevation);
      const double transmittance = std::exp(-ByHand::depth(r, mu, ByHand::to_top(r, mu)));
      EXPECT_NEAR(picture.transmittance.at(static_cast<int>(k), 0)[1], transmittance, 1e-4 * transmittance);
    }
  }
}

// Light that the ground sends straight up through the air: albedo / pi x mu x both transmittances.
TEST(PathTrace, FirstOrderHoldsTheSunlitGround) {
  Scene scene = slab(0.5, 0.0, PhaseFunction::isotropic, 0.0);
  scene.planet.ground_albedo = {0.2, 0.5, 1.0};
  scene.sun.elevation = radians(30);
  scene.camera.altitude = 500.0;
  const HostPicture picture = trace(scene, {{radians(-90), 0.0}});
  const double expected = 0.5 / std::numbers::pi * std::exp(-0.5 - 0.5 / 0.5);
  EXPECT_NEAR(radiance(picture, 0)[1], 0.5 * expected, 1e-4 * expected);
  EXPECT_NEAR(radiance(picture, 0)[2], expected, 1e-4 * expected);
  EXPECT_NEAR(radiance(picture, 0)[0], 0.2 * expected, 1e-4 * expected);
}

// A small planet with air that absorbs nothing over white ground: all sunlight that meets it leaves again, scattered or
// past the limb. Gauss over the sun's height, equal areas over the sky below a camera at the top.
TEST(PathTrace, WhatEntersLeaves) {
  constexpr double kRadius = 60.0;
  constexpr double kTop = 100.0;
  Scene scene = earth(0, kTop, 1.0);
  scene.planet.ground_radius = kRadius;
  scene.media.resize(2);
  scene.media[0].scattering = {0.01, 0.05, 0.2};
  scene.media[1].scattering = {0.1, 0.02, 0.0};
  scene.media[1].absorption = {0, 0, 0};
  set(scene, "samples", 32);
  const GaussRule suns = gauss_legendre(24);
  std::array<double, 3> leaves{};
  std::array<double, 3> variance{};
  for (std::size_t s = 0; s < suns.nodes.size(); ++s) {
    scene.sun.elevation = std::asin(2.0 * suns.nodes[s] - 1.0);
    set(scene, "seed", static_cast<int>(s));
    std::vector<Direction> directions;
    constexpr int kRows = 16;
    constexpr int kColumns = 8;
    for (int row = 0; row < kRows; ++row) {
      for (int column = 0; column < kColumns; ++column) {
        // Cosine-weighted: the square of the cosine is uniform.
        const double mu = std::sqrt((row + 0.5) / kRows);
        directions.push_back({-std::asin(mu), std::numbers::pi * (column + 0.5) / kColumns});
      }
    }
    const HostPicture picture = trace(scene, directions);
    for (std::size_t k = 0; k < directions.size(); ++k) {
      const double weight = suns.weights[s] / static_cast<double>(directions.size());
      for (std::size_t c = 0; c < 3; ++c) {
        leaves[c] += weight * radiance(picture, k)[c];
        variance[c] += std::pow(weight * standard_error(picture, k)[c], 2);
      }
    }
  }
  for (std::size_t c = 0; c < 3; ++c) {
    // Light straight past the limb, as a share of what the disc of the atmosphere receives.
    double past = 0.0;
    constexpr int kSteps = 4000;
    for (int k = 0; k < kSteps; ++k) {
      const double b = kRadius + (k + 0.5) * kTop / kSteps;
      const double half = std::sqrt(std::pow(kRadius + kTop, 2) - b * b);
      double depth = 0.0;
      for (int j = 0; j < 400; ++j) {
        const double h = std::hypot(b, half * (j + 0.5) / 400) - kRadius;
        depth +=
            2.0 * half / 400 *
            (scene.media[0].scattering[c] * std::exp(-h / 8.0) + scene.media[1].scattering[c] * std::exp(-h / 1.2));
      }
      past += 2.0 * b * kTop / kSteps * std::exp(-depth) / std::pow(kRadius + kTop, 2);
    }
    // Mean radiance over positions and directions is a quarter of the irradiance over pi.
    EXPECT_LT(std::sqrt(variance[c]) * 4.0 * std::numbers::pi, 0.003);
    EXPECT_NEAR(4.0 * std::numbers::pi * leaves[c] + past, 1.0, 0.012) << "channel " << c << " past " << past;
  }
}

// Sun and eye may change places: radiance over the cosine of the sun stays the same. Layered haze over coloured ground
// on a flat planet.
TEST(PathTrace, SunAndEyeMayChangePlaces) {
  Scene scene = earth(0, 100.0, 0.3);
  scene.planet.ground_radius = 1e6;
  set(scene, "samples", 8192);
  const double high = radians(65);
  const double low = radians(20);
  scene.sun.elevation = low;
  const HostPicture a = trace(scene, {{-high, radians(30)}});
  scene.sun.elevation = high;
  set(scene, "seed", 2);
  const HostPicture b = trace(scene, {{-low, radians(30)}});
  for (std::size_t c = 0; c < 3; ++c) {
    const double x = radiance(a, 0)[c] / std::sin(low);
    const double y = radiance(b, 0)[c] / std::sin(high);
    const double error = std::hypot(standard_error(a, 0)[c] / std::sin(low), standard_error(b, 0)[c] / std::sin(high));
    EXPECT_LT(error, 0.005 * x);
    EXPECT_NEAR(x, y, 4.0 * error + 1e-4 * x) << c;
  }
}

// Three channels traced together give what each would give alone.
TEST(PathTrace, ChannelsDoNotDisturbEachOther) {
  Scene scene = earth(3, 0.0, 0.5);
  scene.media[0].scattering = {1e-4, 0.02, 0.5};
  scene.media[1].absorption = {0.05, 0.0, 0.0};
  scene.planet.ground_albedo = {0.9, 0.0, 0.4};
  set(scene, "samples", 8192);
  const std::vector<Direction> directions{{radians(2), 0.3}, {radians(60), 2.0}};
  const HostPicture together = trace(scene, directions);
  for (std::size_t c = 0; c < 3; ++c) {
    Scene alone = scene;
    for (Medium& m : alone.media) {
      m.scattering = {m.scattering[c], m.scattering[c], m.scattering[c]};
      m.absorption = {m.absorption[c], m.absorption[c], m.absorption[c]};
    }
    alone.planet.ground_albedo = {scene.planet.ground_albedo[c], scene.planet.ground_albedo[c],
                                  scene.planet.ground_albedo[c]};
    set(alone, "seed", 5);
    const HostPicture picture = trace(alone, directions);
    for (std::size_t k = 0; k < directions.size(); ++k) {
      const double error = std::hypot(standard_error(picture, k)[c], standard_error(together, k)[c]);
      EXPECT_LT(error, 0.15 * radiance(picture, k)[c]);
      EXPECT_NEAR(radiance(together, k)[c], radiance(picture, k)[c], 4.0 * error) << "channel " << c << " view " << k;
    }
  }
}

// A peaked medium that scatters nothing, everywhere or at the path's place, must not end paths: its share of the light
// is 0 of 0.
TEST(PathTrace, AbsentMediaChangeNothing) {
  Scene clear = earth(20, 2.0, 0.8);
  clear.media.resize(1);
  set(clear, "samples", 1024);
  const std::vector<Direction> directions{{radians(40), 2.0}, {radians(-20), 1.0}};
  const HostPicture expected = trace(clear, directions);
  Scene vanishing = clear;
  vanishing.media.push_back(medium(PhaseFunction::henyey_greenstein, 0.8, {0, 0, 0}, {0, 0, 0}, exponential(1.2)));
  Scene below = clear;
  below.media.push_back(medium(PhaseFunction::henyey_greenstein, 0.8, {1e-9, 1e-9, 1e-9}, {0, 0, 0}, constant(0.001)));
  for (const Scene& scene : {vanishing, below}) {
    const HostPicture found = trace(scene, directions);
    for (std::size_t k = 0; k < directions.size(); ++k) {
      for (std::size_t c = 0; c < 3; ++c) {
        const double error = std::hypot(standard_error(found, k)[c], standard_error(expected, k)[c]);
        EXPECT_LT(error, 0.02 * radiance(expected, k)[c]);
        EXPECT_NEAR(radiance(found, k)[c], radiance(expected, k)[c], 4.0 * error) << "view " << k << " channel " << c;
      }
    }
  }
}

// Lengths times k and coefficients over k change nothing.
TEST(PathTrace, ScalesWithItsUnits) {
  Scene scene = earth(10, 1.0, 0.3);
  set(scene, "samples", 64);
  const std::vector<Direction> directions{{radians(20), 0.3}, {radians(-10), 2.0}};
  const HostPicture small = trace(scene, directions);
  constexpr double k = 8.0;
  scene.planet.ground_radius *= k;
  scene.planet.atmosphere_height *= k;
  scene.camera.altitude *= k;
  for (Medium& m : scene.media) {
    m.density.scale_height *= k;
    m.density.center *= k;
    m.density.half_width *= k;
    for (std::size_t c = 0; c < 3; ++c) {
      m.scattering[c] /= k;
      m.absorption[c] /= k;
    }
  }
  const HostPicture large = trace(scene, directions);
  for (std::size_t i = 0; i < directions.size(); ++i) {
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_NEAR(radiance(large, i)[c], radiance(small, i)[c], 1e-5 * radiance(small, i)[c]);
    }
  }
}

// Every corner case that has broken sky code elsewhere: finite, never negative, and light where there is light.
TEST(PathTrace, StaysFiniteAtEveryCorner) {
  const double top = 100.0;
  std::vector<Direction> directions;
  for (const double elevation : {90.0, 30.0, 1e-9, 0.0, -1e-9, -3.0, -20.0, -90.0}) {
    directions.push_back({radians(elevation), radians(10)});
  }
  directions.push_back({radians(20), 0.0});  // into the sun
  const auto check = [&](const Scene& base, const std::string& name) {
    for (const double sun : {90.0, 20.0, 0.0, -8.0, -90.0}) {
      Scene scene = base;
      scene.sun.elevation = radians(sun);
      set(scene, "samples", 32);
      const HostPicture picture = trace(scene, directions);
      double sum = 0.0;
      for (std::size_t k = 0; k < directions.size(); ++k) {
        for (std::size_t c = 0; c < 3; ++c) {
          const double x = radiance(picture, k)[c];
          const double transmittance = picture.transmittance.at(static_cast<int>(k), 0)[c];
          ASSERT_TRUE(std::isfinite(x) && x >= 0.0) << name << " sun " << sun << " view " << k << ": " << x;
          ASSERT_TRUE(std::isfinite(standard_error(picture, k)[c])) << name << " sun " << sun << " view " << k;
          ASSERT_TRUE(transmittance >= 0.0 && transmittance <= 1.0);
          sum += x;
        }
      }
      const bool vacuum = name == "vacuum";
      EXPECT_TRUE(vacuum || sun < 0.0 || sum > 0.0) << name << " sun " << sun;
      EXPECT_TRUE(!vacuum || sum == 0.0);
    }
  };
  for (const double h : {0.0, 1e-4, std::nextafter(top, 0.0), top, std::nextafter(top, 200.0), 500.0}) {
    check(earth(0, h, 0.3), "altitude " + std::to_string(h));
  }
  Scene vacuum = earth(0, 1.0);
  for (Medium& m : vacuum.media) {
    m.scattering = m.absorption = {0, 0, 0};
  }
  check(vacuum, "vacuum");
  Scene thick = earth(0, 1.0, 0.5);
  thick.media.resize(1);
  thick.media[0].scattering = {125, 12.5, 0.1};
  thick.media[0].absorption = {1, 1, 1};
  check(thick, "optical depth 1000");
  for (const double g : {0.99, -0.99}) {
    for (const PhaseFunction phase :
         {PhaseFunction::henyey_greenstein, PhaseFunction::cornette_shanks, PhaseFunction::schlick}) {
      Scene peaked = earth(0, 0.0);
      peaked.media[1].phase = phase;
      peaked.media[1].phase_g = g;
      check(peaked, "g " + std::to_string(g));
    }
  }
  for (const double radius : {1.0, 1e6}) {
    Scene scene = earth(0, 2.0, 1.0);
    scene.planet.ground_radius = radius;
    check(scene, "radius " + std::to_string(radius));
  }
}

}  // namespace
}  // namespace airlight
