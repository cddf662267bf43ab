#pragma once
// A picture's spectral radiance on the host, wavelength by wavelength.

#include <string>
#include <vector>

namespace airlight {

struct SpectralImage {
  std::string unit;              // of the radiance, as OpenEXR's spectral layout writes units
  std::vector<double> nm;        // ascending
  std::vector<double> sunlight;  // above the air, unit times sr
  // True: the picture's colours are the integral of these planes. False: they come from the scene's own wavelengths,
  // since these planes are too few to yield colours.
  bool tells_colours = false;
  std::vector<std::vector<float>> planes;  // for each wavelength the pixels, row by row from the top

  SpectralImage like() const { return {unit, nm, sunlight, tells_colours, {}}; }  // without planes
};

}  // namespace airlight
