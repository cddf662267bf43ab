#pragma once
// What --spectral asks for, and what it does not go with.

#include <optional>

#include "app/render/run.h"
#include "app/render/targets.h"
#include "core/spectra/colour.h"

namespace airlight::cli {

// Wavelengths times pixels, at most: they are kept in memory, 512 MiB of them, until the EXR is encoded.
inline constexpr std::size_t kMostSpectralSamples = std::size_t{1} << 27;

// The wavelengths of --spectral; nothing where it is not given. Throws InputError where they cannot be had.
std::optional<Nodes> spectral_wavelengths(const RenderOrder& given, const Scene& scene, const Targets& targets);

}  // namespace airlight::cli
