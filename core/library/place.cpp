#include "core/library/place.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/methods/ready.h"
#include "core/scene/angle.h"
#include "core/scene/density_column.h"
#include "core/scene/json_format.h"
#include "core/scene/photometry.h"
#include "core/sequence/frame_list.h"

namespace airlight {

sequence::Place place_of(const PlaceOptions& options) {
  return {options.latitude.value_or(0.0), options.longitude.value_or(0.0), options.altitude.value_or(0.0)};
}

std::optional<sequence::Air> air_of(const PlaceOptions& options, const std::string& command) {
  if (!options.refraction) {
    if (options.pressure || options.temperature) {
      throw InputError(command +
                       ": --pressure and --temperature belong to --refraction; give it too, or leave them out");
    }
    return std::nullopt;
  }
  const sequence::Air standard;
  return sequence::Air{options.pressure.value_or(standard.pressure_hpa),
                       options.temperature.value_or(standard.temperature_c)};
}

void require_one_refraction(const PlaceOptions& options, const Scene& scene, const std::string& command) {
  if (options.refraction && bends_light(scene)) {
    throw InputError(command +
                     ": --refraction: the preset's air bends light itself (planet.refraction); leave one out");
  }
}

namespace {

// The sections of which the preset must have one for a date to set this key; none: it sets it in any.
std::vector<std::string> sections_with(const std::string& pointer) {
  if (pointer.starts_with("/moon/")) {
    return {"moon"};
  }
  return pointer.starts_with("/camera/") ? std::vector<std::string>{"night_sky", "stars"} : std::vector<std::string>();
}

}  // namespace

std::vector<Override> sky_of_date(const std::string& typed) {
  std::vector<Override> all;
  for (const std::string section : {"moon", "night_sky", "stars"}) {
    all.push_back({.assignment = "/" + section + "={}", .typed = typed, .adds = section});
  }
  return all;
}

namespace {

// Whether a light that a date adds can be seen in one picture: with the sun up the smooth light of the night adds at
// most 5e-6 to the sky of `earth`, and a moon so far below the horizon, `dip` degrees below the level, lights nothing.
bool is_seen(const std::string& section, double sun_degrees, double moon_degrees, double dip) {
  constexpr double kMoonDown = -10.0;
  if (section == "night_sky") {
    return sun_degrees <= 0.0;
  }
  return section != "moon" || moon_degrees > kMoonDown - dip;
}

double horizon_dip(double altitude, double radius) {
  return degrees_from_radians(std::acos(radius / (radius + std::max(altitude, 0.0))));
}

double number_in(Preset& preset, const char* section, const char* key, double otherwise) {
  const auto* number = member_as<double>(member(&preset.root, section), key);
  return number == nullptr ? otherwise : *number;
}

constexpr double kEarthRadius = 6360.0;  // km

}  // namespace

void leave_out_unseen(Preset& preset) {
  const double sun = number_in(preset, "sun", "elevation_deg", 0.0);
  const double moon = number_in(preset, "moon", "elevation_deg", 0.0);
  const double dip = horizon_dip(number_in(preset, "camera", "altitude_km", 0.0),
                                 number_in(preset, "planet", "ground_radius_km", kEarthRadius));
  std::erase_if(std::get<PresetObject>(preset.root.data), [&](const auto& section) {
    const bool may_go =
        section.first == "moon" || (section.first == "night_sky" && section.second.source.starts_with("--date "));
    return may_go && !is_seen(section.first, sun, moon, dip);
  });
}

void leave_out_outshone(Scene& scene) {
  if (!scene.night_sky || scene.sun.elevation <= 0.0) {
    return;
  }
  constexpr double kLow = 5.0;              // km: above it the sky darkens
  constexpr double kBrightestNight = 2e-3;  // cd/m2, airglow at the horizon or the Milky Way
  constexpr double kDarkestDay = 3e-3;      // of irradiance times the depth that scatters, the sun at the horizon
  constexpr double kLost = 1e-4;
  double depth = 0.0;
  for (const Medium& medium : scene.media) {
    depth += std::ranges::min(medium.scattering) * density_column(medium.density, scene.planet.atmosphere_height);
  }
  const NightSky& sky = *scene.night_sky;
  const double night = kBrightestNight * std::max({sky.airglow, sky.zodiacal, sky.starlight}) + sky.light_pollution;
  const double day = kDarkestDay * std::min(depth, 1.0) * scene.sun.uncovered * luminance_of_one(scene) *
                     bt709_luminance(scene.sun.irradiance);
  if (scene.camera.altitude <= kLow && scene.clouds.empty() && night < kLost * day) {
    scene.night_sky.reset();
  }
}

std::vector<Override> sun_overrides(const PlaceOptions& options, const SceneChanges& changes,
                                    const std::string& command) {
  const std::optional<sequence::Air> air = air_of(options, command);
  if (!options.date && !options.time && !options.zone && !options.latitude && !options.longitude && !options.altitude &&
      !air) {
    return {};
  }
  std::string missing;
  const auto need = [&](bool given, const char* name) {
    missing += given ? "" : (missing.empty() ? "" : ", ") + std::string(name);
  };
  need(options.date.has_value(), "--date");
  need(options.time.has_value(), "--time");
  need(options.latitude.has_value(), "--lat");
  need(options.longitude.has_value(), "--lon");
  if (!missing.empty()) {
    throw InputError(command + ": the sun of a place needs " + missing +
                     " as well; write for example --date 2026-06-21 --time 12:00 --lat 48.85 --lon 2.35 --tz "
                     "Europe/Paris");
  }
  if (changes.sun_elevation || changes.sun_azimuth) {
    throw InputError(command + ": " + (changes.sun_elevation ? "--sun-elevation" : "--sun-azimuth") +
                     " and --date both say where the sun stands; give one");
  }
  sequence::SunPath moment = sequence::make_moment(
      {*options.date, *options.time, {}, {}, options.zone.value_or("UTC"), place_of(options), air}, command);
  moment.moon = true;
  moment.stars = true;
  const std::string typed = "--date " + *options.date + " --time " + *options.time;
  const sequence::Frame frame = sequence::frame_at(moment, 0);
  std::vector<Override> all = sky_of_date(typed);
  for (const auto& [pointer, values] : frame.keys) {
    all.push_back({pointer + "=" + format_number(values.front()), typed, sections_with(pointer)});
  }
  return all;
}

}  // namespace airlight
