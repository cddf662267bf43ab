#include "core/spectra/reflectance.h"

#include <algorithm>

#include "core/spectra/cholesky.h"

namespace airlight {
namespace {

constexpr std::size_t kBands = kFineBands;

// The matrix of the minimised sum of (x[b + 1] - x[b])^2, plus the sum over c of (A x)[c]^2. As A x is given, the added
// sum does not change the minimum, but it makes the matrix definite.
std::vector<double> slopes_and_colours(const std::array<std::array<double, kBands>, 3>& a) {
  std::vector<double> matrix(kBands * kBands);
  for (std::size_t i = 0; i < kBands; ++i) {
    matrix[i * kBands + i] = i == 0 || i + 1 == kBands ? 1.0 : 2.0;
    if (i > 0) {
      matrix[i * kBands + i - 1] = -1.0;
      matrix[(i - 1) * kBands + i] = -1.0;
    }
  }
  for (std::size_t i = 0; i < kBands; ++i) {
    for (std::size_t j = 0; j < kBands; ++j) {
      matrix[i * kBands + j] += a[0][i] * a[0][j] + a[1][i] * a[1][j] + a[2][i] * a[2][j];
    }
  }
  return matrix;
}

}  // namespace

std::array<Curve, 3> reflectances_of_primaries(const Curve& sun, White white) {
  const BandColours colours = band_colours(sun, white);
  const Rgb whole = sun_colour(colours);
  std::array<std::array<double, kBands>, 3> a{};  // colour over the sun's from a reflectance by bands
  for (std::size_t c = 0; c < 3; ++c) {
    for (std::size_t b = 0; b < kBands; ++b) {
      a[c][b] = colours[b][c] / whole[c];
    }
  }
  const Cholesky slopes(slopes_and_colours(a), kBands);
  std::array<std::vector<double>, 3> towards;  // the least slope for a unit of each multiplier
  std::vector<double> gram(9);
  for (std::size_t c = 0; c < 3; ++c) {
    towards[c] = slopes.solve({a[c].begin(), a[c].end()});
    for (std::size_t d = 0; d < 3; ++d) {
      for (std::size_t b = 0; b < kBands; ++b) {
        gram[3 * d + c] += a[d][b] * towards[c][b];
      }
    }
  }
  const Cholesky multipliers(gram, 3);
  std::array<Curve, 3> curves;
  for (std::size_t j = 0; j < 3; ++j) {
    std::vector<double> unit(3);
    unit[j] = 1.0;
    const std::vector<double> m = multipliers.solve(unit);
    for (std::size_t b = 0; b < kBands; ++b) {
      const WaveBand& band = fine_bands()[b];
      curves[j].wavelengths.push_back(0.5 * (band.low + band.high));
      curves[j].values.push_back(m[0] * towards[0][b] + m[1] * towards[1][b] + m[2] * towards[2][b]);
    }
  }
  return curves;
}

Curve reflectance_of(const std::array<double, 3>& colour, const Curve& sun, White white) {
  const std::array<Curve, 3> primaries = reflectances_of_primaries(sun, white);
  Curve sum = scaled(primaries[0], colour[0]);
  for (std::size_t b = 0; b < sum.values.size(); ++b) {
    sum.values[b] += colour[1] * primaries[1].values[b] + colour[2] * primaries[2].values[b];
    sum.values[b] = std::clamp(sum.values[b], 0.0, 1.0);
  }
  return sum;
}

}  // namespace airlight
