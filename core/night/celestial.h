#pragma once
// Where the stars' sky stands over a place at a time.

#include <array>

#include "core/physics/physics.h"

namespace airlight {

// Axes of the preset's frame, x east, y up, -z north, along the equator and equinox of J2000.
struct CelestialFrame {
  std::array<physics::vec3, 3> rows;  // take a J2000 vector to the frame
  physics::vec3 aberration{};         // the earth's velocity over that of light, J2000

  physics::vec3 from_j2000(const physics::vec3& v) const;
  physics::vec3 to_j2000(const physics::vec3& v) const;
  // The place of a star in the frame, aberration included; refraction is not.
  physics::vec3 apparent(const physics::vec3& star) const;
};

// Precession and sidereal time by IAU 2006 (Capitaine, Wallace and Chapront 2003), without nutation: good to 0.006
// degrees from 1600 to 2400. `julian_date`: UTC, taken for UT1; radians, east positive.
CelestialFrame celestial_frame(double julian_date, double latitude, double longitude);

// Ecliptic longitude of the sun, equinox of date, to 0.01 degrees for some centuries (Astronomical Almanac); radians.
double sun_longitude(double julian_date);

physics::vec3 direction_of(double longitude, double latitude);  // radians

}  // namespace airlight
