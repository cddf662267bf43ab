#pragma once
// The stars that the eye sees, as facts.

#include <string_view>
#include <vector>

#include "core/physics/physics.h"

namespace airlight {

inline constexpr double kFaintestStar = 6.5;

struct CatalogueStar {
  physics::vec3 j2000;
  double magnitude = 0.0;  // V
  double colour = 0.0;     // B - V
  physics::vec3 motion{};  // J2000, rad a year
};

// The stars up to magnitude 6.5, brightest first: places for J2000, V and B - V of Hipparcos, as d3-celestial (O.
// Frohn, BSD-3-Clause) has them; a missing B - V is 0.6. Seventeen swift or bright ones have their proper motion; the
// others stand still.
const std::vector<CatalogueStar>& bright_stars();

// Its place at a date, aberration and precession left out; not quite of length 1.
physics::vec3 place_at(const CatalogueStar& star, double julian_date);

// The star's own name by the International Astronomical Union, of the brightest; else empty.
std::string_view star_name(const CatalogueStar& star);

std::vector<CatalogueStar> read_stars(std::string_view table);

// The lines of core/night/stars.txt, embedded at build time: right ascension and declination in 1e-4 degrees, V and
// B - V in hundredths of a magnitude.
std::string_view star_table();

// Temperature of the black body of that colour, K (Ballesteros, Europhysics Letters 97 (2012) 34008).
double star_temperature(double colour);

// Illuminance above the air, lux: the sun's magnitude is -26.76, its illuminance 128 000.
double star_illuminance(double magnitude);

}  // namespace airlight
