#pragma once
// From spectra relative to the sun's to linear Rec.709: exact sums over 48 bands, and the few wavelengths with a matrix
// that come close to them.

#include <array>
#include <cstddef>
#include <vector>

#include "core/spectra/curve.h"

namespace airlight {

using Rgb = std::array<double, 3>;

// What is (1, 1, 1): sunlight above the air; or, with the luminance of sunlight above the air as the unit, CIE D65, or
// equal energy at all wavelengths. Sunlight and equal energy by a factor on each channel.
enum class White { sun, d65, equal_energy };

struct WaveBand {
  double low = 0.0;  // nm
  double high = 0.0;
};

inline constexpr int kFineBands = 48;  // of 10 nm from 360 nm: what fewer wavelengths are measured by

const std::array<WaveBand, kFineBands>& fine_bands();

// Lumens a watt of light at 555 nm in standard air, CIE 018:2019.
inline constexpr double kLumensPerWatt = 683.002;

// Lux of light of so many W/(m2 nm), by the standard observer over the fine bands.
double illuminance(const Curve& light);

// For each band the colour of the sun's light in it: what a radiance over the sun's is multiplied by.
using BandColours = std::array<Rgb, kFineBands>;
BandColours band_colours(const Curve& sun, White white);

// The colour of a spectrum over the sun's, by bands; of 1 in all of them, the sun's.
Rgb colour_of(const BandColours& colours, const std::array<double, kFineBands>& relative);
Rgb sun_colour(const BandColours& colours);

// Wavelengths that stand for all, ascending, each with the band that curves are averaged over.
struct Nodes {
  std::vector<double> nm;
  std::vector<WaveBand> bands;
};

inline constexpr int kFewestWavelengths = 3;
inline constexpr int kMostWavelengths = kFineBands;

// 3 to 6 and 8: positions fitted to clear and hazy skies of Earth. Else even bands, from 380 to 730 nm; 48 are the fine
// ones.
Nodes nodes_for(int count);

// Wavelengths of one's own, ascending, each with a band of `width` nm around it.
Nodes listed_nodes(const std::vector<double>& nm, double width);

// A curve at a node: its mean over the band.
double at_node(const Curve& curve, const Nodes& nodes, std::size_t k);

// Column k: the colour of 1 at wavelength k.
using ColourMatrix = std::vector<Rgb>;

// A spectrum that is known at the nodes alone, and its colour.
struct ColouredSpectrum {
  std::vector<double> at_nodes;
  Rgb colour{};
};

// Each fine band's colour shared among the nodes beside it by their distance.
ColourMatrix nearest_matrix(const Nodes& nodes, const BandColours& colours);

// Each node's spectrum over the sun's taken to hold halfway to the nodes beside it, the outermost ones' to the ends of
// the fine bands: the integral of many nodes.
ColourMatrix cell_matrix(const Nodes& nodes, const Curve& sun, White white);

// The matrix next to `prior` that minimises the relative errors of the samples, the sun's colour exact. `stiffness`:
// the weight of a change in the matrix against the samples' mean.
ColourMatrix fitted_matrix(const std::vector<ColouredSpectrum>& samples, const ColourMatrix& prior, const Rgb& sun,
                           double stiffness);

// `matrix`, moved toward `plain`, the same sum in columns none of which is dark, as far as it takes for no column to
// have a negative luminance: light of no negative radiance then has none.
ColourMatrix lit_matrix(ColourMatrix matrix, const ColourMatrix& plain);

// For light of any air: fitted to smooth spectra of sunlight scattered by molecules and haze and absorbed by ozone.
ColourMatrix universal_matrix(const Nodes& nodes, const BandColours& colours);

Rgb colour_by(const ColourMatrix& matrix, const std::vector<double>& at_nodes);

// Mean of the samples' errors, |x - colour| / max(|colour|, 1e-3 mean), channels pooled.
double mean_error(const ColourMatrix& matrix, const std::vector<ColouredSpectrum>& samples);

}  // namespace airlight
