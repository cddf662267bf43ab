#pragma once
// Place on Earth and date: the options that determine the sun's position.

#include <vector>

#include "app/cli/cli.h"
#include "core/library/place.h"

namespace airlight::cli {

// --date, then `times`, then --lat, --lon, --tz, --place-altitude, --refraction, --pressure, --temperature.
std::vector<Option> place_options(PlaceOptions& options, std::vector<Option> times);
// The option for a single picture.
Option time_option(PlaceOptions& options);

}  // namespace airlight::cli
