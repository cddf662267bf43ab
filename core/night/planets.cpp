#include "core/night/planets.h"

#include <erfa.h>
#include <erfam.h>
#include <libnova/jupiter.h>
#include <libnova/mars.h>
#include <libnova/saturn.h>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <numbers>

#include "core/night/celestial.h"

namespace airlight {
namespace {

using physics::vec3;

constexpr double kDegrees = 180.0 / std::numbers::pi;

using Theory = void (*)(double, ln_helio_posn*);  // VSOP87: along J2000's ecliptic, degrees and au

struct Body {
  std::string_view name;
  int number;  // of plan94, from the sun
  double colour;
  Theory theory;  // null: plan94 will do
};
constexpr std::array<Body, 5> kBodies{{{"Mercury", 1, 0.97, nullptr},
                                       {"Venus", 2, 0.81, nullptr},
                                       {"Mars", 4, 1.36, ln_get_mars_helio_coords},
                                       {"Jupiter", 5, 0.83, ln_get_jupiter_helio_coords},
                                       {"Saturn", 6, 1.04, ln_get_saturn_helio_coords}}};

// From the sun, in au along J2000's equator and equinox.
vec3 heliocentric(const Body& body, double julian_date) {
  if (body.theory == nullptr) {
    double place[2][3];
    (void)eraPlan94(julian_date, 0.0, body.number, place);  // a year outside 1000 to 3000 is only a warning
    return {place[0][0], place[0][1], place[0][2]};
  }
  ln_helio_posn place{};
  {
    static std::mutex one_at_a_time;  // libnova keeps its last result in a variable
    const std::lock_guard lock(one_at_a_time);
    body.theory(julian_date, &place);
  }
  const vec3 v = direction_of(place.L / kDegrees, place.B / kDegrees) * place.R;
  constexpr double kObliquity = 84381.406 * ERFA_DAS2R;
  return {v.x, v.y * std::cos(kObliquity) - v.z * std::sin(kObliquity),
          v.y * std::sin(kObliquity) + v.z * std::cos(kObliquity)};
}

vec3 earth_at(double julian_date) {
  double from_sun[2][3], from_barycentre[2][3];
  (void)eraEpv00(julian_date, 0.0, from_sun, from_barycentre);  // outside 1900 to 2100 only a warning too
  return {from_sun[0][0], from_sun[0][1], from_sun[0][2]};
}

double polynomial(std::initializer_list<double> coefficients, double x) {
  double sum = 0.0;
  double power = 1.0;
  for (const double coefficient : coefficients) {
    sum += coefficient * power;
    power *= x;
  }
  return sum;
}

// Of a planet one au from the sun and from the earth. `phase`: degrees; `tilt`: sine of the earth's latitude over
// Saturn's rings.
double magnitude_at_one(int number, double phase, double tilt) {
  switch (number) {
    case 1:
      return polynomial({-0.613, 6.3280e-2, -1.6336e-3, 3.3644e-5, -3.4265e-7, 1.6893e-9, -3.0334e-12}, phase);
    case 2:
      return phase < 163.7 ? polynomial({-4.384, -1.044e-3, 3.687e-4, -2.814e-6, 8.938e-9}, phase)
                           : polynomial({236.05828, -2.81914, 8.39034e-3}, phase);
    case 4:
      return phase < 50.0 ? polynomial({-1.601, 2.267e-2, -1.302e-4}, phase)
                          : polynomial({-0.367, -2.573e-2, 3.445e-4}, phase);
    case 5:
      return polynomial({-9.395, -3.7e-4, 6.16e-4}, phase);
    default:
      return -8.914 - 1.825 * tilt + 0.026 * phase - 0.378 * tilt * std::exp(-2.25 * phase);
  }
}

PlanetInSky seen(const Body& body, double julian_date) {
  constexpr double kLightDays = ERFA_AULT / ERFA_DAYSEC;  // an au of light time
  const vec3 earth = earth_at(julian_date);
  vec3 planet = heliocentric(body, julian_date);
  for (int i = 0; i < 3; ++i) {
    planet = heliocentric(body, julian_date - kLightDays * physics::length(planet - earth));
  }
  const vec3 toward = planet - earth;
  const double distance = physics::length(toward);
  const double from_sun = physics::length(planet);
  const double cosine = physics::dot(planet, toward) / (distance * from_sun);
  const double phase = std::acos(std::clamp(cosine, -1.0, 1.0)) * kDegrees;
  const vec3 saturns_pole = direction_of(40.589 / kDegrees, 83.537 / kDegrees);
  const double tilt = std::abs(physics::dot(toward, saturns_pole)) / distance;
  const double magnitude = magnitude_at_one(body.number, phase, tilt) + 5.0 * std::log10(distance * from_sun);
  return {body.name, {toward / distance, magnitude, body.colour}};
}

}  // namespace

std::array<PlanetInSky, 5> planets_at(double julian_date) {
  std::array<PlanetInSky, 5> planets;
  std::ranges::transform(kBodies, planets.begin(), [&](const Body& body) { return seen(body, julian_date); });
  return planets;
}

}  // namespace airlight
