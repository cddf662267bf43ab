#include "core/night/celestial.h"

#include <cmath>
#include <numbers>

namespace airlight {
namespace {

using physics::vec3;
using SkyRotation = std::array<vec3, 3>;

constexpr double kJ2000 = 2451545.0;
constexpr double kDegreeOfSky = std::numbers::pi / 180.0;
constexpr double kArcSecond = kDegreeOfSky / 3600.0;
constexpr double kEclipticTilt = 84381.406 * kArcSecond;

vec3 turned(const SkyRotation& r, const vec3& v) {
  return {physics::dot(r[0], v), physics::dot(r[1], v), physics::dot(r[2], v)};
}

SkyRotation product(const SkyRotation& a, const SkyRotation& b) {
  SkyRotation out;
  for (std::size_t i = 0; i < 3; ++i) {
    out[i] = b[0] * a[i].x + b[1] * a[i].y + b[2] * a[i].z;
  }
  return out;
}

// Of the axes, about z and y.
SkyRotation about_z(double angle) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  return {vec3(c, s, 0.0), vec3(-s, c, 0.0), vec3(0.0, 0.0, 1.0)};
}

SkyRotation about_y(double angle) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  return {vec3(c, 0.0, -s), vec3(0.0, 1.0, 0.0), vec3(s, 0.0, c)};
}

SkyRotation precession(double t) {
  const double zeta = 2.650545 + t * (2306.083227 + t * (0.2988499 + t * 0.01801828));
  const double z = -2.650545 + t * (2306.077181 + t * (1.0927348 + t * 0.01826837));
  const double theta = t * (2004.191903 + t * (-0.4294934 + t * -0.04182264));
  return product(about_z(-z * kArcSecond), product(about_y(theta * kArcSecond), about_z(-zeta * kArcSecond)));
}

double sidereal_time(double julian_date, double t) {
  const double days = julian_date - kJ2000;
  const double turns = 0.7790572732640 + 0.00273781191135448 * days + std::fmod(days, 1.0);
  return 2.0 * std::numbers::pi * turns + (0.014506 + t * (4612.156534 + t * 1.3915817)) * kArcSecond;
}

}  // namespace

vec3 direction_of(double longitude, double latitude) {
  return {std::cos(latitude) * std::cos(longitude), std::cos(latitude) * std::sin(longitude), std::sin(latitude)};
}

double sun_longitude(double julian_date) {
  const double days = julian_date - kJ2000;
  const double anomaly = (357.528 + 0.9856003 * days) * kDegreeOfSky;
  return (280.460 + 0.9856474 * days + 1.915 * std::sin(anomaly) + 0.020 * std::sin(2.0 * anomaly)) * kDegreeOfSky;
}

CelestialFrame celestial_frame(double julian_date, double latitude, double longitude) {
  const double t = (julian_date - kJ2000) / 36525.0;
  const SkyRotation meridian = product(about_z(sidereal_time(julian_date, t) + longitude), precession(t));
  const double c = std::cos(latitude);
  const double s = std::sin(latitude);
  const vec3 east = meridian[1];
  const vec3 up = meridian[0] * c + meridian[2] * s;
  const vec3 north = meridian[2] * c - meridian[0] * s;
  constexpr double kAberration = 20.49552 * kArcSecond;
  const double sun = sun_longitude(julian_date) - t * 5029.0 * kArcSecond;
  return {{east, up, -north},
          vec3(std::sin(sun), -std::cos(sun) * std::cos(kEclipticTilt), -std::cos(sun) * std::sin(kEclipticTilt)) *
              kAberration};
}

vec3 CelestialFrame::from_j2000(const vec3& v) const {
  return turned(rows, v);
}

vec3 CelestialFrame::to_j2000(const vec3& v) const {
  return rows[0] * v.x + rows[1] * v.y + rows[2] * v.z;
}

vec3 CelestialFrame::apparent(const vec3& star) const {
  return from_j2000(physics::normalize(physics::normalize(star) + aberration));
}

}  // namespace airlight
