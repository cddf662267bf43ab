#pragma once
// The sun's position in the sky of a place, by ERFA (the IAU's SOFA routines under a free licence).

#include "core/sequence/civil_time.h"

namespace airlight::sequence {

// A place on WGS84. Latitude -90 to 90 and longitude -180 to 360 degrees, north and east positive; altitude in km.
struct Place {
  double latitude_deg = 0.0;
  double longitude_deg = 0.0;
  double altitude_km = 0.0;
};

// Direction of the disc's centre as seen from the place, parallax and aberration included.
struct SunAngles {
  double elevation_deg = 0.0;  // above the plane square to the ellipsoid's normal, without refraction
  double azimuth_deg = 0.0;    // clockwise from north, 0 to 360
};

// Earth from ERFA's epv00 (good to 1e-6 degrees) from 1900 to 2100, else from plan94 for the barycentre of Earth and
// Moon, whose distance from the Earth is 0.002 degrees at the sun; precession and nutation IAU 2006/2000B. UT1 is taken
// for UTC: up to 0.9 s or 0.004 degrees.
SunAngles sun_angles(Milliseconds utc, const Place& place);

struct MoonAngles {
  SunAngles at;
  double distance_km = 0.0;  // from the place
  double phase_deg = 0.0;    // as the preset's moon.phase_deg, seen from the Earth's centre
};

// The moon by ERFA's moon98 (Meeus, good to 0.003 degrees), its parallax with it.
MoonAngles moon_angles(Milliseconds utc, const Place& place);

double julian_date(Milliseconds utc);

struct Air {
  double pressure_hpa = 1010.0;
  double temperature_c = 10.0;
};

// Angle by which the air lifts the sun, degrees, at a true elevation: Saemundsson, Sky and Telescope 72 (1986) 70, as
// in Reda and Andreas, Solar Position Algorithm, NREL/TP-560-34302 (2003, revised 2008), eq. 42. As there, it is 0 for
// a disc wholly below the horizon (under -0.83 degrees).
double refraction_deg(double true_elevation_deg, const Air& air);

}  // namespace airlight::sequence
