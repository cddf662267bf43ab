#pragma once
// A picture over a planet, with means of it for all widths of a pixel.

#include <vector>

namespace airlight {

// Rows from the north pole, twice as many columns as rows, `channels` values a texel.
struct PlanetLevel {
  int rows = 0;
  std::vector<float> values;
};

// The picture, then half its rows and so on to one. Each texel is a mean over the area that its level stands for, as
// wide as it is high on the planet, although columns crowd toward the poles.
std::vector<PlanetLevel> planet_levels(PlanetLevel picture, int channels);

// Mean over the planet, by area.
std::vector<double> planet_mean(const PlanetLevel& picture, int channels);

// The picture with `rows` rows, each texel the mean over its area in the picture.
PlanetLevel resampled(const PlanetLevel& picture, int rows, int channels);

}  // namespace airlight
