#pragma once
// Legendre moments of phase functions.

#include <array>

#include "core/physics/physics.h"

namespace airlight {

using LegendreMoments = std::array<physics::vec3, physics::kLegendreMoments>;  // by channel

// Integral of p(nu) P_l(nu) over the sphere, l from 0; to 1e-6. Of the medium's phase function.
LegendreMoments legendre_moments(physics::Physics& p, physics::uint medium);

// Adds `light` at the cosine nu.
void add_moments(LegendreMoments& moments, physics::vec3 light, double nu);

}  // namespace airlight
