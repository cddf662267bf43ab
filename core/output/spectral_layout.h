#pragma once
// Spectral images in OpenEXR as Fichet, Pacanowski and Wilkie lay them out (An OpenEXR Layout for Spectral Images, JCGT
// 10(3), 2021), version 1.0: unpolarised light that is emitted, a channel a wavelength, beside R, G and B.

#include <map>
#include <string>

#include "core/base/spectral_image.h"

namespace airlight {

// "S0.550,000000nm": Stokes' first component. The decimal mark is a comma, since a point would begin a layer's name.
std::string spectral_channel_name(double nm);

// Attributes of the file, all strings. spectralLayoutVersion and emissiveUnits follow the layout. airlight:sunlight is
// the sunlight above the air, unit times sr, in the layout's notation of a spectrum ("380nm:1.07;390nm:1.1;").
// airlight:picture is the origin of the colours.
std::map<std::string, std::string> spectral_attributes(const SpectralImage& spectrum);

// The origin of the colours beside a spectrum, in words.
std::string origin_of_colours(const SpectralImage& spectrum);

}  // namespace airlight
