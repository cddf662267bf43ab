#include "core/spectra/colour.h"

#include <cmath>

#include "core/spectra/data.h"

namespace airlight {
namespace {

// XYZ to linear Rec.709, IEC 61966-2-1, with more digits: from the primaries and D65 at x 0.3127, y 0.3290.
constexpr std::array<Rgb, 3> kRec709{{{3.2409699419045226, -1.5373831775700940, -0.4986107602930034},
                                      {-0.9692436362808796, 1.8759675015077202, 0.0415550574071756},
                                      {0.0556300796969937, -0.2039769588889766, 1.0569715142428786}}};

Rgb rec709_from_xyz(const Rgb& xyz) {
  Rgb rgb{};
  for (std::size_t c = 0; c < 3; ++c) {
    rgb[c] = kRec709[c][0] * xyz[0] + kRec709[c][1] * xyz[1] + kRec709[c][2] * xyz[2];
  }
  return rgb;
}

// The observer's response to 1 per nm in a band.
Rgb response(const WaveBand& band) {
  const double width = band.high - band.low;
  return {width * mean_over(observer().x, band.low, band.high), width * mean_over(observer().y, band.low, band.high),
          width * mean_over(observer().z, band.low, band.high)};
}

}  // namespace

const std::array<WaveBand, kFineBands>& fine_bands() {
  static const std::array<WaveBand, kFineBands> bands = [] {
    std::array<WaveBand, kFineBands> made;
    for (int b = 0; b < kFineBands; ++b) {
      made[static_cast<std::size_t>(b)] = {360.0 + 10.0 * b, 370.0 + 10.0 * b};
    }
    return made;
  }();
  return bands;
}

BandColours band_colours(const Curve& sun, White white) {
  std::array<Rgb, kFineBands> xyz;
  Rgb even{};  // of equal energy
  double luminance = 0.0;
  for (std::size_t b = 0; b < xyz.size(); ++b) {
    const WaveBand& band = fine_bands()[b];
    const Rgb per_nm = response(band);
    const double power = mean_over(sun, band.low, band.high);
    for (std::size_t c = 0; c < 3; ++c) {
      xyz[b][c] = per_nm[c] * power;
      even[c] += per_nm[c];
    }
    luminance += xyz[b][1];
  }
  BandColours colours;
  Rgb scale{1.0, 1.0, 1.0};
  for (std::size_t b = 0; b < xyz.size(); ++b) {
    colours[b] = rec709_from_xyz({xyz[b][0] / luminance, xyz[b][1] / luminance, xyz[b][2] / luminance});
  }
  if (white == White::sun) {
    scale = sun_colour(colours);
  } else if (white == White::equal_energy) {
    scale = rec709_from_xyz({even[0] / even[1], 1.0, even[2] / even[1]});
  }
  for (Rgb& colour : colours) {
    for (std::size_t c = 0; c < 3; ++c) {
      colour[c] /= scale[c];
    }
  }
  return colours;
}

Rgb colour_of(const BandColours& colours, const std::array<double, kFineBands>& relative) {
  Rgb sum{};
  for (std::size_t b = 0; b < colours.size(); ++b) {
    for (std::size_t c = 0; c < 3; ++c) {
      sum[c] += colours[b][c] * relative[b];
    }
  }
  return sum;
}

Rgb sun_colour(const BandColours& colours) {
  std::array<double, kFineBands> one{};
  one.fill(1.0);
  return colour_of(colours, one);
}

Rgb colour_by(const ColourMatrix& matrix, const std::vector<double>& at_nodes) {
  Rgb sum{};
  for (std::size_t k = 0; k < matrix.size(); ++k) {
    for (std::size_t c = 0; c < 3; ++c) {
      sum[c] += matrix[k][c] * at_nodes[k];
    }
  }
  return sum;
}

double mean_error(const ColourMatrix& matrix, const std::vector<ColouredSpectrum>& samples) {
  double mean = 0.0;
  for (const ColouredSpectrum& sample : samples) {
    mean += (sample.colour[0] + sample.colour[1] + sample.colour[2]) / (3.0 * static_cast<double>(samples.size()));
  }
  double sum = 0.0;
  for (const ColouredSpectrum& sample : samples) {
    const Rgb found = colour_by(matrix, sample.at_nodes);
    for (std::size_t c = 0; c < 3; ++c) {
      sum += std::fabs(found[c] - sample.colour[c]) / std::fmax(std::fabs(sample.colour[c]), 1e-3 * mean);
    }
  }
  return samples.empty() ? 0.0 : sum / (3.0 * static_cast<double>(samples.size()));
}

}  // namespace airlight
