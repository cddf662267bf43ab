#include "core/sequence/sun_position.h"

#include <erfa.h>
#include <erfam.h>

#include <cmath>

namespace airlight::sequence {
namespace {

constexpr double kUnixEpoch = 2440587.5;  // Julian date of 1970-01-01 00:00

// TT - UT, s: from leap seconds where they exist, else the mean course of history in Morrison and Stephenson, Journal
// for the History of Astronomy 35 (2004) 327. The sun moves 0.04 arc seconds in a second, so a rough value suffices.
double delta_t(Milliseconds utc) {
  constexpr double kTerrestrialMinusAtomic = 32.184;
  const CivilDate date = date_of(utc);
  double leap_seconds = 0.0;
  if (date.year >= 1972 && date.year <= 2050 && eraDat(date.year, date.month, date.day, 0.0, &leap_seconds) >= 0) {
    return leap_seconds + kTerrestrialMinusAtomic;
  }
  const double centuries = (date.year + (date.month - 0.5) / 12.0 - 1820.0) / 100.0;
  return -20.0 + 32.0 * centuries * centuries;
}

struct Earth {
  double from_sun[3];  // au, mean equator and equinox of J2000
  double velocity[3];  // au a day
};

// `tt`: days since kUnixEpoch.
Earth earth_at(double tt) {
  double heliocentric[2][3], barycentric[2][3];
  Earth earth{};
  if (eraEpv00(kUnixEpoch, tt, heliocentric, barycentric) == 0) {
    eraCp(heliocentric[0], earth.from_sun);
    eraCp(barycentric[1], earth.velocity);
    return earth;
  }
  constexpr int kEarthAndMoon = 3;
  (void)eraPlan94(kUnixEpoch, tt, kEarthAndMoon, heliocentric);  // a year outside 1000 to 3000 is only a warning
  eraCp(heliocentric[0], earth.from_sun);
  eraCp(heliocentric[1], earth.velocity);
  return earth;
}

// Vector from the Earth's centre to the apparent sun, m, J2000's axes. Aberration is applied; light time is part of the
// motion.
void apparent_sun(Earth earth, double out[3]) {
  double direction[3], seen[3], velocity[3], distance = 0.0;
  eraSxp(-1.0, earth.from_sun, direction);
  eraPn(direction, &distance, direction);
  eraSxp(ERFA_AULT / ERFA_DAYSEC, earth.velocity, velocity);  // in units of the speed of light
  const double speed = eraPm(velocity);
  eraAb(direction, velocity, distance, std::sqrt(1.0 - speed * speed), seen);
  eraSxp(distance * ERFA_DAU, seen, out);
}

}  // namespace

namespace {

struct Seen {
  SunAngles angles;
  double distance;  // m
};

// `at`: from the Earth's centre, m, J2000's axes; seen from the place.
Seen seen_from(const Place& place, Milliseconds utc, double at[3]) {
  const double ut1 = static_cast<double>(utc) / static_cast<double>(kDay);
  const double tt = ut1 + delta_t(utc) / ERFA_DAYSEC;
  double of_date[3], turned[3][3], observer[3];
  eraPnm00b(kUnixEpoch, tt, turned);
  eraRxp(turned, at, of_date);
  const double sidereal = eraGst06(kUnixEpoch, ut1, kUnixEpoch, tt, turned);
  double spin[3][3];
  eraIr(spin);
  eraRz(sidereal, spin);
  eraRxp(spin, of_date, at);  // now along the axes of the turning Earth

  const double longitude = place.longitude_deg * ERFA_DD2R;
  const double latitude = place.latitude_deg * ERFA_DD2R;
  constexpr int kWgs84 = 1;
  (void)eraGd2gc(kWgs84, longitude, latitude, 1000.0 * place.altitude_km, observer);  // fails for no place on Earth
  double from_here[3];
  eraPmp(at, observer, from_here);
  const double* const v = from_here;
  const double east = -std::sin(longitude) * v[0] + std::cos(longitude) * v[1];
  const double outward = std::cos(longitude) * v[0] + std::sin(longitude) * v[1];  // from the Earth's axis
  const double north = -std::sin(latitude) * outward + std::cos(latitude) * v[2];
  const double up = std::cos(latitude) * outward + std::sin(latitude) * v[2];
  return {{std::atan2(up, std::hypot(east, north)) * ERFA_DR2D, eraAnp(std::atan2(east, north)) * ERFA_DR2D},
          eraPm(from_here)};
}

double terrestrial_days(Milliseconds utc) {
  return static_cast<double>(utc) / static_cast<double>(kDay) + delta_t(utc) / ERFA_DAYSEC;
}

}  // namespace

SunAngles sun_angles(Milliseconds utc, const Place& place) {
  double sun[3];
  apparent_sun(earth_at(terrestrial_days(utc)), sun);
  return seen_from(place, utc, sun).angles;
}

MoonAngles moon_angles(Milliseconds utc, const Place& place) {
  double moon[2][3], sun[3], across[3], at[3];
  eraMoon98(kUnixEpoch, terrestrial_days(utc), moon);
  eraSxp(ERFA_DAU, moon[0], at);
  apparent_sun(earth_at(terrestrial_days(utc)), sun);
  // The moon waxes while it is east of the sun: the two then turn about the ecliptic's north.
  eraPxp(sun, at, across);
  const double obliquity = eraObl06(ERFA_DJ00, 0.0);
  const bool waxes = std::cos(obliquity) * across[2] - std::sin(obliquity) * across[1] > 0.0;
  double to_sun[3], to_earth[3];
  eraPmp(sun, at, to_sun);
  eraSxp(-1.0, at, to_earth);
  const double phase = eraSepp(to_sun, to_earth) * ERFA_DR2D;
  const Seen seen = seen_from(place, utc, at);
  return {seen.angles, seen.distance / 1000.0, waxes ? phase : -phase};
}

double julian_date(Milliseconds utc) {
  return kUnixEpoch + static_cast<double>(utc) / static_cast<double>(kDay);
}

double refraction_deg(double true_elevation_deg, const Air& air) {
  constexpr double kRadiusAndHorizon = 0.26667 + 0.5667;
  if (true_elevation_deg < -kRadiusAndHorizon) {
    return 0.0;
  }
  const double argument = (true_elevation_deg + 10.3 / (true_elevation_deg + 5.11)) * ERFA_DD2R;
  return air.pressure_hpa / 1010.0 * 283.0 / (273.0 + air.temperature_c) * 1.02 / (60.0 * std::tan(argument));
}

}  // namespace airlight::sequence
