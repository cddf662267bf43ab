#pragma once
// Legendre moments of phase functions.

#include <array>

#include "core/physics/physics.h"

namespace airlight {

using LegendreMoments = std::array<double, physics::kLegendreMoments>;

// Integral of p(nu) P_l(nu) over the sphere, l from 0; to 1e-6.
LegendreMoments legendre_moments(physics::Physics& p, physics::uint phase_code, double g);

}  // namespace airlight
