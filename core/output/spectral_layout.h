#pragma once
// Spectral images in OpenEXR as Fichet, Pacanowski and Wilkie lay them out (An OpenEXR Layout for Spectral Images, JCGT
// 10(3), 2021), version 1.0: unpolarised light that is emitted, a channel a wavelength, beside R, G and B.

#include <map>
#include <string>

#include "core/spectral_image.h"

namespace airlight {

// "S0.550,000000nm": Stokes' first component; a comma, as a point would begin a layer's name.
std::string spectral_channel_name(double nm);

// Attributes of the file, all strings: spectralLayoutVersion and emissiveUnits by the layout; airlight:sunlight, the
// sunlight above the air in the layout's writing of a spectrum ("380nm:1.07;390nm:1.1;"), unit times sr; and
// airlight:picture, where the colours come from.
std::map<std::string, std::string> spectral_attributes(const SpectralImage& spectrum);

// Where the colours beside a spectrum come from, in words.
std::string origin_of_colours(const SpectralImage& spectrum);

}  // namespace airlight
