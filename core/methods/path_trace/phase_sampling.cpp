#include "core/methods/path_trace/phase_sampling.h"

#include <cmath>
#include <numbers>

namespace airlight {

using physics::vec3;

namespace {

// Root of (4 + 3 nu + nu^3) / 8 = u by Cardano's formula.
double sample_rayleigh(double u) {
  const double a = 4.0 * u - 2.0;
  const double root = std::cbrt(std::abs(a) + std::sqrt(a * a + 1.0));
  const double nu = root - 1.0 / root;
  return a < 0.0 ? -nu : nu;
}

// [HG41], its usual inverse multiplied out so that nothing is divided by g.
double sample_henyey_greenstein(double g, double u) {
  const double a = 2.0 * u - 1.0;
  const double d = 1.0 + g * a;
  return (a + g * (0.5 * (a * a + 3.0) + g * (a + 0.5 * g * (a * a - 1.0)))) / (d * d);
}

// [C92] is Henyey-Greenstein times 1 + nu^2, up to a constant: accept that share.
double sample_cornette_shanks(double g, double u, Random& random) {
  while (true) {
    const double nu = sample_henyey_greenstein(g, u);
    if (2.0 * random.uniform() < 1.0 + nu * nu) {
      return nu;
    }
    u = random.uniform();
  }
}

// [S93], with its k.
double sample_schlick(double k, double u) {
  return (2.0 * u - 1.0 + k) / (1.0 - k + 2.0 * u * k);
}

}  // namespace

double sample_phase(physics::Physics& physics, physics::uint kind, double g, double u, Random& random) {
  double nu = 0.0;
  switch (kind) {
    case physics::kPhaseRayleigh:
      nu = sample_rayleigh(u);
      break;
    case physics::kPhaseHenyeyGreenstein:
      nu = sample_henyey_greenstein(g, u);
      break;
    case physics::kPhaseCornetteShanks:
      nu = sample_cornette_shanks(g, u, random);
      break;
    case physics::kPhaseSchlick:
      nu = sample_schlick(physics.schlick_k(g), u);
      break;
    default:
      nu = 2.0 * u - 1.0;
      break;
  }
  return std::clamp(nu, -1.0, 1.0);
}

vec3 around(vec3 axis, double nu, double turn) {
  const double sine = std::sqrt(std::max((1.0 - nu) * (1.0 + nu), 0.0));
  // Two axes across, without a branch that loses digits (Duff et al. 2017).
  const double sign = std::copysign(1.0, axis.z);
  const double a = -1.0 / (sign + axis.z);
  const double b = axis.x * axis.y * a;
  const vec3 first(1.0 + sign * axis.x * axis.x * a, sign * b, -sign * axis.x);
  const vec3 second(b, sign + axis.y * axis.y * a, -axis.y);
  const double angle = 2.0 * std::numbers::pi * turn;
  return normalize(axis * nu + first * (sine * std::cos(angle)) + second * (sine * std::sin(angle)));
}

}  // namespace airlight
