#pragma once
// --spectral and --spectrum: the wavelengths, and whether a scene has any.

#include <string>

#include "core/scene/scene.h"
#include "core/spectra/colour.h"

namespace airlight {

inline constexpr const char* kUsualWavelengths = "380:780:10";

// "380:780:10" = FIRST:LAST:STEP in nm: from FIRST in steps to at most LAST. Each wavelength stands for a band around
// it as wide as the step, at most 10 nm. Throws InputError: malformed, outside 360 to 830, a step that is too small or
// leads nowhere, fewer than 2 or more than 96 wavelengths. `option`: "render: --spectral".
Nodes wavelengths_from(const std::string& text, const std::string& option);

// Throws InputError for a picture whose spectrum would take more than half a GiB, or a buffer more than a device has.
void require_spectrum_fits(const Scene& scene, std::size_t wavelengths, const std::string& option);

// Throws InputError for a scene of three channels.
void require_spectra(const Scene& scene, const std::string& option);

}  // namespace airlight
