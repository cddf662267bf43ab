#pragma once
// A medium's phase function, as `media[].phase` says it.

#include <string>
#include <vector>

#include "core/scene/curve_reader.h"

namespace airlight {

inline constexpr std::size_t kMostPhaseAngles = 4096;

// Fills in the medium's phase function. A table over the wavelength is a curve of the preset's.
void read_phase(const Section& phase, Medium& medium, MediumSpectra& spectra, CurveReader& curves);

// Lines for people: what the integrals of tables were as read, where they were not 1.
std::vector<std::string> phase_notes(const Scene& scene);

}  // namespace airlight
