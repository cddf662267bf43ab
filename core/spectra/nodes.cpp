#include <algorithm>
#include <cassert>
#include <cmath>
#include <span>

#include "core/base/srgb.h"
#include "core/spectra/cholesky.h"
#include "core/spectra/colour.h"
#include "core/spectra/data.h"

namespace airlight {
namespace {

// Three: the wavelengths at which a matrix made for the scene does best from noon to a sun of 3 degrees. More: fitted,
// with free matrices, to 1608 spectra of single scattering over clear and hazy air (sun 60 to -6 degrees, aerosol depth
// 0.005 to 0.5, ozone 220 to 450 DU) and to skies of all orders.
constexpr std::array<double, 3> kThree{449, 541, 615};
constexpr std::array<double, 4> kFour{446, 526, 582, 648};
constexpr std::array<double, 5> kFive{439, 487, 539, 601, 643};
constexpr std::array<double, 6> kSix{434, 478, 527, 565, 618, 672};
constexpr std::array<double, 8> kEight{418, 458, 493, 535, 547, 597, 613, 660};

std::span<const double> fitted_nodes(int count) {
  switch (count) {
    case 3:
      return kThree;
    case 4:
      return kFour;
    case 5:
      return kFive;
    case 6:
      return kSix;
    case 8:
      return kEight;
    default:
      return {};
  }
}

constexpr double kNarrow = 10.0;

// Bands are as wide as a fine one where two do not overlap. Half the gap to each neighbour would be too wide: the mean
// of ozone's absorption differs from the absorption that light meets on a long way through it (3.4 % instead of 0.7,
// sun at 0.5 degrees).
Nodes with_bands(std::span<const double> nm) {
  return listed_nodes({nm.begin(), nm.end()}, kNarrow);
}

double middle(const WaveBand& band) {
  return 0.5 * (band.low + band.high);
}

double sum_of(const std::vector<double>& v) {
  double sum = 0.0;
  for (const double x : v) {
    sum += x;
  }
  return sum;
}

// Normal equations of one channel's relative errors.
struct Equations {
  std::vector<double> left;
  std::vector<double> right;
};

Equations equations_of(const std::vector<ColouredSpectrum>& samples, std::size_t channel, std::size_t n) {
  Equations e{std::vector<double>(n * n), std::vector<double>(n)};
  for (const ColouredSpectrum& sample : samples) {
    const Rgb& colour = sample.colour;
    // A channel near 0 beside the others is unfit for relative errors.
    const double most = std::max({std::fabs(colour[0]), std::fabs(colour[1]), std::fabs(colour[2])});
    const double scale = std::max(std::fabs(colour[channel]), 0.02 * most);
    if (!(scale > 0.0)) {
      continue;
    }
    const double weight = 1.0 / (scale * scale);
    for (std::size_t i = 0; i < n; ++i) {
      e.right[i] += weight * sample.at_nodes[i] * colour[channel];
      for (std::size_t j = 0; j < n; ++j) {
        e.left[i * n + j] += weight * sample.at_nodes[i] * sample.at_nodes[j];
      }
    }
  }
  return e;
}

}  // namespace

Nodes nodes_for(int count) {
  assert(count >= kFewestWavelengths && count <= kMostWavelengths);
  if (const std::span<const double> nm = fitted_nodes(count); !nm.empty()) {
    return with_bands(nm);
  }
  const double low = count == kFineBands ? fine_bands().front().low : 380.0;
  const double high = count == kFineBands ? fine_bands().back().high : 730.0;
  Nodes nodes;
  for (int k = 0; k < count; ++k) {
    nodes.bands.push_back({low + (high - low) * k / count, low + (high - low) * (k + 1) / count});
    nodes.nm.push_back(middle(nodes.bands.back()));
  }
  return nodes;
}

Nodes listed_nodes(const std::vector<double>& nm, double width) {
  Nodes nodes{nm, {}};
  for (const double x : nm) {
    nodes.bands.push_back({x - 0.5 * width, x + 0.5 * width});
  }
  return nodes;
}

double at_node(const Curve& curve, const Nodes& nodes, std::size_t k) {
  return mean_over(curve, nodes.bands[k].low, nodes.bands[k].high);
}

ColourMatrix nearest_matrix(const Nodes& nodes, const BandColours& colours) {
  ColourMatrix matrix(nodes.nm.size());
  for (std::size_t b = 0; b < colours.size(); ++b) {
    const double nm = middle(fine_bands()[b]);
    const auto after = static_cast<std::size_t>(std::ranges::upper_bound(nodes.nm, nm) - nodes.nm.begin());
    const std::size_t high = std::min(after, nodes.nm.size() - 1);
    const std::size_t low = after == 0 ? 0 : after - 1;
    const double share =
        high == low ? 1.0 : std::clamp((nm - nodes.nm[low]) / (nodes.nm[high] - nodes.nm[low]), 0.0, 1.0);
    for (std::size_t c = 0; c < 3; ++c) {
      matrix[high][c] += share * colours[b][c];
      matrix[low][c] += high == low ? 0.0 : (1.0 - share) * colours[b][c];
    }
  }
  return matrix;
}

ColourMatrix fitted_matrix(const std::vector<ColouredSpectrum>& samples, const ColourMatrix& prior, const Rgb& sun,
                           double stiffness) {
  const std::size_t n = prior.size();
  ColourMatrix matrix = prior;
  for (std::size_t c = 0; c < 3; ++c) {
    Equations e = equations_of(samples, c, n);
    double trace = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
      trace += e.left[i * n + i];
    }
    // Without samples the result is the prior, with its sum corrected.
    const double ridge = trace > 0.0 ? stiffness * trace / static_cast<double>(n) : 1.0;
    for (std::size_t i = 0; i < n; ++i) {
      e.left[i * n + i] += ridge;
      e.right[i] += ridge * prior[i][c];
    }
    const Cholesky factors(std::move(e.left), n);
    std::vector<double> row = factors.solve(std::move(e.right));
    // The nearest row, in the same measure, whose sum is the sun's colour.
    const std::vector<double> one = factors.solve(std::vector<double>(n, 1.0));
    const double missing = (sun[c] - sum_of(row)) / sum_of(one);
    for (std::size_t i = 0; i < n; ++i) {
      matrix[i][c] = row[i] + missing * one[i];
    }
  }
  return matrix;
}

