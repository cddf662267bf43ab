// Phase functions: integral 1, first moment by closed form, sign of nu.

#include <gtest/gtest.h>

#include <cmath>

#include "tests/physics/integral.h"
#include "tests/physics/scenes.h"

namespace airlight::test {
namespace {

using physics::Physics;

Physics phase_formulas{};
constexpr double kAsymmetries[] = {-0.99, -0.95, -0.8, -0.5, -0.1, 0.0, 1e-6, 0.1, 0.5, 0.76, 0.8, 0.93, 0.95, 0.99};
constexpr unsigned int kKinds[] = {Physics::kPhaseRayleigh, Physics::kPhaseHenyeyGreenstein,
                                   Physics::kPhaseCornetteShanks, Physics::kPhaseSchlick, Physics::kPhaseIsotropic};

// Mean cosine of (1-k^2) / (4 pi (1-k nu)^2).
double schlick_moment(double k) {
  if (std::abs(k) < 1e-3) {
    return 2.0 / 3.0 * k;  // the closed form below is 0/0; the next term is of order k^3
  }
  return (1.0 - k * k) / (2.0 * k * k) * std::log((1.0 - k) / (1.0 + k)) + 1.0 / k;
}

double first_moment(unsigned int kind, double g) {
  switch (kind) {
    case Physics::kPhaseHenyeyGreenstein:
      return g;
    case Physics::kPhaseCornetteShanks:
      return 3.0 * g * (4.0 + g * g) / (5.0 * (2.0 + g * g));  // [C92]
    case Physics::kPhaseSchlick:
      return schlick_moment(phase_formulas.schlick_k(g));
    default:
      return 0.0;
  }
}

TEST(Phase, IntegratesToOne) {
  for (const unsigned int kind : kKinds) {
    for (const double g : kAsymmetries) {
      EXPECT_NEAR(sphere_integral([&](double nu) { return phase_formulas.phase_value(kind, g, nu); }), 1.0, 1e-9)
          << "kind " << kind << ", g " << g;
    }
  }
}

TEST(Phase, HasTheFirstMomentOfItsClosedForm) {
  for (const unsigned int kind : kKinds) {
    for (const double g : kAsymmetries) {
      EXPECT_NEAR(sphere_integral([&](double nu) { return nu * phase_formulas.phase_value(kind, g, nu); }),
                  first_moment(kind, g), 1e-9)
          << "kind " << kind << ", g " << g;
    }
  }
}

TEST(Phase, ScattersForwardForPositiveG) {
  for (const unsigned int kind :
       {Physics::kPhaseHenyeyGreenstein, Physics::kPhaseCornetteShanks, Physics::kPhaseSchlick}) {
    EXPECT_GT(phase_formulas.phase_value(kind, 0.8, 1.0), 10.0 * phase_formulas.phase_value(kind, 0.8, -1.0)) << kind;
    for (const double g : kAsymmetries) {
      for (const double nu : {-1.0, -0.999, -0.3, 0.0, 0.7, 0.99999, 1.0}) {
        const double value = phase_formulas.phase_value(kind, g, nu);
        EXPECT_GT(value, 0.0) << kind << ", g " << g << ", nu " << nu;
        EXPECT_NEAR(phase_formulas.phase_value(kind, -g, -nu) / value, 1.0, 1e-9)
            << kind << ", g " << g << ", nu " << nu;
      }
    }
  }
}

TEST(Phase, HasKnownValues) {
  EXPECT_NEAR(phase_formulas.phase_isotropic(), 0.07957747154594767, 1e-16);
  EXPECT_NEAR(phase_formulas.phase_rayleigh(0.0), 3.0 / (16.0 * std::numbers::pi), 1e-16);
  EXPECT_NEAR(phase_formulas.phase_rayleigh(1.0), 3.0 / (8.0 * std::numbers::pi), 1e-16);
  // (1+g) / (4 pi (1-g)^2) in the forward direction.
  EXPECT_NEAR(phase_formulas.phase_henyey_greenstein(0.99, 1.0), 1.99 / (4.0 * std::numbers::pi * 1e-4), 1e-6);
  EXPECT_NEAR(phase_formulas.phase_henyey_greenstein(0.0, 0.3), phase_formulas.phase_isotropic(), 1e-16);
  EXPECT_NEAR(phase_formulas.phase_cornette_shanks(0.0, 0.3), phase_formulas.phase_rayleigh(0.3), 1e-16);
  EXPECT_NEAR(phase_formulas.phase_schlick(0.0, 0.3), phase_formulas.phase_isotropic(), 1e-16);
}

// [C50], [Bu95]: the norm is 1 for any gamma; 0 is Rayleigh's function, 1 the isotropic one; backward and forward are
// equal; and about 1 - 3 rho / 4 of the second moment remains.
TEST(Phase, DepolarizedLiesBetweenRayleighAndIsotropic) {
  for (const double gamma : {0.0, 0.0147, 0.3, 1.0}) {
    const auto phase = [&](double nu) { return phase_formulas.phase_depolarized(physics::vec3(gamma), nu).y; };
    EXPECT_NEAR(sphere_integral(phase), 1.0, 1e-9) << gamma;
    EXPECT_NEAR(phase(0.3), phase(-0.3), 1e-16);
    EXPECT_NEAR(phase(0.0) / phase(1.0), (1.0 + 3.0 * gamma) / (2.0 + 2.0 * gamma), 1e-12) << gamma;
  }
  EXPECT_EQ(phase_formulas.phase_depolarized(physics::vec3(0.0), 0.4).x, phase_formulas.phase_rayleigh(0.4));
  EXPECT_NEAR(phase_formulas.phase_depolarized(physics::vec3(1.0), 0.4).x, phase_formulas.phase_isotropic(), 1e-16);
}

// A table of Henyey-Greenstein's values is that function, channel by channel: values, norm, and moments g^l.
TEST(Phase, ATableOfAFormulaIsTheFormula) {
  const std::vector<double> g{0.5, 0.7, 0.85};  // at 400, 500, 600 nm
  Scene scene = earth();
  take_table(scene.media[1], peaked_table(g));
  physics::Physics p = make_physics(scene);
  ASSERT_EQ(p.phase_of(1), Physics::kPhaseTable);
  for (std::size_t c = 0; c < 3; ++c) {
    const double asymmetry = g[2 - c];
    const auto phase = [&](double nu) { return channel(p.medium_phase(1, nu), c); };
    for (double nu = -1.0; nu <= 1.0; nu += 0.01) {
      EXPECT_NEAR(phase(nu) / p.phase_henyey_greenstein(asymmetry, nu), 1.0, 2e-4) << c << ", nu " << nu;
    }
    EXPECT_NEAR(sphere_integral(phase), 1.0, 1e-5) << c;
    for (int l = 0; l < 10; ++l) {
      EXPECT_NEAR(channel(p.medium(1).legendre[l], c), std::pow(asymmetry, l), 5e-5) << c << ", degree " << l;
    }
  }
}

// The moments for delta-scaling and the harmonics: P_2 of Rayleigh's function is 1/10, that of the mixture its share of
// this.
TEST(Phase, MomentsOfDepolarizedMolecules) {
  Scene scene = earth();
  scene.media[0].depolarization = {0.0, 0.0148, 1.0};
  const physics::Physics p = make_physics(scene);
  EXPECT_EQ(p.phase_of(0), Physics::kPhaseDepolarized);
  EXPECT_NEAR(p.medium(0).legendre[2].x, 0.1, 1e-6);
  EXPECT_NEAR(p.medium(0).legendre[2].y, 0.1 * (1.0 - 0.0148) / (1.0 + 2.0 * 0.0148), 1e-6);
  EXPECT_NEAR(p.medium(0).legendre[2].z, 0.0, 1e-9);
  EXPECT_NEAR(p.medium(0).legendre[1].y, 0.0, 1e-9);
  EXPECT_EQ(make_physics(earth()).phase_of(0), Physics::kPhaseRayleigh);
}

// An edge that no formula has stays in place: between the table's angles the values are within 1 % of exponentials.
TEST(Phase, ATableKeepsItsEdges) {
  PhaseTable table;
  table.angles_deg = {0.0, 1.0, 20.0, 137.0, 138.0, 180.0};
  table.rows = {{300.0, 30.0, 0.3, 0.02, 0.08, 0.05}};
  const double norm = sphere_integral(table, 0);
  for (double& value : table.rows[0]) {
    value /= norm;
  }
  EXPECT_NEAR(sphere_integral(table, 0), 1.0, 1e-12);
  EXPECT_NEAR(sphere_integral([&](double nu) { return phase_at(table, 550.0, std::acos(nu) / kDegree); }), 1.0, 5e-4);
  Scene scene = earth();
  take_table(scene.media[1], table);
  physics::Physics p = make_physics(scene);
  for (double angle = 0.05; angle < 180.0; angle += 0.173) {
    EXPECT_NEAR(p.medium_phase(1, std::cos(angle * kDegree)).y / phase_at(table, 550.0, angle), 1.0,
                std::abs(angle - 137.5) < 1.0 ? 0.12 : 0.01)
        << angle;
  }
}

TEST(Phase, SchlickStandsForHenyeyGreenstein) {
  double before = -2.0;
  for (double g = -0.99; g <= 0.9905; g += 0.01) {
    const double k = phase_formulas.schlick_k(g);
    EXPECT_LT(std::abs(k), 1.0) << g;
    EXPECT_GE(k, before) << g;
    before = k;
    // The fit's own error: mean cosines differ by at most 0.075, at g = 0.85.
    EXPECT_NEAR(schlick_moment(k), g, 0.0751) << g;
  }
}

// Henyey-Greenstein has the moments g^l. The share is their mean above degree N, the weights falling by r a degree,
// here summed term by term; it grows from nothing to the moment N + 1 itself as the peak gets sharp.
TEST(Phase, ForwardPeakIsTheMeanOfAllMomentsAboveTheDegreeKept) {
  for (const double g : {0.1, 0.5, 0.8, 0.95, 0.999}) {
    for (unsigned int n = 0; n <= physics::kMaxDegree; ++n) {
      const double r = 60.0 / (60.0 + (n + 1.0) * (n + 1.0));
      double sum = 0.0;
      double weights = 0.0;
      double weight = 1.0;
      for (unsigned int l = n + 1; l < n + 4000; ++l) {
        sum += weight * std::pow(g, l);
        weights += weight;
        weight *= r;
      }
      const double peak =
          phase_formulas.forward_peak(n, physics::vec3(std::pow(g, n)), physics::vec3(std::pow(g, n + 1))).x;
      EXPECT_NEAR(peak, sum / weights, 1e-9) << g << ", degree " << n;
      EXPECT_LT(peak, std::pow(g, n + 1));
    }
  }
  EXPECT_EQ(phase_formulas.forward_peak(2, physics::vec3(0.5), physics::vec3(-0.4)).x,
            0.0);  // a backward peak has none
  EXPECT_EQ(phase_formulas.forward_peak(2, physics::vec3(0.1), physics::vec3(0.0)).x,
            0.0);  // nor has Rayleigh's function
  const physics::Physics p = make_physics(earth());
  EXPECT_NEAR(p.medium(0).peak[2].x, 0.0, 1e-4);
  EXPECT_NEAR(p.medium(1).peak[2].x, 0.512 / (1.0 + 0.2 * 60.0 / 9.0), 1e-4);  // g 0.8
}

}  // namespace
}  // namespace airlight::test
