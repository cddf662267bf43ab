#pragma once
// The phase function of cloud drops by Mie's theory (Bohren and Huffman 1983, ch. 4; the recurrences of their appendix
// A). Their sizes are spread as n(r) ~ r^(1/b - 3) exp(-r / (a b)), a the effective radius, b = 1/9 the effective
// variance (Hansen and Travis 1974, eq. 2.56): with a = 6 um Deirmendjian's cloud C.1.

#include <array>
#include <vector>

#include "core/spectra/phase_table.h"

namespace airlight {

inline constexpr double kDropVariance = 1.0 / 9.0;

// nm: what the three channels of a scene without spectra stand for where they meet drops.
inline constexpr std::array<double, 3> kDropChannels{615.0, 541.0, 449.0};

// Refractive index of water in air at 20 degrees C (Daimon and Masumura 2007, table 3), 182 to 1129 nm.
double water_index(double nm);

// Extinction, 1/km, of drops: 1.5 water / radius, since spheres much larger than the wavelength take out of light twice
// what they cover. `water`: g/m3, `radius`: um. The same of ice, of 0.917 g/cm3.
double drop_extinction(double water, double radius);
double crystal_extinction(double water, double radius);

// One sphere that absorbs nothing. `x`: circumference over wavelength, `m`: relative refractive index.
struct MieEfficiencies {
  double scattering = 0.0;  // cross section over pi r^2
  double asymmetry = 0.0;   // mean cosine
};
MieEfficiencies mie_efficiencies(double x, double m);

// The table of drops of this effective radius (um, 1 to 40) at these wavelengths, ascending; each row's integral over
// the sphere is 1. `m`: their refractive index in place of water's; 0: water's.
PhaseTable drops_table(double effective_radius, const std::vector<double>& wavelengths_nm, double m = 0.0);

// The same at five wavelengths of what the eye sees. The last few tables are remembered, since a preset is read many
// times over.
PhaseTable drops_phase(double effective_radius);

}  // namespace airlight
