#pragma once
// Published spectra.

#include "core/spectra/curve.h"

namespace airlight {

// The curves of the standard observer, per nm.
struct Observer {
  Curve x;
  Curve y;
  Curve z;
};
const Observer& observer();

// Sunlight above the air, W/(m2 nm), 365 to 835 nm.
const Curve& solar_irradiance();

// m2 per molecule, 365 to 835 nm.
const Curve& ozone_cross_section();

inline constexpr double kMoleculesPerDobsonUnit = 2.6868e20;  // per m2

// Scattering coefficient, 1/km, of dry air with 360 ppm CO2 at 288.15 K and 1013.25 hPa: the fit of Bodhaine and others
// 1999, eq. 29, 250 to 850 nm.
double rayleigh_scattering(double nm);

// Refractivity n - 1 of standard air over that at 550 nm (Peck and Reeder 1972, eq. 2), 230 to 1690 nm.
double air_dispersion(double nm);

// Planck's law over its value at 560 nm.
double black_body(double kelvin, double nm);

}  // namespace airlight
