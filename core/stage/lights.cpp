#include "core/stage/lights.h"

#include <algorithm>
#include <cmath>

#include "core/scene/angle.h"
#include "core/scene/photometry.h"

namespace airlight {
namespace {

constexpr double kLow = 5.0;    // km
constexpr double kLost = 1e-3;  // of a pixel

// Vertical optical depth above an altitude that scatters light by an angle, per steradian; each medium's in the channel
// where it is largest.
double scattering_above(const Air& air, double altitude, double angle) {
  physics::Physics p = air.formulas();
  const auto phases = p.phases(std::cos(angle));
  constexpr int kSteps = 128;
  const double width = (air.planet().atmosphere_height - altitude) / kSteps;
  double sum = 0.0;
  for (int i = 0; i < kSteps && width > 0.0; ++i) {
    for (physics::uint medium = 0; medium < p.medium_count(); ++medium) {
      const physics::vec3 scattering = p.medium_scattering(medium, altitude + (i + 0.5) * width, 0.0);
      const physics::vec3 turned = scattering * phases.of[medium];
      sum += width * std::max({turned.x, turned.y, turned.z});
    }
  }
  return sum;
}

double luminance(const physics::vec3& rgb) {
  return bt709_luminance(rgb.x, rgb.y, rgb.z);
}

bool sun_is_seen(const Stage& stage) {
  const Scene& scene = stage.scene();
  const Planet& planet = scene.planet;
  const auto dip = [&](double altitude) { return std::acos(planet.ground_radius / (planet.ground_radius + altitude)); };
  const double below = -scene.sun.elevation - dip(std::max(scene.camera.altitude, 0.0));
  if (!scene.night_sky || stage.others().empty() || below < 2.0 * dip(planet.atmosphere_height)) {
    return true;
  }
  constexpr double kDarkest = 0.3;  // of the airglow at the zenith
  const double twilight = bt709_luminance(scene.sun.irradiance) * deep_twilight(stage.whole().air, below);
  return twilight >= kLost * kDarkest * luminance(stage.night()->airglow);
}

bool others_are_seen(const Stage& stage) {
  const Scene& scene = stage.scene();
  constexpr double kDay = 10.0 * kDegree;
  // Of irradiance times the depth that scatters: the darkest sky by day, and the brightest around a light.
  constexpr double kDarkest = 0.02;
  constexpr double kBrightest = 1.0;
  const double day = scene.sun.uncovered * bt709_luminance(scene.sun.irradiance) * kDarkest;
  return scene.sun.elevation < kDay || std::ranges::any_of(stage.others(), [&](const Stage& other) {
           return kBrightest * bt709_luminance(other.scene().sun.irradiance) >= kLost * day;
         });
}

}  // namespace

double deep_twilight(const Air& air, double below) {
  constexpr double kFactor = 6e-3;
  const double altitude = air.planet().ground_radius * (1.0 / std::cos(0.25 * below) - 1.0);
  const double depth = scattering_above(air, altitude, 0.5 * below);
  return kFactor * depth * depth;
}

LightsSeen lights_seen(const Stage& stage) {
  const Scene& scene = stage.scene();
  if (scene.camera.altitude > kLow || !scene.clouds.empty()) {
    return {};
  }
  return {sun_is_seen(stage), others_are_seen(stage)};
}

Scene by_moonlight(const Scene& scene) {
  const Moon& moon = *scene.moon;
  Scene lit = scene;
  lit.moon.reset();
  lit.night_sky.reset();
  lit.stars.reset();
  lit.sun = {.elevation = moon.elevation,
             .azimuth = moon.azimuth,
             .irradiance = moon.irradiance,
             .unit = scene.sun.unit,
             .disc = {.visible = scene.sun.disc.visible,
                      .angular_radius = std::asin(kMoonRadius / moon.distance),
                      .limb_darkening = 0.0,
                      .radiance_scale = 1.0,
                      .lit = moon.lit}};
  if (lit.spectra) {
    lit.spectra->light = moon.over_sun;
  }
  return lit;
}

}  // namespace airlight
