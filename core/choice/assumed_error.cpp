#include "core/choice/assumed_error.h"

#include <algorithm>
#include <cmath>

#include "core/methods/scene_air.h"

namespace airlight::choice {
namespace {

constexpr double kDegree = 0.017453292519943295;
constexpr double kLowSun = kDegree;  // elevation

bool is_day(const Scene& scene) {
  return scene.sun.elevation >= kLowSun;
}

// The angle that the horizon falls by to the top of the air, Earth's 10 degrees: what a table knows of dusk stands as
// far apart whatever the planet, and on one a hundred times as large all of dusk falls between two of its suns.
bool dusk_is_resolved(const Planet& planet, double widest) {
  const double dusk = std::acos(planet.ground_radius / (planet.ground_radius + planet.atmosphere_height));
  return dusk > 4.0 * kDegree && dusk < widest * kDegree;
}

}  // namespace

// By the references of tests/truth: 0.2 to 0.3 % over black ground, up to 0.6 % over snow and 2 % in twilight over it,
// 1 to 1.3 % in haze.
double common_error(const Scene& scene) {
  const Spectrum& spectrum = scene.planet.ground_albedo;
  const double albedo = std::max({spectrum[0], spectrum[1], spectrum[2]});
  const OpticalDepths depths = air_of(scene).depths();
  return 0.003 + (is_day(scene) ? 0.0045 : 0.0195) * albedo + 0.012 * std::min(1.0, depths.peaked / 0.04) +
         0.05 * depths.peaked + 0.03 * std::min(1.0, depths.abrupt / 0.1);
}

std::optional<double> plain_reference_error(const Scene& scene) {
  constexpr double kThick = 0.05;  // by day
  const double scattering = air_of(scene).depths().scattering;
  if (is_day(scene) && scattering <= 0.6) {
    return 0.001 + common_error(scene);
  }
  if (is_day(scene) && dusk_is_resolved(scene.planet, 30.0)) {
    return std::max(kThick, common_error(scene));
  }
  if (scene.sun.elevation >= -7.0 * kDegree && scattering <= 0.4 && dusk_is_resolved(scene.planet, 30.0)) {
    return 0.009 + common_error(scene);
  }
  return std::nullopt;
}

std::optional<double> default_error(const Scene& scene) {
  constexpr double kBesideTheTop = 0.8;  // of the air's height: there the horizon's row of the table is a grazing ray's
  constexpr double kTable = 0.002;
  const double height = scene.camera.altitude / scene.planet.atmosphere_height;
  const bool has_phase_table =
      std::ranges::any_of(scene.media, [](const Medium& medium) { return medium.phase == PhaseFunction::table; });
  if (scene.spectra || scene.terrain || has_phase_table) {
    return std::nullopt;  // none of the scenes that this was fitted to
  }
  if (!is_day(scene) || !dusk_is_resolved(scene.planet, 14.0) || (height > kBesideTheTop && height <= 1.0)) {
    return std::nullopt;
  }
  const std::optional<double> plain = plain_reference_error(scene);
  return plain ? std::optional(*plain + kTable) : std::nullopt;
}

}  // namespace airlight::choice
