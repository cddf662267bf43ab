// Mie's theory for drops against published values and another program's table.

#include "core/spectra/drops.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <numbers>

namespace airlight {
namespace {

// Bohren and Huffman 1983, appendix A: the sample of their program, a sphere of index 1.55 in air.
TEST(Mie, EfficiencyIsThatOfThePublishedSample) {
  EXPECT_NEAR(mie_efficiencies(5.21282, 1.55).scattering, 3.10543, 1e-5);
}

// Small spheres scatter as Rayleigh has it: Q = 8/3 x^4 ((m^2 - 1) / (m^2 + 2))^2; large ones take out twice what they
// cover.
TEST(Mie, HasItsLimits) {
  const double m = 1.33;
  const double x = 0.01;
  const double polarisability = (m * m - 1.0) / (m * m + 2.0);
  EXPECT_NEAR(mie_efficiencies(x, m).scattering / (8.0 / 3.0 * x * x * x * x * polarisability * polarisability), 1.0,
              1e-3);
  EXPECT_NEAR(mie_efficiencies(x, m).asymmetry, 0.0, 1e-3);
  EXPECT_NEAR(mie_efficiencies(2000.0, m).scattering, 2.0, 0.03);
}

// International values at 20 degrees C: 1.3330 for sodium's light, 1.3371 at 486 nm, 1.3312 at 656 nm.
TEST(Drops, AreOfWater) {
  EXPECT_NEAR(water_index(589.3), 1.3330, 1e-4);
  EXPECT_NEAR(water_index(486.1), 1.3371, 1e-4);
  EXPECT_NEAR(water_index(656.3), 1.3311, 1e-4);
}

double mean_cosine(const PhaseTable& table, double nm) {
  double sum = 0.0;
  double all = 0.0;
  constexpr int kSteps = 200000;
  for (int k = 0; k < kSteps; ++k) {
    const double angle = std::numbers::pi * (k + 0.5) / kSteps;
    const double weight = phase_at(table, nm, angle * 180.0 / std::numbers::pi) * std::sin(angle);
    sum += weight * std::cos(angle);
    all += weight;
  }
  return sum / all;
}

// Cloud C.1 at 700 nm: another program's table has 1712.9 straight on (of a function of mean 1), mean cosine 0.848.
TEST(Drops, OfCloudC1AreAsPublished) {
  const PhaseTable table = drops_table(6.0, {700.0});
  EXPECT_NEAR(sphere_integral(table, 0), 1.0, 1e-9);
  EXPECT_NEAR(phase_at(table, 700.0, 0.0) * 4.0 * std::numbers::pi, 1712.9, 5.0);
  EXPECT_NEAR(mean_cosine(table, 700.0), 0.848, 0.002);
}

// Angle by angle. In the fogbow and the glory the tables differ by the step of their radii.
TEST(Drops, OfCloudC1FollowAnotherTable) {
  std::ifstream file("../shared/clouds/drop-phase-c1.txt");
  if (!file) {
    file.open(AIRLIGHT_SOURCE_DIR "/../shared/clouds/drop-phase-c1.txt");
  }
  if (!file) {
    GTEST_SKIP() << "the table of cloud C.1 is not here";
  }
  const PhaseTable table = drops_table(6.0, {700.0});
  constexpr std::array<double, 6> kEnds{0.0, 5.0, 30.0, 90.0, 135.0, 180.1};
  constexpr std::array<double, 5> kBounds{0.004, 0.004, 0.012, 0.05, 0.025};
  std::array<double, 5> sums{};
  std::array<int, 5> counts{};
  double angle = 0.0;
  double value = 0.0;
  while (file >> angle >> value) {
    for (std::size_t k = 0; k < sums.size(); ++k) {
      if (angle >= kEnds[k] && angle < kEnds[k + 1]) {
        sums[k] += std::abs(phase_at(table, 700.0, angle) * 4.0 * std::numbers::pi / value - 1.0);
        ++counts[k];
      }
    }
  }
  for (std::size_t k = 0; k < sums.size(); ++k) {
    ASSERT_GT(counts[k], 10);
    EXPECT_LT(sums[k] / counts[k], kBounds[k]) << "from " << kEnds[k] << " degrees";
  }
}

}  // namespace
}  // namespace airlight
