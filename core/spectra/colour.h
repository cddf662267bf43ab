#pragma once
// From spectra relative to the sun's to linear Rec.709: exact sums over 48 bands, or a few wavelengths with a matrix
// that comes close to these sums.

#include <array>
#include <cstddef>
#include <vector>

#include "core/spectra/curve.h"

namespace airlight {

using Rgb = std::array<double, 3>;

// The light that is (1, 1, 1): sunlight above the air; or CIE D65 or equal energy at all wavelengths, both with the
// luminance of sunlight above the air as the unit. Sunlight and equal energy are reached by a factor on each channel.
enum class White { sun, d65, equal_energy };

struct WaveBand {
  double low = 0.0;  // nm
  double high = 0.0;
};

inline constexpr int kFineBands = 48;  // of 10 nm from 360 nm: the reference for fewer wavelengths

const std::array<WaveBand, kFineBands>& fine_bands();

// Lumens per watt of light at 555 nm in standard air, CIE 018:2019.
inline constexpr double kLumensPerWatt = 683.002;

// Illuminance in lux of light in W/(m2 nm), by the standard observer over the fine bands.
double illuminance(const Curve& light);

// Colour of the sun's light in each band: the factor of a radiance relative to the sun's.
using BandColours = std::array<Rgb, kFineBands>;
BandColours band_colours(const Curve& sun, White white);

// The colour of a spectrum relative to the sun's, by bands; sun_colour() is that of 1 in all bands.
Rgb colour_of(const BandColours& colours, const std::array<double, kFineBands>& relative);
Rgb sun_colour(const BandColours& colours);

// Wavelengths that represent all others, ascending, each with the band over which curves are averaged.
struct Nodes {
  std::vector<double> nm;
  std::vector<WaveBand> bands;
};

inline constexpr int kFewestWavelengths = 3;
inline constexpr int kMostWavelengths = kFineBands;

// For a count of 3 to 6 and 8, positions fitted to clear and hazy skies of Earth. For others, even bands from 380 to
// 730 nm; for 48, the fine bands.
Nodes nodes_for(int count);

// Given wavelengths, ascending, each with a band of `width` nm around it.
Nodes listed_nodes(const std::vector<double>& nm, double width);

// A curve's value at a node: its mean over the node's band.
double at_node(const Curve& curve, const Nodes& nodes, std::size_t k);

// Column k: the colour of 1 at wavelength k.
using ColourMatrix = std::vector<Rgb>;

// A spectrum that is known only at the nodes, and its colour.
struct ColouredSpectrum {
  std::vector<double> at_nodes;
  Rgb colour{};
};

// Divides each fine band's colour between its neighbouring nodes by their distance.
ColourMatrix nearest_matrix(const Nodes& nodes, const BandColours& colours);

// Takes each node's spectrum, relative to the sun's, as constant to halfway to the next nodes, and at the outermost
// nodes to the ends of the fine bands. With many nodes this is the integral.
ColourMatrix cell_matrix(const Nodes& nodes, const Curve& sun, White white);

// The matrix near `prior` that minimises the samples' relative errors and keeps the sun's colour exact. `stiffness`:
// the weight of a change in the matrix against the samples' mean.
ColourMatrix fitted_matrix(const std::vector<ColouredSpectrum>& samples, const ColourMatrix& prior, const Rgb& sun,
                           double stiffness);

// `matrix`, moved toward `plain` as far as needed to give no column a negative luminance; light without negative
// radiance then has none. `plain` is the same sum in columns none of which is dark.
ColourMatrix lit_matrix(ColourMatrix matrix, const ColourMatrix& plain);

// A matrix for light of any air, fitted to smooth spectra of sunlight scattered by molecules and haze and absorbed by
// ozone.
ColourMatrix universal_matrix(const Nodes& nodes, const BandColours& colours);

Rgb colour_by(const ColourMatrix& matrix, const std::vector<double>& at_nodes);

// Mean of the samples' errors, |x - colour| / max(|colour|, 1e-3 mean), channels pooled.
double mean_error(const ColourMatrix& matrix, const std::vector<ColouredSpectrum>& samples);

}  // namespace airlight
