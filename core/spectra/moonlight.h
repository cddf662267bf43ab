#pragma once
// The moon's light over the sun's, by its measured reflectance.

#include "core/spectra/curve.h"

namespace airlight {

inline constexpr double kMoonRadius = 1737.4;          // km
inline constexpr double kMeanMoonDistance = 384400.0;  // km

// Irradiance of the moon over that of the sun, above the air, both at one astronomical unit: the disc's reflectance by
// Kieffer and Stone, Astronomical Journal 129 (2005) 2887, eq. 10 and table 4, without libration. They measured from
// 1.55 to 97 degrees; beyond, their formula is continued. The reflectance of their 25 bands up to 1060 nm scatters by
// some percent, which no ground does: it is smoothed over neighbouring bands. `phase`: angle between sun and
// observer as the moon sees them, rad; negative while the moon wanes. `distance`: km.
Curve moonlight(double phase, double distance);

// Their reflectance of one band, by its number; 25 bands.
double lunar_reflectance(std::size_t band, double phase);
double lunar_band(std::size_t band);  // nm
inline constexpr std::size_t kLunarBands = 25;

// Radiance of the disc by the earth's light over its mean radiance by the sun's, at 549 nm. The earth is grey, its
// geometric albedo 0.434 (NASA's fact sheet), its phases those of a matte sphere; the moon reflects its light as it
// reflects the sun's when it is full. `phase`: of the moon.
double earthshine(double phase);

}  // namespace airlight
