#include "core/choice/assumed_error.h"

#include <algorithm>
#include <cmath>

#include "core/methods/ready.h"
#include "core/scene/angle.h"
#include "core/scene/thing_kinds.h"

namespace airlight::choice {
namespace {

constexpr double kLowSun = kDegree;  // elevation

bool is_day(const Scene& scene) {
  return scene.sun.elevation >= kLowSun;
}

// The albedo in the brightest channel. With spectra the channels stand for three wavelengths, where most of the colour
// comes from.
double brightest_ground(const Scene& scene) {
  return std::ranges::max(scene.planet.ground_albedo);
}

// The altitude above which a thousandth of all scattering is left.
double scattering_height(const Air& air) {
  constexpr double kLeft = 0.001;
  const Column& column = air.column();
  std::vector<double> strength;
  double total = 0.0;
  for (std::size_t m = 0; m < air.media().size(); ++m) {
    strength.push_back(std::ranges::max(air.media()[m].scattering));
    total += strength.back() * column.amount[m];
  }
  double above = 0.0;
  std::size_t cell = column.cells();
  while (cell > 0 && above < kLeft * total) {
    --cell;
    for (std::size_t m = 0; m < strength.size(); ++m) {
      above += strength[m] * column.density[cell][m] * column.width(cell);
    }
  }
  return column.edges[cell];
}

// The angle by which the horizon falls from the ground up to an altitude.
double dip(const Planet& planet, double altitude) {
  return std::acos(planet.ground_radius / (planet.ground_radius + altitude));
}

// Whether the table of moments has enough suns in dusk. Dusk is as wide as the horizon's dip up to the top of what
// scatters, on Earth 7 degrees; the table's suns stand as far apart on every planet, and on one a hundred times as
// large all of dusk falls between two of them.
bool dusk_is_resolved(const Stage& stage, double widest) {
  const Planet& planet = stage.scene().planet;
  return dip(planet, scattering_height(stage.whole().air)) > 4.0 * kDegree &&
         dip(planet, planet.atmosphere_height) < widest * kDegree;
}

// The error of rendering at `auto` or more wavelengths instead of all: core/SPECTRA.md has 0.1 to 0.45 % over clear
// and dusty skies with the sun above -4 degrees. Nothing is known of fewer.
std::optional<double> wavelengths_error(const Stage& stage) {
  const Scene& scene = stage.scene();
  if (!scene.spectra) {
    return 0.0;
  }
  if (scene.spectra->wavelengths > 0) {
    Scene by_itself = scene;
    by_itself.spectra->wavelengths = 0;
    if (static_cast<std::size_t>(scene.spectra->wavelengths) < ready(by_itself, stage).basis().nodes.nm.size()) {
      return std::nullopt;
    }
  }
  return 0.001 + 0.008 * std::min(1.0, stage.whole().air.depths().scattering);
}

// Whether phase functions are as peaked as those of tests/truth and core/SPECTRA.md: mean cosines from -0.3 to 0.82. By
// backward peaks, and by sharper ones, `orders` is 2 to 35 % off random scenes.
bool peaks_are_familiar(const Air& air) {
  for (std::size_t i = 0; i < air.media().size(); ++i) {
    const physics::vec3& cosine = air.formulas().scene.media[i].legendre[1];
    const bool scatters = std::ranges::max(air.media()[i].scattering) > 0.0;
    if (scatters &&
        (std::min({cosine.x, cosine.y, cosine.z}) < -0.3 || std::max({cosine.x, cosine.y, cosine.z}) > 0.82)) {
      return false;
    }
  }
  return true;
}

bool is_beside_the_top(const Scene& scene) {
  // Of the air's height: there the horizon's row of the table is a grazing ray's.
  constexpr double kFrom = 0.8;
  constexpr double kTo = 1.01;
  const double height = scene.camera.altitude / scene.planet.atmosphere_height;
  return height > kFrom && height < kTo;
}

// The error that every reference has, however fine its tables: harmonics above the degree are missing. By the
// references of tests/truth and the scenes of core/SPECTRA.md: 0.2 to 0.3 % in clear air over dark ground, up to 0.7 %
// over snow and 2 % in twilight over it, 0.4 to 1.2 % in haze and dust.
double common_error(const Stage& stage) {
  const Scene& scene = stage.scene();
  const Air& air = stage.whole().air;
  const OpticalDepths depths = air.depths();
  const double some = std::min(1.0, depths.peaked / 0.04);
  const double peaks =
      peaks_are_familiar(air) ? 0.001 * some + 0.01 * depths.peaked : 0.0015 + 0.012 * some + 0.05 * depths.peaked;
  return 0.0015 + (is_day(scene) ? 0.0045 : 0.0195) * brightest_ground(scene) + peaks +
         0.03 * std::min(1.0, depths.abrupt / 0.1);
}

}  // namespace

std::optional<double> plain_reference_error(const Stage& stage) {
  constexpr double kThick = 0.05;  // by day
  const Scene& scene = stage.scene();
  const Air& air = stage.whole().air;
  const OpticalDepths depths = air.depths();
  const double scattering = depths.scattering;
  if (stand_at_true_distance(scene) || !peaks_are_familiar(air) || is_beside_the_top(scene)) {
    return std::nullopt;
  }
  if (is_day(scene) && scattering <= (depths.abrupt > 0.0 ? 0.6 : 1.0)) {
    return 0.0005 + common_error(stage);
  }
  if (is_day(scene) && dusk_is_resolved(stage, 30.0)) {
    return std::max(kThick, common_error(stage));
  }
  const bool some_is_lit = scene.sun.elevation > -dip(scene.planet, scattering_height(air));
  if (scene.sun.elevation >= -7.0 * kDegree && some_is_lit && scattering <= 0.4 && dusk_is_resolved(stage, 30.0)) {
    return 0.009 + common_error(stage);
  }
  return std::nullopt;
}

std::optional<double> default_error(const Stage& stage) {
  const Scene& scene = stage.scene();
  constexpr double kTable = 0.001;
  constexpr double kTableAtDusk = 0.011;
  constexpr double kLowestSun = -4.0 * kDegree;  // below it 5.6 % was seen over bright ground
  const std::optional<double> wavelengths = wavelengths_error(stage);
  const std::optional<double> plain = plain_reference_error(stage);
  if (scene.sun.elevation < kLowestSun || !dusk_is_resolved(stage, 14.0) || !wavelengths || !plain) {
    return std::nullopt;
  }
  return *plain + (is_day(scene) ? kTable : kTableAtDusk) + *wavelengths;
}

}  // namespace airlight::choice
