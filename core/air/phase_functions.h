#pragma once
// All that is said of the phase functions beside their values (shaders/physics/phase.glsl): a row for each.

#include <functional>

#include "core/air/legendre.h"
#include "core/scene/scene.h"

namespace airlight {

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
const PhaseRow& phase_row(PhaseFunction function);

// Integral of p(nu) P_l(nu) over the sphere, l from 0; to 1e-6. Of the medium's phase function.
LegendreMoments legendre_moments(physics::Physics& p, physics::uint medium);

// The medium's, by channel, as its row says.
physics::vec3 mean_cosine(const physics::Physics& p, physics::uint medium);

}  // namespace airlight
