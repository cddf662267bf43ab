#include "core/spectra/colour.h"

#include <algorithm>
#include <cmath>
#include <span>

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

// The colours of sunlight in bands that cover all wavelengths, each integrated in pieces of at most 10 nm.
std::vector<Rgb> colours_of(std::span<const WaveBand> bands, const Curve& sun, White white) {
  constexpr double kPiece = 10.0;
  std::vector<Rgb> xyz(bands.size());
  Rgb even{};  // of equal energy
  double luminance = 0.0;
  for (std::size_t b = 0; b < bands.size(); ++b) {
    const double width = bands[b].high - bands[b].low;
    const int pieces = std::max(static_cast<int>(std::ceil(width / kPiece - 1e-9)), 1);
    for (int i = 0; i < pieces; ++i) {
      const WaveBand piece{bands[b].low + width * i / pieces, bands[b].low + width * (i + 1) / pieces};
      const Rgb per_nm = response(piece);
      const double power = mean_over(sun, piece.low, piece.high);
      for (std::size_t c = 0; c < 3; ++c) {
        xyz[b][c] += per_nm[c] * power;
        even[c] += per_nm[c];
      }
    }
    luminance += xyz[b][1];
  }
  std::vector<Rgb> colours;
  Rgb all{};
  for (const Rgb& one : xyz) {
    colours.push_back(rec709_from_xyz({one[0] / luminance, one[1] / luminance, one[2] / luminance}));
    for (std::size_t c = 0; c < 3; ++c) {
      all[c] += colours.back()[c];
    }
  }
  Rgb scale{1.0, 1.0, 1.0};
  if (white == White::sun) {
    scale = all;
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

double illuminance(const Curve& light) {
  double sum = 0.0;
  for (const WaveBand& band : fine_bands()) {
    sum += response(band)[1] * mean_over(light, band.low, band.high);
  }
  return kLumensPerWatt * sum;
}

BandColours band_colours(const Curve& sun, White white) {
  const std::vector<Rgb> found = colours_of(fine_bands(), sun, white);
  BandColours colours;
  std::ranges::copy(found, colours.begin());
  return colours;
}

ColourMatrix cell_matrix(const Nodes& nodes, const Curve& sun, White white) {
  std::vector<WaveBand> cells(nodes.nm.size(), {fine_bands().front().low, fine_bands().back().high});
  for (std::size_t k = 1; k < cells.size(); ++k) {
    cells[k].low = 0.5 * (nodes.nm[k - 1] + nodes.nm[k]);
    cells[k - 1].high = cells[k].low;
  }
  return colours_of(cells, sun, white);
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
