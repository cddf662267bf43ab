#include "app/cli/place_options.h"

namespace airlight::cli {

Option time_option(PlaceOptions& options) {
  return {"--time", "HH:MM", "Time of day, in the time zone of --tz", &options.time};
}

std::vector<Option> place_options(PlaceOptions& options, std::vector<Option> times) {
  const Range elevation_range{-0.5, 100.0};
  std::vector<Option> all = {
      {"--date", "YYYY-MM-DD", "Date in the Gregorian calendar, years 1600 to 2400", &options.date}};
  append(all, std::move(times));
  append(all,
         {{"--lat", "DEG", "Latitude of the place, positive to the north", &options.latitude, Completes::nothing,
           Range{-90.0, 90.0}},
          {"--lon", "DEG", "Longitude of the place, positive to the east", &options.longitude, Completes::nothing,
           Range{-180.0, 360.0}},
          {"--tz", "ZONE", "Time zone such as Europe/Paris, or an offset such as +02:00 (default: UTC)", &options.zone},
          {"--place-altitude", "KM",
           "Height of the place above the sea, for the sun's parallax (default: 0). It does not move the camera",
           &options.altitude, Completes::nothing, elevation_range},
          {"--refraction", "",
           "Lift the sun by the refraction of the air (Saemundsson 1986). The default is the true elevation",
           &options.refraction},
          {"--pressure", "HPA", "Air pressure for --refraction (default: 1010)", &options.pressure, Completes::nothing,
           Range{0.0, 2000.0}},
          {"--temperature", "CELSIUS", "Air temperature for --refraction (default: 10)", &options.temperature,
           Completes::nothing, Range{-200.0, 200.0}}});
  return grouped("Sun of a place", std::move(all));
}

}  // namespace airlight::cli
