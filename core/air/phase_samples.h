#pragma once
// Phase functions by table as shaders/physics/phase_table.glsl has them.

#include <array>
#include <memory>
#include <vector>

#include "core/air/phase_functions.h"
#include "core/physics/physics.h"
#include "core/scene/scene.h"

namespace airlight {

// Whether its formula has a peak, forward or backward, that slips through the directions by which light is gathered:
// the harmonics above the 16th are then worth more than a twelfth of the first.
bool is_sharp(const Medium& medium);

// Whether the medium has a phase function by table, or is sharp: it then has samples.
bool has_samples(const Medium& medium);

// The samples of the media that have some, in their order, as logarithms; null where none has.
std::shared_ptr<const std::vector<physics::vec3>> phase_samples(const std::vector<Medium>& media);

// Scattering into each of the kPhaseSamples - 1 intervals of a table, shares of a sum of 1: of each channel, then of
// their mean.
std::array<std::vector<double>, 4> interval_shares(const physics::Physics& p, physics::uint table);

// Cosine of the scattering angle of sample k.
double sample_cosine(std::size_t k);

// The moments of a table.
LegendreMoments table_moments(const physics::Physics& p, physics::uint table);

}  // namespace airlight
