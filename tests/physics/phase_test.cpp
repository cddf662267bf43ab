// Phase functions: integral 1, first moment by closed form, sign of nu.

#include <gtest/gtest.h>

#include <cmath>

#include "tests/physics/integral.h"
#include "tests/physics/scenes.h"

namespace airlight::test {
namespace {

using physics::Physics;

Physics formulas{};
constexpr double kAsymmetries[] = {-0.99, -0.95, -0.8, -0.5, -0.1, 0.0, 1e-6, 0.1, 0.5, 0.76, 0.8, 0.93, 0.95, 0.99};
constexpr unsigned int kKinds[] = {physics::kPhaseRayleigh, physics::kPhaseHenyeyGreenstein,
                                   physics::kPhaseCornetteShanks, physics::kPhaseSchlick, physics::kPhaseIsotropic};

// Mean cosine of (1-k^2) / (4 pi (1-k nu)^2).
double schlick_moment(double k) {
  if (std::abs(k) < 1e-3) {
    return 2.0 / 3.0 * k;  // the closed form below is 0/0; the next term is of order k^3
  }
  return (1.0 - k * k) / (2.0 * k * k) * std::log((1.0 - k) / (1.0 + k)) + 1.0 / k;
}

double first_moment(unsigned int kind, double g) {
  switch (kind) {
    case physics::kPhaseHenyeyGreenstein:
      return g;
    case physics::kPhaseCornetteShanks:
      return 3.0 * g * (4.0 + g * g) / (5.0 * (2.0 + g * g));  // [C92]
    case physics::kPhaseSchlick:
      return schlick_moment(formulas.schlick_k(g));
    default:
      return 0.0;
  }
}

TEST(Phase, IntegratesToOne) {
  for (const unsigned int kind : kKinds) {
    for (const double g : kAsymmetries) {
      EXPECT_NEAR(sphere_integral([&](double nu) { return formulas.phase_value(kind, g, nu); }), 1.0, 1e-9)
          << "kind " << kind << ", g " << g;
    }
  }
}

TEST(Phase, HasTheFirstMomentOfItsClosedForm) {
  for (const unsigned int kind : kKinds) {
    for (const double g : kAsymmetries) {
      EXPECT_NEAR(sphere_integral([&](double nu) { return nu * formulas.phase_value(kind, g, nu); }),
                  first_moment(kind, g), 1e-9)
          << "kind " << kind << ", g " << g;
    }
  }
}

TEST(Phase, ScattersForwardForPositiveG) {
  for (const unsigned int kind :
       {physics::kPhaseHenyeyGreenstein, physics::kPhaseCornetteShanks, physics::kPhaseSchlick}) {
    EXPECT_GT(formulas.phase_value(kind, 0.8, 1.0), 10.0 * formulas.phase_value(kind, 0.8, -1.0)) << kind;
    for (const double g : kAsymmetries) {
      for (const double nu : {-1.0, -0.999, -0.3, 0.0, 0.7, 0.99999, 1.0}) {
        const double value = formulas.phase_value(kind, g, nu);
        EXPECT_GT(value, 0.0) << kind << ", g " << g << ", nu " << nu;
        EXPECT_NEAR(formulas.phase_value(kind, -g, -nu) / value, 1.0, 1e-9) << kind << ", g " << g << ", nu " << nu;
      }
    }
  }
}

TEST(Phase, HasKnownValues) {
  EXPECT_NEAR(formulas.phase_isotropic(), 0.07957747154594767, 1e-16);
  EXPECT_NEAR(formulas.phase_rayleigh(0.0), 3.0 / (16.0 * std::numbers::pi), 1e-16);
  EXPECT_NEAR(formulas.phase_rayleigh(1.0), 3.0 / (8.0 * std::numbers::pi), 1e-16);
  // (1+g) / (4 pi (1-g)^2) in the forward direction.
  EXPECT_NEAR(formulas.phase_henyey_greenstein(0.99, 1.0), 1.99 / (4.0 * std::numbers::pi * 1e-4), 1e-6);
  EXPECT_NEAR(formulas.phase_henyey_greenstein(0.0, 0.3), formulas.phase_isotropic(), 1e-16);
  EXPECT_NEAR(formulas.phase_cornette_shanks(0.0, 0.3), formulas.phase_rayleigh(0.3), 1e-16);
  EXPECT_NEAR(formulas.phase_schlick(0.0, 0.3), formulas.phase_isotropic(), 1e-16);
}

TEST(Phase, SchlickStandsForHenyeyGreenstein) {
  double before = -2.0;
  for (double g = -0.99; g <= 0.9905; g += 0.01) {
    const double k = formulas.schlick_k(g);
    EXPECT_LT(std::abs(k), 1.0) << g;
    EXPECT_GE(k, before) << g;
    before = k;
    // The fit's own error: mean cosines differ by at most 0.075, at g = 0.85.
    EXPECT_NEAR(schlick_moment(k), g, 0.0751) << g;
  }
}

}  // namespace
}  // namespace airlight::test
