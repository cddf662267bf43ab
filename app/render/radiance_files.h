#pragma once
// Skies for Radiance, the lighting programs [Ward 1994]: `render --radiance FILE.rad` and the sky matrices of
// `sequence --radiance-matrix`.
//
// Radiance's axes: x east, y north, z up. Its colours are radiance in W/(m2 sr) at 179 lm/W, whatever the light, in
// primaries of its own: luminance = 179 (0.265 R + 0.670 G + 0.065 B). So the light that Radiance finds has the
// luminance and the chromaticity of airlight's; a sun without a unit counts as Earth's, 128 000 lux.

#include <string>
#include <vector>

#include "app/render/picture_files.h"
#include "core/render/lighting.h"

namespace airlight::cli {

// A colour in linear Rec.709 as Radiance's; 0 in place of a negative channel. `luminance_of_one`: cd/m2 of the colour
// (1, 1, 1), as core/scene/photometry.h tells it.
Vector3 radiance_colour(const Vector3& rec709, double luminance_of_one);

// Size of the sky's picture: half a degree a pixel.
inline constexpr ImageSize kRadianceSky{720, 360};

// "sky.rad" -> "sky.hdr"; of a sky with a spectrum "sky.hsr".
std::string radiance_picture_file(const std::string& rad, bool spectral);

// What the scene's files hold.
struct RadianceSky {
  Rendering whole;                   // whole_sky() of kRadianceSky, with a spectrum or without
  std::vector<double> sun_spectrum;  // sun_spectrum() of the same wavelengths
};

// A spectrum's wavelengths for a picture of so many components. Throws InputError: not 4 to 24, or not around 480 and
// 588 nm, where Radiance divides them among red, green and blue.
void require_components(const Nodes& nodes);

// The scene's text: a sphere of light all around by the picture's file, a latlong whose centre looks north, then sun
// and moon as sources where they give light. The moon is left out of spectra.
std::string radiance_text(const std::string& picture, const RadianceSky& sky, const Lighting& lighting,
                          const PictureContext& context);

// Writes both files. Returns their names. Throws RunError.
//
// A spectral picture has mantissas of 8 bits and an exponent for each pixel, from the shortest wavelength on; a value
// is the spectral radiance times the width of all bands, so that light of equal energy is grey.
std::vector<std::string> write_radiance(const std::string& rad, const RadianceSky& sky, const Lighting& lighting,
                                        const PictureContext& context);

}  // namespace airlight::cli
