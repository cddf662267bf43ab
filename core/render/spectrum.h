#pragma once
// Spectral radiance at listed wavelengths, by the scene's own method: groups of three of them, each a scene of three
// channels.

#include <string>
#include <vector>

#include "core/render/render.h"
#include "core/spectra/colour.h"

namespace airlight {

// How far colours that are summed from the planes may be off, by sunlight scattered once, for the picture to be that
// sum: a share.
inline constexpr double kTellsColours = 2e-3;

// Spectral radiance for radiance over the sun's, and its unit. Relative suns: sun.irradiance times sun.spectrum, which
// is W/(m2 nm) where that is ASTM G-173. With an absolute unit: scaled so that sunlight above the air has the
// illuminance that the unit gives it.
struct SpectralUnit {
  double scale = 1.0;  // of sun.spectrum
  std::string name;
};
SpectralUnit spectral_unit(const Scene& scene);

// The picture of a scene with spectra, and beside it its spectrum: radiance averaged over the nodes' bands, sun's disc
// included. Its colours are the spectrum's own where it tells them to kTellsColours, else they are render()'s. Layers
// and tables are not rendered. Throws as render(); a fault at any wavelength is the result's.
Rendering render_spectrum(const DeviceOnDemand& device, const Scene& scene, const RenderRequest& request,
                          const Nodes& nodes);

// Every pass that one group of the wavelengths takes at most; opens no device.
Plan plan_for_spectrum(const Scene& scene, const Nodes& nodes);

struct SpectralProbe {
  std::vector<double> radiance;       // by wavelength, as SpectralImage has it; without the sun's disc
  std::vector<double> transmittance;  // to the ground or to space
};

struct SpectralProbes {
  SpectralImage wavelengths;              // without planes
  std::vector<SpectralProbe> directions;  // as listed
  std::vector<std::string> undone;        // as Rendering::undone
};

// As probe(), at listed wavelengths.
SpectralProbes probe_spectrum(const DeviceOnDemand& device, const Scene& scene,
                              const std::vector<Direction>& directions, const Nodes& nodes);

}  // namespace airlight
