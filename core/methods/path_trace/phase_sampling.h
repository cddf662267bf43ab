#pragma once
// Directions by a medium's phase function.

#include "core/methods/path_trace/random.h"
#include "core/physics/physics.h"

namespace airlight {

// Cosine of the scattering angle, distributed as 2 pi phase_value(kind, g, nu). u in [0, 1); further numbers from
// `random` where a function has no closed inverse.
double sample_phase(physics::Physics& physics, physics::uint kind, double g, double u, Random& random);

// The unit vector at cosine nu from `axis`, `turn` in [0, 1) of a full turn around it.
physics::vec3 around(physics::vec3 axis, double nu, double turn);

}  // namespace airlight
