#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "core/scene/angle.h"
#include "core/scene/json_format.h"
#include "core/scene/readers.h"

namespace airlight {
namespace {

using std::numbers::pi;

// East, up, south.
using Vector = std::array<double, 3>;

Vector toward(double elevation, double azimuth) {
  return {std::cos(elevation) * std::sin(azimuth), std::sin(elevation), -std::cos(elevation) * std::cos(azimuth)};
}

double dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// Angle between sun and camera as the moon sees them: the sun is 389 times as far away as the moon.
double phase_by(const Vector& moon, const Vector& sun, double distance) {
  constexpr double kSunDistance = 149597870.7;  // km
  const double apart = std::acos(std::clamp(dot(moon, sun), -1.0, 1.0));
  return std::atan2(kSunDistance * std::sin(apart), distance - kSunDistance * std::cos(apart));
}

// Where the sun lies from the moon, as seen from the camera, from straight up to the left.
double limb_by(const Moon& moon, const Vector& sun) {
  const Vector up = toward(moon.elevation + 0.5 * pi, moon.azimuth);
  const Vector left = toward(0.0, moon.azimuth - 0.5 * pi);
  return std::atan2(dot(sun, left), dot(sun, up));
}

// Whether the moon's disc touches the shadow that the planet throws away from the sun. It is 0.71 degrees in radius
// there, seen from the planet's centre; the moon's is 0.26.
bool is_eclipsed(const Moon& moon, const Sun& sun, const Planet& planet) {
  constexpr double kShadowAndMoon = 0.97;  // degrees
  Vector from_centre = toward(moon.elevation, moon.azimuth);
  std::ranges::transform(from_centre, from_centre.begin(), [&](double x) { return x * moon.distance; });
  from_centre[1] += planet.ground_radius;
  const double behind = -dot(from_centre, toward(sun.elevation, sun.azimuth));
  const double beside = std::sqrt(std::max(dot(from_centre, from_centre) - behind * behind, 0.0));
  return behind > 0.0 && std::atan2(beside, behind) < radians_from_degrees(kShadowAndMoon);
}

double read_phase(const Section& section, double by_sun) {
  const PresetValue* const degrees = section.find("phase_deg");
  const PresetValue* const share = section.find("illuminated");
  if (degrees != nullptr && share != nullptr) {
    section.complain("illuminated", *share, "`phase_deg` says the same in another way; give one of the two");
  }
  if (degrees != nullptr) {
    return radians_from_degrees(section.number("phase_deg"));
  }
  return share == nullptr ? by_sun : std::acos(2.0 * section.number("illuminated") - 1.0);
}

}  // namespace

std::optional<Moon> read_moon(const Section& root, const Scene& scene) {
  const PresetValue* const value = root.find("moon");
  if (value == nullptr) {
    return std::nullopt;
  }
  const Section section = root.child("moon");
  section.refuse_unknown_keys();
  Moon moon;
  section.fill(moon);
  const Vector sun = toward(scene.sun.elevation, scene.sun.azimuth);
  moon.lit.phase = read_phase(section, phase_by(toward(moon.elevation, moon.azimuth), sun, moon.distance));
  moon.lit.bright_limb = section.find("bright_limb_deg") != nullptr
                             ? radians_from_degrees(section.number("bright_limb_deg"))
                             : limb_by(moon, sun);
  constexpr double kFullestSeen = 2.0;  // degrees
  if (std::abs(moon.lit.phase) < radians_from_degrees(kFullestSeen) && is_eclipsed(moon, scene.sun, scene.planet)) {
    root.complain(
        "moon", *value,
        "the full moon stands in the planet's shadow, and a lunar eclipse is not modelled; move it or the sun "
        "by a degree");
  }
  moon.over_sun = moonlight(moon.lit.phase, moon.distance);
  moon.lit.earthshine = earthshine(moon.lit.phase);
  return moon;
}

std::optional<NightSky> read_night_sky(const Section& root) {
  if (root.find("night_sky") == nullptr) {
    return std::nullopt;
  }
  const Section section = root.child("night_sky");
  section.refuse_unknown_keys();
  NightSky sky;
  section.fill(sky);
  return sky;
}

std::optional<Stars> read_stars(const Section& root) {
  if (root.find("stars") == nullptr) {
    return std::nullopt;
  }
  const Section section = root.child("stars");
  section.refuse_unknown_keys();
  Stars stars;
  section.fill(stars);
  return stars;
}

void cover_the_sun(Sun& sun, const Moon& moon) {
  const double angular_radius = std::asin(kMoonRadius / moon.distance);
  const Vector to_sun = toward(sun.elevation, sun.azimuth);
  const Vector to_moon = toward(moon.elevation, moon.azimuth);
  Vector chord{};
  std::ranges::transform(to_sun, to_moon, chord.begin(), std::minus());
  // So small an angle's cosine has few digits left.
  const double apart = 2.0 * std::asin(std::min(0.5 * std::sqrt(dot(chord, chord)), 1.0));
  if (apart < sun.disc.angular_radius + angular_radius) {
    sun.disc.cover = DiscCover{moon.elevation, moon.azimuth, angular_radius};
    sun.uncovered = uncovered_share(sun.disc.angular_radius, sun.disc.limb_darkening, angular_radius, apart);
  }
}

double uncovered_share(double radius, double limb_darkening, double cover_radius, double apart) {
  if (cover_radius >= radius + apart) {
    return 0.0;
  }
  constexpr int kRings = 2000;
  double all = 0.0;
  double seen = 0.0;
  for (int i = 0; i < kRings; ++i) {
    const double x = (i + 0.5) / kRings;
    const double ring = x * radius;
    const double light = x * (1.0 - limb_darkening * (1.0 - std::sqrt(1.0 - x * x)));
    // Half the angle under which the ring's covered part is seen from the disc's centre.
    const double inside = ring * ring + apart * apart - cover_radius * cover_radius;
    const double cosine = apart > 0.0 ? inside / (2.0 * ring * apart) : std::copysign(2.0, inside);
    all += light;
    seen += light * (1.0 - std::acos(std::clamp(cosine, -1.0, 1.0)) / pi);
  }
  return seen / all;
}

Spectrum moon_irradiance(const Moon& moon, const Sun& sun, const BandColours& colours) {
  std::array<double, kFineBands> over_sun{};
  std::ranges::transform(fine_bands(), over_sun.begin(),
                         [&](const WaveBand& band) { return mean_over(moon.over_sun, band.low, band.high); });
  const Rgb moonlight = colour_of(colours, over_sun);
  const Rgb sunlight = sun_colour(colours);
  Spectrum irradiance = sun.irradiance;
  for (std::size_t c = 0; c < 3; ++c) {
    irradiance[c] *= moonlight[c] / sunlight[c];
  }
  return irradiance;
}

}  // namespace airlight
