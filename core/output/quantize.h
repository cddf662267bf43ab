#pragma once
// Display-encoded floats to integer pixels, dithered at 8 bits.

#include <cstdint>
#include <span>

#include "core/output/png.h"
#include "core/radiance_image.h"

namespace airlight {

struct QuantizeOptions {
  int bits = 8;        // 8 or 16
  bool dither = true;  // at 8 bits; 16 are only rounded
  bool alpha = false;  // keep alpha (a fisheye): RGBA pixels
};

// An empty picture of the right format.
PixelImage make_pixels(int width, int height, const QuantizeOptions& options);

// One row of `pixels` from display-encoded RGBA; below 0 and NaN become 0, above 1 becomes 1.
void quantize_row(std::span<const float> encoded, int y, const QuantizeOptions& options, PixelImage& pixels);

// A whole picture that is display-encoded already, such as one from the GPU tone curve.
PixelImage quantize(const RadianceImage& encoded, const QuantizeOptions& options);

}  // namespace airlight
