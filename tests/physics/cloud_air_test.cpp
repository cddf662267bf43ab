// The light of the air on a cloud, on double.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "core/clouds/cloud_physics.h"

namespace airlight::test {
namespace {

using physics::uint;
using physics::vec3;

constexpr double kHazePeak = 0.76;  // mean cosine of the haze's phase function
constexpr uint kTableDegree = 5;

// A table that holds the same light everywhere: `around` the sun as haze of Henyey and Greenstein's function scatters
// it once, and `even` from all directions. Irradiances across the direction that they come from.
physics::CloudPhysics with_light(double around, double even, double mu_sun, uint degree) {
  physics::CloudPhysics p;
  p.degree = degree;
  p.moment_columns = 2;
  p.media = 1;
  p.scene.moments.top = 50.0;
  p.scene.moments.elevation_scale = 0.1;
  p.scene.moments.v_low = -2.0;
  p.scene.moments.v_high = 3.0;
  p.scene.media[0].scattering = vec3(0.05);
  p.scene.media[0].scale_height = 1.5;
  for (std::size_t l = 0; l < physics::kLegendreMoments; ++l) {
    p.scene.media[0].legendre[l] = vec3(std::pow(kHazePeak, static_cast<double>(l)));
  }
  const physics::CloudPhysics::Harmonics y = p.harmonics(mu_sun, 1.0);
  const uint blocks = p.moment_count() + 1;
  p.moments_lut = {static_cast<int>(2 * blocks), 2, std::vector<vec3>(4 * blocks)};
  const double isotropic = (around + even) * y.of[0];
  for (uint l = 0; l <= degree; ++l) {
    for (uint m = 0; m <= l; ++m) {
      const uint k = p.moment_place(l, m);
      const double moment = around * std::pow(kHazePeak, l) * y.of[k] + (l == 0 ? even * y.of[0] : 0.0);
      for (const std::size_t texel : {2 * k, 2 * k + 1, 2 * (blocks + k), 2 * (blocks + k) + 1}) {
        p.moments_lut.texels[texel] = p.moment_code(k, vec3(moment), vec3(isotropic));
      }
    }
  }
  return p;
}

vec3 around_sun(physics::CloudPhysics p, double mu_sun) {
  return p.light_around_sun(p.moment_coordinate(p.scene.moments, 1.0, mu_sun), 1.0, mu_sun);
}

// Of light turned once by haze the share chi_2 counts, whatever even light there is.
TEST(CloudAir, LightTurnedOnceComesFromAboutTheSunByChi2) {
  for (const double elevation : {5.0, 20.0, 60.0}) {
    const double mu_sun = std::sin(elevation * std::numbers::pi / 180.0);
    for (const double even : {0.0, 0.5}) {
      physics::CloudPhysics p = with_light(0.2, even, mu_sun, kTableDegree);
      EXPECT_NEAR(around_sun(p, mu_sun).x, 0.2 * kHazePeak * kHazePeak, 1e-9) << elevation << " " << even;
      EXPECT_NEAR(p.light_from_all_around(p.moment_coordinate(p.scene.moments, 1.0, mu_sun)).x, 0.2 + even, 1e-9);
    }
  }
}

TEST(CloudAir, EvenLightAndThinHazeHaveNone) {
  const double mu_sun = 0.3;
  EXPECT_NEAR(around_sun(with_light(0.0, 0.5, mu_sun, kTableDegree), mu_sun).x, 0.0, 1e-12);
  EXPECT_EQ(around_sun(with_light(0.2, 0.5, mu_sun, 2), mu_sun).x, 0.0);  // a table of degree 2
  physics::CloudPhysics molecules = with_light(0.2, 0.5, mu_sun, kTableDegree);
  molecules.scene.media[0].legendre[4] = vec3(0.0);
  EXPECT_EQ(around_sun(molecules, mu_sun).x, 0.0);
}

TEST(CloudAir, LightAroundTheSunIsNoMoreThanAll) {
  const double mu_sun = 0.3;
  physics::CloudPhysics p = with_light(0.2, 0.0, mu_sun, kTableDegree);
  p.scene.media[0].legendre[4] = vec3(0.05);  // broad: what the table holds is no light that this haze turned
  p.scene.media[0].legendre[2] = vec3(0.9);
  EXPECT_NEAR(around_sun(p, mu_sun).x, 0.2, 1e-9);
}

}  // namespace
}  // namespace airlight::test
