#pragma once
// Place on Earth and date: the options that determine the sun's position.

#include <optional>
#include <string>
#include <vector>

#include "app/cli/cli.h"
#include "app/cli/scene_options.h"
#include "core/sequence/sun_position.h"

namespace airlight::cli {

struct PlaceOptions {
  std::optional<std::string> date;
  std::optional<std::string> time;  // for one picture
  std::optional<std::string> zone;
  std::optional<double> latitude;
  std::optional<double> longitude;
  std::optional<double> altitude;
  bool refraction = false;
  std::optional<double> pressure;
  std::optional<double> temperature;
};

// --date, then `times`, then --lat, --lon, --tz, --place-altitude, --refraction, --pressure, --temperature.
std::vector<Option> place_options(PlaceOptions& options, std::vector<Option> times);
// The option for a single picture.
Option time_option(PlaceOptions& options);

// Both throw InputError; `command`: "render".
sequence::Place place_of(const PlaceOptions& options);
std::optional<sequence::Air> air_of(const PlaceOptions& options, const std::string& command);

// Refuses --refraction where the scene's own air bends light: the sun would be lifted twice.
void require_one_refraction(const PlaceOptions& options, const Scene& scene, const std::string& command);

// The sun of one picture; empty where no option concerns it. Throws InputError.
std::vector<Override> sun_overrides(const PlaceOptions& options, const SceneOptions& scene, const std::string& command);

}  // namespace airlight::cli
