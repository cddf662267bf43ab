// The path tracer's parts, each against an independent truth.

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "core/methods/path_trace/optical_depth.h"
#include "core/methods/path_trace/phase_sampling.h"
#include "core/methods/path_trace/random.h"
#include "core/methods/path_trace/sky_guide.h"
#include "path_trace_scene.h"
#include "tests/of_scene.h"

namespace airlight {
namespace {

using physics::vec3;
using Ray = physics::Physics::Ray;

TEST(PathTraceGauss, IsExactForPolynomials) {
  for (int n = 1; n <= 12; ++n) {
    const GaussRule plain = gauss_legendre(n);
    for (int power = 0; power < 2 * n; ++power) {
      double sum = 0.0;
      for (std::size_t k = 0; k < plain.nodes.size(); ++k) {
        sum += plain.weights[k] * std::pow(plain.nodes[k], power);
      }
      EXPECT_NEAR(sum, 1.0 / (power + 1), 1e-14) << n << " nodes, power " << power;
    }
  }
}

TEST(PathTraceGauss, FallingRuleIntegratesEighteenScaleHeights) {
  const GaussRule rule = gauss_falling(12);
  double sum = 0.0;
  for (std::size_t k = 0; k < rule.nodes.size(); ++k) {
    sum += rule.weights[k] * 18.0 * std::exp(-18.0 * rule.nodes[k]);
  }
  EXPECT_NEAR(sum, 1.0 - std::exp(-18.0), 1e-8);
}

// Place where a function that rises from `from` to `to` reaches a value; an end where it does not.
double where(double value, double from, double to, const std::function<double(double)>& f) {
  for (int k = 0; k < 60; ++k) {
    const double middle = 0.5 * (from + to);
    (f(middle) < value ? from : to) = middle;
  }
  return 0.5 * (from + to);
}

class PathTraceOpticalDepth : public testing::TestWithParam<DensityProfile> {};

// Random profiles, planets from a pebble to a plane, rays up, down and level, whole and in part.
TEST_P(PathTraceOpticalDepth, MeetsAdaptiveQuadrature) {
  std::mt19937_64 engine(7);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  const auto random = [&] { return uniform(engine); };
  for (int trial = 0; trial < 120; ++trial) {
    Scene scene = earth(20, 0);
    scene.planet.ground_radius = std::array{1.0, 60.0, 6360.0, 1e6}[static_cast<std::size_t>(trial % 4)];
    Density density;
    density.profile = GetParam();
    density.scale_height = std::exp(-1.0 + 5.0 * random());
    density.center = 100.0 * random();
    density.half_width = 1.0 + 40.0 * random();
    density.below = 100.0 * random();
    for (int k = 0; k < 5; ++k) {
      density.layers.push_back({25.0 * (k + 0.8 * random()), random()});
    }
    scene.media = {medium(PhaseFunction::isotropic, 0, {1, 2, 3}, {0.5, 0, 0}, density)};
    physics::Physics physics = make_physics(scene);
    const OpticalDepth depth(physics);
    const double h = random() < 0.3 ? 0.0 : 100.0 * random() * random();
    double mu = random() < 0.4 ? 0.2 * (random() - 0.5) : 2.0 * random() - 1.0;
    if (physics.meets_ground(physics.scene.planet, h, mu)) {
      mu = -mu;
    }
    const double distance = physics.distance_to_top(physics.scene.planet, h, mu) * (trial % 3 == 0 ? random() : 1.0);
    const Ray ray{h, mu, 0.0, 0.0, distance, false, 0.0, false};
    const auto at = [&](double t) {
      return physics.density(physics.density_profile(0), physics.medium(0),
                             physics.point_on_ray(physics.scene.planet, ray, t).h);
    };
    // From corner to corner of the profile, down to the lowest point and up again.
    const double lowest = std::clamp(-(scene.planet.ground_radius + h) * mu, 0.0, distance);
    std::vector<double> ends{0.0, lowest, distance};
    for (const double altitude : Flight(physics, depth).corners()) {
      for (const auto& [from, to] : {std::pair{lowest, 0.0}, std::pair{lowest, distance}}) {
        ends.push_back(
            where(altitude, from, to, [&](double t) { return physics.point_on_ray(physics.scene.planet, ray, t).h; }));
      }
    }
    std::sort(ends.begin(), ends.end());
    double expected = 0.0;
    for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
      for (int part = 0; part < 4; ++part) {
        const double width = (ends[k + 1] - ends[k]) / 4;
        expected += integrate(at, ends[k] + part * width, ends[k] + (part + 1) * width);
      }
    }
    const vec3 got = depth.along(h, mu, distance);
    EXPECT_NEAR(got.y, 2.0 * expected, 2.0 * (1e-7 * expected + 1e-8)) << "trial " << trial;
    EXPECT_NEAR(got.x, 0.75 * got.y, 1e-12 * got.y);
    if (trial % 3 != 0) {
      EXPECT_NEAR(depth.to_top(h, mu).y, got.y, 1e-9 * got.y + 1e-12);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Profiles, PathTraceOpticalDepth,
                         testing::Values(DensityProfile::exponential, DensityProfile::tent, DensityProfile::lorentzian,
                                         DensityProfile::constant, DensityProfile::layers, DensityProfile::height_fog));

struct Parts {
  explicit Parts(const Scene& scene) : physics(make_physics(scene)), depth(physics), flight(physics, depth) {}
  physics::Physics physics;
  OpticalDepth depth;
  Flight flight;
};

// Whatever the plan, division by the choice's density must give any integral: here of scattering times transmittance,
// per channel, and of the light that the ground reflects.
TEST(PathTraceFlight, DividingByItsDensityGivesTheIntegral) {
  Scene scene = earth(30, 0, 0.4);
  Density cloud;
  cloud.profile = DensityProfile::layers;
  cloud.layers = {{1.0, 0.0}, {1.2, 1.0}, {2.0, 1.0}, {2.5, 0.0}};
  scene.media.push_back(medium(PhaseFunction::isotropic, 0, {0.3, 0.2, 0.1}, {0.0, 0.1, 0.2}, cloud));
  scene.media.push_back(medium(PhaseFunction::isotropic, 0, {0.02, 0.0, 0.0}, {0, 0, 0}, constant(6.0)));
  Parts parts(scene);
  struct Start {
    double h, mu;
    bool guided;
  };
  for (const Start s : {Start{0, 0.02, true},
                        {0.0, 1.0, false},
                        {1.1, -0.3, true},
                        {1.1, -0.3, false},
                        {30, -0.05, false},
                        {60, -0.12, true},
                        {99.9, 0.001, true}}) {
    const Ray ray = parts.physics.ray_in_atmosphere(parts.physics.scene.planet, s.h, s.mu, 0.5, 0.3);
    FlightPlan plan;
    if (s.guided) {
      parts.flight.plan_guided(ray, 1.0, plan);
    } else {
      parts.flight.plan_plain(ray, plan);
    }
    const auto scatters = [&](double t) {
      const double h = parts.physics.point_on_ray(parts.physics.scene.planet, ray, t).h;
      return parts.physics.air_at(h, parts.physics.phases(0.0)).scattering * exp(-parts.depth.along(s.h, s.mu, t));
    };
    double expected = 0.0;
    for (int k = 0; k < 64; ++k) {
      expected +=
          integrate([&](double t) { return scatters(t).y; }, ray.length_ * k / 64, ray.length_ * (k + 1) / 64, 12);
    }
    constexpr int kSamples = 20000;
    double sum = 0.0;
    double squares = 0.0;
    double ground = 0.0;
    for (int k = 0; k < kSamples; ++k) {
      const Collision c = Flight::choose(plan, {1.0, 0.7, 0.2}, (k + 0.5) / kSamples);
      ASSERT_TRUE(c.happens);
      ASSERT_TRUE(c.distance >= 0.0 && c.distance <= ray.length_);
      const double x = c.at_ground ? 0.0 : scatters(c.distance).y / c.density;
      sum += x / kSamples;
      squares += x * x / kSamples;
      ground += c.at_ground ? 1.0 / (c.density * kSamples) : 0.0;
    }
    const double deviation = std::sqrt((squares - sum * sum) / kSamples);
    EXPECT_NEAR(sum, expected, 4.0 * deviation + 1e-6) << "h " << s.h << " mu " << s.mu;
    EXPECT_NEAR(ground, ray.at_ground ? 1.0 : 0.0, 2e-2);
  }
}

TEST(PathTraceFlight, NothingHappensInAVacuumOverBlackGround) {
  Scene scene = earth(30, 0);
  scene.media = {medium(PhaseFunction::isotropic, 0, {0, 0, 0}, {0, 0, 0}, exponential(8))};
  Parts parts(scene);
  FlightPlan plan;
  parts.flight.plan_guided(parts.physics.ray_in_atmosphere(parts.physics.scene.planet, 1.0, -0.5, 0.5, 0.3), 1.0, plan);
  EXPECT_FALSE(Flight::choose(plan, {1, 1, 1}, 0.5).happens);
}

// The density integrates to 1 at every altitude, also far from the middle of a shell, and it is the density of the
// draws.
TEST(PathTraceSkyGuide, DrawsMeetTheDensity) {
  Parts parts(earth(2, 0, 0.3));
  const SkyGuide guide(parts.physics, parts.flight);
  Random random(3, 0, 0);
  constexpr std::size_t kBands = 12;
  for (const double h : {0.0, 0.001, 0.5, 20.0, 99.99}) {
    const vec3 up = normalize(vec3(0.05, 1.0, -0.1));
    const SkyFrame frame(parts.physics, h, up, false);
    const Channels weight{1.0, 0.5, 0.1};
    // Distance from the horizon in the same square that crowds the guide's bins.
    const auto stretched = [&](double mu) {
      return mu < frame.horizon ? -std::sqrt((frame.horizon - mu) / (1.0 + frame.horizon))
                                : std::sqrt((mu - frame.horizon) / (1.0 - frame.horizon));
    };
    const auto band = [&](vec3 v) {
      const double azimuth = dot(v, frame.toward_sun) > 0.0 ? 0.0 : 1.0;
      const double place = 0.5 * (stretched(dot(v, up)) + 1.0) * (kBands / 2);
      return 2 * static_cast<std::size_t>(std::clamp(place, 0.0, kBands / 2 - 1.0)) + static_cast<std::size_t>(azimuth);
    };
    std::array<double, kBands> drawn{};
    std::array<double, kBands> expected{};
    double all = 0.0;
    constexpr int kRows = 480;
    constexpr int kColumns = 48;
    for (int row = 0; row < kRows; ++row) {
      const double v = 2.0 * (row + 0.5) / kRows - 1.0;
      const double reach = v < 0.0 ? 1.0 + frame.horizon : 1.0 - frame.horizon;
      const double mu = frame.horizon + (v < 0.0 ? -1.0 : 1.0) * reach * v * v;
      const double height = 2.0 / kRows * 2.0 * std::abs(v) * reach;
      for (int column = 0; column < kColumns; ++column) {
        const vec3 direction = around(up, mu, (column + 0.5) / kColumns);
        const double share = guide.density(frame, weight, direction) * height * 2.0 * std::numbers::pi / kColumns;
        all += share;
        expected[band(direction)] += share;
      }
    }
    constexpr int kSamples = 200000;
    for (int k = 0; k < kSamples; ++k) {
      drawn[band(guide.draw_direction(frame, weight, random.uniform(), random.uniform()))] += 1.0 / kSamples;
    }
    EXPECT_NEAR(all, 1.0, 1e-4) << h;
    for (std::size_t k = 0; k < kBands; ++k) {
      const double deviation = std::sqrt(expected[k] * (1.0 - expected[k]) / kSamples);
      // Half a column of the grid may fall on the wrong side of the middle.
      EXPECT_NEAR(drawn[k], expected[k], 5.0 * deviation + 0.01 * expected[k] + 1e-5) << h << " band " << k;
    }
  }
}

}  // namespace
}  // namespace airlight
