#include "app/sequence/wind.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <variant>
#include <vector>

#include "core/base/error.h"
#include "core/scene/json_format.h"
#include "core/scene/rules.h"

namespace airlight::cli {
namespace {

// The preset's numbers of the scene's clouds: a layer is a cloud of the preset, but not of the scene.
std::vector<std::size_t> numbers_in_preset(const Preset& preset) {
  std::vector<std::size_t> numbers;
  const auto* clouds = member_as<PresetArray>(&preset.root, "clouds");
  for (std::size_t i = 0; clouds != nullptr && i < clouds->size(); ++i) {
    const auto* type = member_as<std::string>(&(*clouds)[i], "type");
    if (type != nullptr && *type != kCloudNames[kCloudLayer]) {
      numbers.push_back(i);
    }
  }
  return numbers;
}

std::array<double, 2> period_of(const Cloud& cloud) {
  if (cloud.kind != CloudKind::volume) {
    return {cloud.period, cloud.period};
  }
  if (!cloud.repeats) {
    return {};
  }
  return {cloud.contents->nx * cloud.contents->dx, cloud.contents->ny * cloud.contents->dy};
}

// A cloud that stands alone is farthest away in the last frame or in the first, where the preset's rule holds; one that
// repeats itself goes half a period to each side.
void refuse_too_far(const sequence::Wind& wind, double seconds, const std::string& place) {
  constexpr double kMost = 1000.0;  // km, of clouds[].east_km and north_km
  constexpr double kMetresInKm = 1e3;
  for (std::size_t i = 0; i < 2; ++i) {
    const double way = wind.speed.at(i) * seconds / kMetresInKm;
    const double half = 0.5 * wind.period.at(i);
    const double end = half > 0.0 ? std::abs(wind.from.at(i)) + std::min(std::abs(way), half) : wind.from.at(i) + way;
    if (std::abs(end) > kMost) {
      throw InputError("sequence: " + place + ".wind_m_s: the wind of " + format_number(wind.speed.at(i)) +
                       " m/s takes the cloud " + format_number(std::round(std::abs(end))) + " km " +
                       (i == 0 ? "east or west" : "north or south") +
                       " of the camera, and a cloud stands at most 1000 km away; choose a shorter time, less wind or "
                       "another east_km and north_km");
    }
  }
}

}  // namespace

void add_winds(SequenceJob& job) {
  const std::vector<std::size_t> numbers = numbers_in_preset(job.preset);
  auto* path = std::get_if<sequence::SunPath>(&job.source);
  for (std::size_t i = 0; i < job.scene.clouds.size(); ++i) {
    const Cloud& cloud = job.scene.clouds[i];
    if (!is_moved(cloud)) {
      continue;
    }
    const std::string number = std::to_string(numbers.at(i));
    const std::string place = "clouds[" + number + "]";
    if (path == nullptr) {
      throw InputError("sequence: " + place + ".wind_m_s: wind moves a cloud with the time of the frames, and " +
                       (std::holds_alternative<sequence::Sweep>(job.source) ? "a sweep has" : "key frames have") +
                       " none; give a sun path (--date, --from, --to, --step, --lat, --lon), or --set /clouds/" +
                       number + "/wind_m_s=[0,0]");
    }
    const sequence::Wind wind{.pointer = "/clouds/" + number,
                              .from = {cloud.east, cloud.north},
                              .speed = cloud.drift,
                              .period = period_of(cloud)};
    constexpr double kMillisecondsInSecond = 1e3;
    const double last = static_cast<double>(path->step) * static_cast<double>(path->count - 1);
    refuse_too_far(wind, last / kMillisecondsInSecond, place);
    path->winds.push_back(wind);
  }
}

}  // namespace airlight::cli
