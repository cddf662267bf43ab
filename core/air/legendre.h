#pragma once
// Legendre moments of phase functions.

#include <array>

#include "core/physics/physics.h"

namespace airlight {

using LegendreMoments = std::array<physics::vec3, physics::kLegendreMoments>;  // by channel

// Calls visit(l, P_l(nu)) for l below `count`.
template <class Visit>
void for_each_polynomial(std::size_t count, double nu, Visit visit) {
  double before = 1.0;
  double polynomial = nu;
  visit(std::size_t{0}, 1.0);
  for (std::size_t l = 1; l < count; ++l) {
    visit(l, polynomial);
    const double n = static_cast<double>(l);
    const double next = ((2.0 * n + 1.0) * nu * polynomial - n * before) / (n + 1.0);
    before = polynomial;
    polynomial = next;
  }
}

// Adds `light` at the cosine nu.
inline void add_moments(LegendreMoments& moments, physics::vec3 light, double nu) {
  for_each_polynomial(moments.size(), nu, [&](std::size_t l, double p) { moments[l] = moments[l] + light * p; });
}

}  // namespace airlight
