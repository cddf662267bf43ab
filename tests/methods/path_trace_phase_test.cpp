// The path tracer's draws of directions.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/methods/path_trace/phase_sampling.h"
#include "core/methods/path_trace/random.h"
#include "path_trace_scene.h"
#include "tests/of_scene.h"

namespace airlight {
namespace {

using physics::vec3;

struct PhaseCase {
  PhaseFunction phase;
  double g;
};

class PathTracePhase : public testing::TestWithParam<PhaseCase> {};

// Chi-square of drawn cosines over bins that crowd into the peak; their expected shares are phase_value by quadrature.
TEST_P(PathTracePhase, SamplesFollowPhaseValue) {
  const PhaseFunction phase = GetParam().phase;
  const double g = GetParam().g;
  Scene scene = earth(20, 0);
  scene.media = {medium(phase, g, {1, 1, 1}, {0, 0, 0}, exponential(8))};
  physics::Physics physics = make_physics(scene);
  const PhaseSampler sampler(physics);
  constexpr int kBins = 50;
  constexpr int kSamples = 200000;
  const double sign = g < 0.0 ? -1.0 : 1.0;
  // Bin k covers sign * nu = 1 - 2 (k / kBins)^4 downward.
  const auto edge = [](int k) { return 1.0 - 2.0 * std::pow(static_cast<double>(k) / kBins, 4); };
  const auto bin_of = [&](double nu) {
    return std::min(static_cast<int>(kBins * std::pow(std::max(0.5 * (1.0 - sign * nu), 0.0), 0.25)), kBins - 1);
  };
  std::vector<int> counts(kBins);
  double mean = 0.0;
  Random random(11, 0, 0);
  for (int k = 0; k < kSamples; ++k) {
    const double nu = sampler.sample(0, random.uniform(), random);
    ASSERT_TRUE(nu >= -1.0 && nu <= 1.0);
    ++counts[static_cast<std::size_t>(bin_of(nu))];
    mean += nu / kSamples;
  }
  const auto density = [&](double nu) {
    return 2.0 * std::numbers::pi * physics.phase_value(physics.phase_of(0), g, sign * nu);
  };
  double chi = 0.0;
  double all = 0.0;
  double first = 0.0;
  int used = 0;
  for (int k = 0; k < kBins; ++k) {
    const double share = integrate(density, edge(k + 1), edge(k));
    first += sign * integrate([&](double nu) { return nu * density(nu); }, edge(k + 1), edge(k));
    all += share;
    const double expected = kSamples * share;
    if (expected > 8.0) {
      const double off = counts[static_cast<std::size_t>(k)] - expected;
      chi += off * off / expected;
      ++used;
    }
  }
  EXPECT_NEAR(all, 1.0, 1e-6);
  EXPECT_NEAR(mean, first, 5.0 / std::sqrt(3.0 * kSamples));
  // Mean `used`, deviation sqrt(2 used): five deviations.
  EXPECT_LT(chi, used + 5.0 * std::sqrt(2.0 * used));
}

INSTANTIATE_TEST_SUITE_P(
    Functions, PathTracePhase,
    testing::Values(PhaseCase{PhaseFunction::isotropic, 0}, PhaseCase{PhaseFunction::rayleigh, 0},
                    PhaseCase{PhaseFunction::henyey_greenstein, 0.99}, PhaseCase{PhaseFunction::henyey_greenstein, 0.8},
                    PhaseCase{PhaseFunction::henyey_greenstein, 1e-9},
                    PhaseCase{PhaseFunction::henyey_greenstein, -0.5},
                    PhaseCase{PhaseFunction::henyey_greenstein, -0.99}, PhaseCase{PhaseFunction::cornette_shanks, 0.99},
                    PhaseCase{PhaseFunction::cornette_shanks, 0.76}, PhaseCase{PhaseFunction::cornette_shanks, -0.6},
                    PhaseCase{PhaseFunction::schlick, 0.8}, PhaseCase{PhaseFunction::schlick, 0.99},
                    PhaseCase{PhaseFunction::schlick, -0.95}));

// Tables and depolarised molecules, whose channels differ: the density is that of the draws, its integral is 1, and no
// channel's phase function exceeds it so far that weights explode.
TEST(PathTracePhase, SamplesFollowTheDensityTold) {
  Scene scene = earth(20, 0);
  PhaseTable table;
  table.wavelengths_nm = {400.0, 500.0, 600.0};
  for (const double g : {0.6, 0.75, 0.85}) {
    table.rows.emplace_back();
    table.angles_deg.clear();
    for (int k = 0; k <= 200; ++k) {
      table.angles_deg.push_back(180.0 * k * k / 40000.0);
      const double nu = std::cos(table.angles_deg.back() * std::numbers::pi / 180.0);
      table.rows.back().push_back(physics::Physics().phase_henyey_greenstein(g, nu));
    }
  }
  scene.media[0].depolarization = {0.1, 0.2, 0.3};
  scene.media[1].phase = PhaseFunction::table;
  scene.media[1].phase_table = table;
  scene.media[1].phase_wavelengths = {600.0, 500.0, 400.0};
  physics::Physics physics = make_physics(scene);
  const PhaseSampler sampler(physics);
  EXPECT_TRUE(sampler.is_peaked(1));
  EXPECT_FALSE(sampler.is_peaked(0));
  constexpr int kBins = 60;
  constexpr int kSamples = 200000;
  for (physics::uint medium = 0; medium < 2; ++medium) {
    const auto density = [&](double nu) {
      return 2.0 * std::numbers::pi * sampler.density(medium, nu, physics.medium_phase(medium, nu));
    };
    // Bin k covers nu = 1 - 2 (k / kBins)^4 downward.
    const auto edge = [](int k) { return 1.0 - 2.0 * std::pow(static_cast<double>(k) / kBins, 4); };
    std::vector<int> counts(kBins);
    Random random(12, 0, 0);
    for (int k = 0; k < kSamples; ++k) {
      const double nu = sampler.sample(medium, random.uniform(), random);
      ASSERT_TRUE(nu >= -1.0 && nu <= 1.0);
      ++counts[static_cast<std::size_t>(
          std::min(static_cast<int>(kBins * std::pow(0.5 * (1.0 - nu), 0.25)), kBins - 1))];
    }
    double chi = 0.0;
    double all = 0.0;
    int used = 0;
    for (int k = 0; k < kBins; ++k) {
      double share = 0.0;
      constexpr int kParts = 64;
      for (int i = 0; i < kParts; ++i) {
        const double low = edge(k + 1) + (edge(k) - edge(k + 1)) * i / kParts;
        const double high = edge(k + 1) + (edge(k) - edge(k + 1)) * (i + 1) / kParts;
        share += density(0.5 * (low + high)) * (high - low);
      }
      all += share;
      const double expected = kSamples * share;
      if (expected > 8.0) {
        const double off = counts[static_cast<std::size_t>(k)] - expected;
        chi += off * off / expected;
        ++used;
      }
    }
    EXPECT_NEAR(all, 1.0, 2e-3) << medium;
    EXPECT_LT(chi, used + 6.0 * std::sqrt(2.0 * used)) << medium;
    for (double nu = -1.0; nu <= 1.0; nu += 0.01) {
      const vec3 phase = physics.medium_phase(medium, nu);
      const double mean = (phase.x + phase.y + phase.z) / 3.0;
      EXPECT_NEAR(sampler.density(medium, nu, phase) / mean, 1.0, 0.05) << medium << ", nu " << nu;
    }
  }
}

// A sharp phase function has samples among the tables' for those who gather light, but no table to draw from.
TEST(PathTracePhase, ATableBehindASharpPhaseFunctionIsItsOwn) {
  Scene scene = earth(20, 0);
  const auto flat = [](double forward, double back) {
    PhaseTable table{.angles_deg = {0.0, 90.0, 90.001, 180.0}, .wavelengths_nm = {}, .rows = {}};
    table.rows = {{forward, forward, back, back}};
    return table;
  };
  const Medium sharp = medium(PhaseFunction::henyey_greenstein, 0.99, {1, 1, 1}, {0, 0, 0}, exponential(8));
  Medium onward = medium(PhaseFunction::table, 0.0, {1, 1, 1}, {0, 0, 0}, exponential(8));
  Medium back = onward;
  onward.phase_table = flat(1.0, 1e-6);
  back.phase_table = flat(1e-6, 1.0);
  scene.media = {sharp, onward, back};
  physics::Physics physics = make_physics(scene);
  const PhaseSampler sampler(physics);
  Random random(13, 0, 0);
  for (int k = 1; k < 10; ++k) {
    EXPECT_GT(sampler.sample(1, k / 10.0, random), -1e-3);
    EXPECT_LT(sampler.sample(2, k / 10.0, random), 1e-3);
  }
  EXPECT_GT(sampler.density(1, 0.5, physics.medium_phase(1, 0.5)), 0.1);
  EXPECT_GT(sampler.density(2, -0.5, physics.medium_phase(2, -0.5)), 0.1);
}

TEST(PathTracePhase, AroundKeepsTheAngleAndGoesAllTheWay) {
  for (const vec3 axis : {vec3(0, 0, 1), vec3(0, 0, -1), vec3(1, 0, 0), normalize(vec3(1, -2, 3))}) {
    vec3 mean(0.0);
    for (int k = 0; k < 8; ++k) {
      const vec3 v = around(axis, 0.3, k / 8.0);
      EXPECT_NEAR(length(v), 1.0, 1e-14);
      EXPECT_NEAR(dot(v, axis), 0.3, 1e-14);
      mean = mean + v / 8.0;
    }
    EXPECT_NEAR(length(mean - axis * 0.3), 0.0, 1e-14);
  }
}

}  // namespace
}  // namespace airlight
