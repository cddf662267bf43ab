#pragma once
// A scene with spectra as scenes of three channels, a wavelength each, and the matrix that makes colours of them.

#include <vector>

#include "core/scene/scene.h"

namespace airlight {

// Three wavelengths of a scene. Its channels are radiance over the sun's, times the irradiance that the preset gives.
struct WavelengthGroup {
  Scene scene;                   // without spectra
  std::array<Rgb, 3> colours{};  // of its channels; 0 for a channel that only fills the group up
};

struct SpectralScene {
  Nodes nodes;
  ColourMatrix matrix;
  Rgb sun{};  // the colour of sunlight above the air, for an irradiance of 1
  std::vector<WavelengthGroup> groups;
};

// The scene's wavelengths, with a matrix fitted to its sampled sky. Automatic ones are the fewest, in whole groups,
// whose matrix renders that sky to 0.4 %. The scene must have spectra. The last few matrices are remembered, so that
// all tiles of a picture share one.
SpectralScene spectral_scene(const Scene& scene);

// The same at given wavelengths. The matrix is that of their cells (cell_matrix), close to the truth where they are
// dense.
SpectralScene spectral_scene_at(const Scene& scene, const Nodes& nodes);

// Colours of transmittance, relative to sunlight above the air.
std::array<Rgb, 3> over_the_sun(std::array<Rgb, 3> colours, const Rgb& sun);

// Media that scatter at any wavelength of the groups, bit i for medium i.
std::uint32_t scattering_media(const SpectralScene& spectral);

}  // namespace airlight
