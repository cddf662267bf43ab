// Light scattered once by path-trace: its quadrature, the sun that it sees through air that bends light, and shadows.

#include "core/methods/path_trace/single_scattering.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

#include "core/methods/path_trace/adaptive_sum.h"
#include "core/methods/path_trace/flight.h"
#include "path_trace_scene.h"
#include "tests/of_scene.h"

namespace airlight {
namespace {

using physics::vec3;

// A function of one number as the sum takes it, and how often it was asked for.
template <class F>
struct Counted {
  F f;
  int* count;
  vec3 operator()(double t) const {
    ++*count;
    return vec3(f(t));
  }
};

template <class F>
double sum_of(const F& f, const std::vector<SmoothPart>& parts, int* count) {
  *count = 0;
  const Counted<F> counted{f, count};
  AdaptiveSum<vec3, Counted<F>> sum(counted);
  const double found = sum.over(parts).y;
  EXPECT_FALSE(sum.cut());
  return found;
}

// The rules of 3, 7 and 15 nodes are exact up to degree 5, 11 and 23; what two of them agree on is not halved.
TEST(AdaptiveSum, TakesAsManyNodesAsAPolynomialNeeds) {
  for (const auto& [degree, most] : {std::pair{5, 7}, {11, 15}, {23, 67}}) {
    int count = 0;
    const double found = sum_of([n = degree](double t) { return std::pow(t - 1.0, n); }, {{1.0, 3.0}}, &count);
    const double expected = std::pow(2.0, degree + 1) / (degree + 1);
    EXPECT_NEAR(found, expected, (count > 15 ? 1e-9 : 1e-13) * expected) << degree;
    EXPECT_LE(count, most) << degree;
  }
}

TEST(AdaptiveSum, HalvesUntilAPeakIsKnown) {
  int count = 0;
  const double narrow = sum_of([](double t) { return 1e-3 / (1e-6 + (t - 0.3) * (t - 0.3)); }, {{0.0, 1.0}}, &count);
  EXPECT_NEAR(narrow, std::atan(0.7e3) + std::atan(0.3e3), 1e-6 * narrow);
  EXPECT_GT(count, 100);
  const double parted = sum_of([](double t) { return t < 0.5 ? 1.0 : std::exp(-t); }, {{0.0, 0.5}, {0.5, 2.0}}, &count);
  EXPECT_NEAR(parted, 0.5 + std::exp(-0.5) - std::exp(-2.0), 1e-7);
}

// The seen sun's zenith angle is the true one less the bending of the ray that arrives so.
TEST(Sunbeam, IsBentByWhatItsOwnRayIs) {
  for (const double n_minus_1 : {2.9e-4, 6e-4}) {
    Scene scene = earth(20.0, 0.0);
    scene.planet.refraction.emplace().n_minus_1 = n_minus_1;
    scene.planet.refraction->density.scale_height = 8.0;
    physics::Physics p = make_physics(scene);
    const physics::PlanetData& planet = p.scene.planet;
    int up = 0;
    for (const double h : {0.0, 0.01, 1.0, 9.0, 40.0, 90.0}) {
      for (const double above_deg : {-1.0, -0.5, 0.0, 0.02, 0.3, 1.0, 5.0, 30.0, 89.0}) {
        const double true_zenith = std::acos(p.horizon_mu(planet, h)) - radians(above_deg);
        const Sunbeam beam = sunbeam(p, h, std::cos(true_zenith));
        if (!beam.up) {
          EXPECT_LT(above_deg, 0.0);
          continue;
        }
        ++up;
        constexpr physics::uint kFine = 512;
        const auto bending = [&](double zenith) { return p.bending_to_top(planet, h, std::cos(zenith), kFine); };
        const double seen = std::acos(beam.mu);
        const double bent = bending(seen);
        // At the horizon the tables of sunlight say when the sun is up, to 1e-5 rad.
        EXPECT_NEAR(seen + bent, true_zenith, above_deg < 0.0 ? 3e-5 : 1e-6) << h << " " << above_deg;
        constexpr double kApart = 1e-5;
        const double slope =
            (3.0 * bent - 4.0 * bending(seen - kApart) + bending(seen - 2.0 * kApart)) / (2.0 * kApart);
        const double spread = p.beam_spread(planet, h, beam.mu, bent, slope);
        EXPECT_NEAR(beam.spread, spread, 2e-2 * std::abs(spread - 1.0) + 3e-5) << h << " " << above_deg;
      }
    }
    EXPECT_GT(up, 40);
  }
}

// Places between others have the bendings that they would be found to have, to 2e-5 rad, and the sun up at the same
// ones; a third of them at least are told by others.
TEST(Sunbeam, OfPlacesAlongARayIsThatOfEach) {
  constexpr int kPlaces = 400;
  int told = 0;
  int all = 0;
  for (const auto& [sun_deg, height] : std::vector<std::pair<double, double>>{
           {-3.0, 8.0}, {-0.4, 8.0}, {0.2, 8.0}, {0.2, 2.5}, {7.0, 8.0}, {60.0, 8.0}}) {
    Scene scene = earth(sun_deg, 0.0);
    scene.planet.refraction.emplace().n_minus_1 = 2.9e-4;
    scene.planet.refraction->density.scale_height = height;
    physics::Physics p = make_physics(scene);
    const vec3 sun = p.scene.sun.direction;
    for (const double elevation_deg : {-5.0, -0.1, 0.1, 2.0, 45.0}) {
      for (const double azimuth_deg : {20.0, 160.0}) {
        const vec3 direction = p.direction_from_angles(radians(elevation_deg), radians(azimuth_deg));
        const auto ray =
            p.ray_in_atmosphere(p.scene.planet, scene.camera.altitude, direction.y, sun.y, dot(direction, sun));
        const LitRay lit(p, ray);
        LitPlaces places(lit, ray.length_, kPlaces, true);
        for (int i = 0; i < kPlaces; ++i) {
          const LitPoint expected = lit.unspread_at(places.distance(i));
          const LitPoint found = places.at(i);
          const auto what = [&] {
            return testing::Message() << sun_deg << " " << elevation_deg << " " << azimuth_deg << " " << i;
          };
          ASSERT_EQ(found.beam.up, expected.beam.up) << what();
          ASSERT_NEAR(found.bent, expected.bent, 2e-5) << what();
          ASSERT_NEAR(std::acos(found.beam.mu), std::acos(expected.beam.mu), 2e-5) << what();
          told += found.beam.up && found.bent != expected.bent ? 1 : 0;
          all += found.beam.up ? 1 : 0;
        }
      }
    }
  }
  EXPECT_GT(told, all / 3);
}

// A ball of 2 km before the sun takes its shadow out of every ray to within the edges' halving: against the sum of
// 20 000 short steps, whose own edges are a step wide.
TEST(SingleScattering, ShadowsAreCutOutAtTheirEdges) {
  for (const bool bends : {false, true}) {
    Scene scene = earth(30.0, 0.0, 0.3);
    if (bends) {
      scene.planet.refraction.emplace().n_minus_1 = 2.9e-4;
      scene.planet.refraction->density.scale_height = 8.0;
    }
    scene.media.resize(1);
    Sphere& ball = scene.spheres.emplace_back();
    ball.material = SphereMaterial::matte;
    ball.azimuth = 0.0;
    ball.elevation = radians(30.0);
    ball.distance = 12.0;
    ball.radius = 2.0;
    const Part part = part_of(scene);
    physics::Physics p = formulas_of(part.air, part.scene);
    const OpticalDepth depth(p);
    const Flight flight(p, depth);
    const TracedThings things(part);
    const SingleScattering with(p, depth, flight.corners(), &things);
    const SingleScattering without(p, depth, flight.corners());
    for (const double azimuth_deg : {15.0, 40.0, 90.0}) {
      const vec3 direction = p.direction_from_angles(radians(10.0), radians(azimuth_deg));
      const vec3 sun = p.scene.sun.direction;
      const double h = scene.camera.altitude;
      const auto ray = p.ray_in_atmosphere(p.scene.planet, h, direction.y, sun.y, dot(direction, sun));
      const Footing footing{vec3(0.0, 1.0, 0.0), direction};
      const BentWay way(p, true_place(p, footing.up, h), footing.up, direction, ray);
      const LitRay lit(p, ray);
      double expected = 0.0;
      double all = 0.0;
      constexpr int kSteps = 20000;
      for (int i = 0; i < kSteps; ++i) {
        const auto place = [&](double x) { return ray.length_ * x * x / (kSteps * kSteps); };
        const double t = place(i + 0.5);
        const LitPoint at = lit.at(t);
        const vec3 sunlight = exp(-depth.to_top(at.point.h, at.beam.mu)) * at.beam.spread;
        const double sent = (exp(-depth.along(h, direction.y, t)) * sunlight *
                             p.air_at(at.point.h, p.phases(bends ? at.nu : ray.nu)).phase_scattering)
                                .y *
                            (place(i + 1.0) - place(i));
        all += sent;
        expected += things.hides_sun(p, way.at(t).place, at.point.h, at.beam, kNoThing) ? 0.0 : sent;
      }
      const double found = with.radiance(ray, footing).y;
      const double plain = without.radiance(ray, footing).y;
      EXPECT_NEAR(plain, all, 1e-5 * all) << azimuth_deg;
      EXPECT_NEAR(plain - found, all - expected, 1e-3 * (all - expected) + 2e-5 * all) << azimuth_deg << " " << bends;
      if (azimuth_deg < 30.0) {
        EXPECT_GT(plain - found, 0.01 * plain) << "no shadow on this ray";
      }
    }
  }
}

}  // namespace
}  // namespace airlight
