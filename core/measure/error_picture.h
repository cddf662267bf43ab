#pragma once
// The pictures that show where two pictures differ.

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/measure/raster.h"

namespace airlight::measure {

// What a heat map's colours mean.
struct ErrorScale {
  bool logarithmic = true;
  double low = 1e-5;   // everything below has the lowest colour
  double high = 1e-2;  // everything above has the highest
  std::string title;

  double fraction(double error) const;
};

// Relative errors: three decades below the power of ten that holds the largest, or below `top`. Standard errors: linear
// from 0 to 6, or to `top`.
ErrorScale scale_for(std::span<const float> errors, bool in_sigmas, std::optional<double> top);

// One picture's planes as they are to be shown; grey where there is one plane.
struct ShownPicture {
  std::span<const float> red;
  std::span<const float> green;
  std::span<const float> blue;
};

// Brings the brightest tenth's lower edge to near white: robust against a black ground and against the sun's disc.
double exposure_for(const ShownPicture& picture);

struct PictureSize {
  int width = 0;
  int height = 0;
};

// The errors with the scale drawn below, numbered. Small pictures are enlarged by a whole factor.
Raster draw_heatmap(std::span<const float> errors, PictureSize size, const ErrorScale& scale);

// A, B and the errors in a row; A and B with the exposure that suits B.
Raster draw_side_by_side(const ShownPicture& a, const ShownPicture& b, std::span<const float> errors, PictureSize size,
                         const ErrorScale& scale);

}  // namespace airlight::measure
