#pragma once
// Display-encoded floats to integer pixels, dithered at 8 bits.

#include <cstdint>
#include <span>

#include "core/base/radiance_image.h"
#include "core/output/png.h"

namespace airlight {

struct QuantizeOptions {
  int bits = 8;        // 8 or 16
  bool dither = true;  // at 8 bits; 16 bits are only rounded
  bool alpha = false;  // keep alpha (a fisheye): RGBA pixels
};

// An empty picture of the right format.
PixelImage make_pixels(int width, int height, const QuantizeOptions& options);

// Writes row y of a picture from display-encoded RGBA; below 0 and NaN become 0, above 1 becomes 1. `pixels` holds the
// picture's rows from `first_row` on.
void quantize_row(std::span<const float> encoded, int y, const QuantizeOptions& options, PixelImage& pixels,
                  int first_row = 0);

// Quantizes a display-encoded picture, such as one from the GPU tone curve, or its rows from `first_row` on.
PixelImage quantize(const RadianceImage& encoded, const QuantizeOptions& options, int first_row = 0);

}  // namespace airlight
