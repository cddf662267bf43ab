#pragma once
// Spectral radiance at listed wavelengths, by the scene's own method: groups of three of them, each a scene of three
// channels.

#include <string>
#include <vector>

#include "core/render/bands.h"
#include "core/spectra/colour.h"

namespace airlight {

// Greatest error, a share, of colours summed from the planes, judged by sunlight scattered once, at which the picture
// is that sum.
inline constexpr double kTellsColours = 2e-3;

// Factor from radiance over the sun's to spectral radiance, and the unit. For relative suns: sun.irradiance times
// sun.spectrum, in W/(m2 nm) where that is ASTM G-173. With an absolute unit: scaled so that sunlight above the air has
// the illuminance of the unit.
inline constexpr const char* kAbsoluteSpectralUnit = "W.m^-2.sr^-1.nm^-1";
struct SpectralUnit {
  double scale = 1.0;  // times sun.spectrum
  std::string name;
};
SpectralUnit spectral_unit(const Scene& scene);

// render_bands() of a request for a spectrum: radiance averaged over the nodes' bands, sun's disc included, beside the
// picture. Every three wavelengths are a picture of their own, which is kept in memory until its bands go on.
Rendering render_spectrum(const DeviceOnDemand& device, const Stage& stage, BandsRequest request);

struct SpectralProbe {
  std::vector<double> radiance;       // by wavelength, as SpectralImage has it; without the sun's disc
  std::vector<double> transmittance;  // to the ground or to space
  std::vector<double> q;              // as ProbeResult has it, in the radiance's unit; empty: not told
  std::vector<double> u;
};

struct SpectralProbes {
  SpectralImage wavelengths;              // without planes
  std::vector<SpectralProbe> directions;  // as listed
  std::vector<std::string> undone;        // as Rendering::undone
};

// probe() at listed wavelengths.
SpectralProbes probe_spectrum(const DeviceOnDemand& device, const Stage& stage,
                              const std::vector<Direction>& directions, const Nodes& nodes);

}  // namespace airlight
