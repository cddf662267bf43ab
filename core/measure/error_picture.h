#pragma once
// Pictures that show the differences between two pictures.

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/measure/raster.h"

namespace airlight::measure {

// The scale of a heat map's colours.
struct ErrorScale {
  bool logarithmic = true;
  double low = 1e-5;   // everything below has the lowest colour
  double high = 1e-2;  // everything above has the highest
  std::string title;

  double fraction(double error) const;
};

// For relative errors: three decades below the power of ten above the largest error, or below `top`. For standard
// errors: linear from 0 to 6, or to `top`.
ErrorScale scale_for(std::span<const float> errors, bool in_sigmas, std::optional<double> top);

// One picture's planes as they are to be shown; grey where there is one plane.
struct ShownPicture {
  std::span<const float> red;
  std::span<const float> green;
  std::span<const float> blue;
};

// An exposure that brings the lower edge of the brightest tenth near white, whatever a black ground or the disc hold.
double exposure_for(const ShownPicture& picture);

struct PictureSize {
  int width = 0;
  int height = 0;
};

// The errors with the scale drawn below, numbered. Small pictures are enlarged by a whole factor.
Raster draw_heatmap(std::span<const float> errors, PictureSize size, const ErrorScale& scale);

// A, B and the errors in a row; A and B both with the exposure for B.
Raster draw_side_by_side(const ShownPicture& a, const ShownPicture& b, std::span<const float> errors, PictureSize size,
                         const ErrorScale& scale);

}  // namespace airlight::measure
