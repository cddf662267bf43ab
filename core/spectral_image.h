#pragma once
// A picture's spectral radiance on the host, wavelength by wavelength.

#include <string>
#include <vector>

namespace airlight {

struct SpectralImage {
  std::string unit;              // of the radiance, as the spectral layout of OpenEXR writes units
  std::vector<double> nm;        // ascending
  std::vector<double> sunlight;  // above the air, unit times sr
  // The picture's colours are the integral of these planes; else they come from wavelengths of the scene's own, since
  // too few are here to tell them.
  bool tells_colours = false;
  std::vector<std::vector<float>> planes;  // for each wavelength the pixels, row by row from the top
};

}  // namespace airlight
