#pragma once
// Reads a medium's phase function from `media[].phase`.

#include <string>
#include <vector>

#include "core/scene/curve_reader.h"

namespace airlight {

inline constexpr std::size_t kMostPhaseAngles = 4096;

// Fills in the medium's phase function. A table over the wavelength counts as a curve of the preset.
void read_phase(const Section& phase, Medium& medium);

// Lines for people: the integrals of tables as read, where they were not 1.
std::vector<std::string> phase_notes(const Scene& scene);

}  // namespace airlight