ColourMatrix lit_matrix(ColourMatrix matrix, const ColourMatrix& plain) {
  const auto luminance = [](const Rgb& colour) { return bt709_luminance(colour[0], colour[1], colour[2]); };
  double share = 0.0;
  for (std::size_t k = 0; k < matrix.size(); ++k) {
    const double here = luminance(matrix[k]);
    if (here < 0.0) {
      share = std::max(share, -here / std::max(luminance(plain[k]) - here, -here));
    }
  }
  for (std::size_t k = 0; share > 0.0 && k < matrix.size(); ++k) {
    for (std::size_t c = 0; c < 3; ++c) {
      matrix[k][c] += share * (plain[k][c] - matrix[k][c]);
    }
  }
  return matrix;
}

ColourMatrix universal_matrix(const Nodes& nodes, const BandColours& colours) {
  // Air scatters by the power 0 to 1 of Rayleigh's law. The light has passed through so many verticals of air, of haze
  // and of ozone (300 DU each).
  constexpr std::array<double, 3> kPowers{0.0, 0.4, 1.0};
  constexpr std::array<double, 5> kAir{0.0, 1.0, 4.0, 10.0, 25.0};
  constexpr std::array<double, 3> kHaze{0.0, 0.3, 2.0};
  constexpr std::array<double, 4> kOzone{0.0, 2.0, 8.0, 20.0};
  constexpr double kOzoneMolecules = 300.0 * kMoleculesPerDobsonUnit;

  // For a wavelength: the logarithms of what each part of the air transmits.
  struct Wavelength {
    double scatters = 0.0;
    double air = 0.0;
    double haze = 0.0;
    double ozone = 0.0;
  };
  const auto wavelength = [](double nm, const WaveBand& band) {
    const double rayleigh = rayleigh_scattering(nm);
    return Wavelength{std::log(rayleigh / rayleigh_scattering(550.0)), -8.4 * rayleigh, -std::pow(nm / 550.0, -1.3),
                      -kOzoneMolecules * mean_over(ozone_cross_section(), band.low, band.high)};
  };
  std::vector<Wavelength> wavelengths;
  for (const WaveBand& band : fine_bands()) {
    wavelengths.push_back(wavelength(middle(band), band));
  }
  for (std::size_t k = 0; k < nodes.nm.size(); ++k) {
    wavelengths.push_back(wavelength(nodes.nm[k], nodes.bands[k]));
  }
  std::vector<ColouredSpectrum> samples;
  std::vector<double> light(wavelengths.size());
  for (const double power : kPowers) {
    for (const double air : kAir) {
      for (const double haze : kHaze) {
        for (const double ozone : kOzone) {
          std::ranges::transform(wavelengths, light.begin(), [&](const Wavelength& w) {
            return std::exp(power * w.scatters + air * w.air + haze * w.haze + ozone * w.ozone);
          });
          std::array<double, kFineBands> fine{};
          std::copy_n(light.begin(), kFineBands, fine.begin());
          samples.push_back({{light.begin() + kFineBands, light.end()}, colour_of(colours, fine)});
        }
      }
    }
  }
  return fitted_matrix(samples, nearest_matrix(nodes, colours), sun_colour(colours), 1e-4);
}

}  // namespace airlight
