#pragma once
// A scene with spectra as scenes of three channels, a wavelength each, and the matrix that makes colours of them.

#include <vector>

#include "core/scene/scene.h"

namespace airlight {

// Three wavelengths of a scene. Its channels are radiance over the sun's, times the irradiance that the preset gives.
struct WavelengthGroup {
  Scene scene;                   // without spectra
  std::array<Rgb, 3> colours{};  // of its channels; 0 for one that only fills the group up
};

struct SpectralScene {
  Nodes nodes;
  ColourMatrix matrix;
  Rgb sun{};  // the colour of sunlight above the air, for an irradiance of 1
  std::vector<WavelengthGroup> groups;
};

// Spectra of sunlight scattered once or reflected by the ground, over the sun's, in a few dozen directions around the
// camera, and of the sun seen through the air: at the nodes, and as colours by all fine bands. Then the same as if each
// were scattered once more.
std::vector<ColouredSpectrum> sampled_sky(const Scene& scene, const Nodes& nodes, const BandColours& colours);

// How many wavelengths `auto` takes: the fewest, in whole groups, whose matrix renders the sampled sky to a third of a
// percent.
int automatic_wavelengths(const Scene& scene);

// The scene's wavelengths, with a matrix fitted to its sampled sky. Of a scene that has spectra.
SpectralScene spectral_scene(const Scene& scene);

}  // namespace airlight
