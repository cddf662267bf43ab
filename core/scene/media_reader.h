#pragma once
// `media` of a preset.

#include <vector>

#include "core/scene/curve_reader.h"
#include "core/scene/section.h"

namespace airlight {

// `spectra` gets the curves of each medium.
std::vector<Medium> read_media(const Section& root, const Planet& planet, CurveReader& curves, SceneSpectra& spectra);

}  // namespace airlight
