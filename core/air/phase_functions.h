#pragma once
// All that is said of the phase functions beside their values (shaders/physics/phase.glsl): a row for each.

#include <array>
#include <functional>

#include "core/physics/physics.h"
#include "core/scene/scene.h"

namespace airlight {

using LegendreMoments = std::array<physics::vec3, physics::kLegendreMoments>;  // by channel

// What is near enough to a phase function's mean cosine to steer samples by.
enum class MeanCosine { zero, g, first_moment };

using UniformNumbers = std::function<double()>;  // each in [0, 1)

struct PhaseRow {
  PhaseFunction function;  // that a preset names
  physics::uint code;      // of phase.glsl
  MeanCosine mean_cosine;
  bool is_smooth;   // so wide that a coarse table of directions holds it
  bool by_channel;  // a medium's channels may have different ones
  // Integrals of p(nu) P_l(nu) over the sphere, l from 0; to 1e-6 once divided by the first.
  LegendreMoments (*moments)(physics::Physics& p, physics::uint medium);
  // Cosine of a scattering angle, distributed as the mean of the channels' functions: by u in [0, 1), and by further
  // numbers where there is no closed inverse. Null: by a table's samples (PhaseSampler).
  double (*draw)(physics::Physics& p, const physics::MediumData& m, double u, const UniformNumbers& further);

  // Whether g makes a peak, forward or backward.
  bool is_peaked_by_g() const { return mean_cosine == MeanCosine::g && !is_smooth; }
};

const PhaseRow& phase_row(physics::uint code);
inline const PhaseRow& phase_row(PhaseFunction function) {
  return phase_row(static_cast<physics::uint>(function));
}

// Integral of p(nu) P_l(nu) over the sphere, l from 0; to 1e-6. Of the medium's phase function.
LegendreMoments legendre_moments(physics::Physics& p, physics::uint medium);

// The medium's, by channel, as its row says.
physics::vec3 mean_cosine(const physics::Physics& p, physics::uint medium);

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
