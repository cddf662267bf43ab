#include "core/sequence/frame_list.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/scene/json_format.h"

namespace airlight::sequence {
namespace {

constexpr const char* kElevation = "/sun/elevation_deg";
constexpr const char* kAzimuth = "/sun/azimuth_deg";

// 1e-6 degrees are 4 mm of the sun's path on the ground. The last digits of a double depend on the machine's libm and
// would show in presets and names of frames.
double round_to_micro(double value) {
  return std::round(value * 1e6) / 1e6 + 0.0;  // never -0
}

// Rounds to 15 digits: -1.6 and not -1.5999999999999996.
double without_rounding_noise(double value) {
  char text[40];
  const auto written = std::to_chars(text, text + sizeof text, value, std::chars_format::general, 15);
  std::from_chars(text, written.ptr, value);
  return value;
}

Milliseconds utc_on_clock(const TimeZone& zone, Milliseconds local, const std::string& option) {
  const std::optional<Milliseconds> utc = utc_of(zone, local);
  if (!utc) {
    throw InputError(option + ": the clocks of " + zone.name + " skip " + iso_text(local, 0).substr(0, 16) +
                     " (summer time begins); write a time before or after");
  }
  return *utc;
}

void require_coordinate(double value, double least, double most, const std::string& option) {
  if (!(value >= least && value <= most)) {
    throw InputError(option + ": " + format_number(value) + " is outside " + format_number(least) + " to " +
                     format_number(most) + " degrees");
  }
}

// One frame, the first. `from`: the option that has its time.
SunPath path_from(const SunPathOrder& order, const std::string& prefix, const std::string& from) {
  SunPath path;
  path.zone = find_zone(order.zone.empty() ? "UTC" : order.zone, prefix + "--tz");
  const Milliseconds date = parse_date(order.date, prefix + "--date");
  const Milliseconds time = parse_time_of_day(order.from, prefix + from);
  require_coordinate(order.place.latitude_deg, -90.0, 90.0, prefix + "--lat");
  require_coordinate(order.place.longitude_deg, -180.0, 360.0, prefix + "--lon");
  path.place = order.place;
  path.refraction = order.refraction;
  path.first = utc_on_clock(path.zone, date + time, prefix + from);
  path.step = kDay;
  path.count = 1;
  return path;
}

// The value of one pointer at a frame, from the key frames with that pointer on both sides; empty where none has it.
std::vector<double> value_at(const KeyFrames& sequence, const std::string& pointer, double at) {
  const KeyFrame* before = nullptr;
  const KeyFrame* after = nullptr;
  for (const KeyFrame& frame : sequence.frames) {
    if (!frame.values.contains(pointer)) continue;
    if (frame.at <= at) before = &frame;
    if (frame.at >= at && after == nullptr) after = &frame;
  }
  if (before == nullptr) before = after;
  if (after == nullptr) after = before;
  std::vector<double> a = before->values.find(pointer)->second;
  const std::vector<double>& b = after->values.find(pointer)->second;
  const double share = before == after ? 0.0 : (at - before->at) / (after->at - before->at);
  a.resize(std::max(a.size(), b.size()), a.front());
  for (std::size_t i = 0; i < a.size() && share > 0.0; ++i) {
    a[i] = without_rounding_noise(a[i] + share * (b[b.size() == 1 ? 0 : i] - a[i]));
  }
  if (sequence.whole.contains(pointer)) std::ranges::for_each(a, [](double& value) { value = std::round(value); });
  return a;
}

void add_moon(Frame& frame, const SunPath& path, Milliseconds utc) {
  MoonAngles moon = moon_angles(utc, path.place);
  if (path.refraction) moon.at.elevation_deg += refraction_deg(moon.at.elevation_deg, *path.refraction);
  frame.keys.insert(frame.keys.end(), {{"/moon/elevation_deg", {std::min(90.0, round_to_micro(moon.at.elevation_deg))}},
                                       {"/moon/azimuth_deg", {round_to_micro(moon.at.azimuth_deg)}},
                                       {"/moon/distance_km", {round_to_micro(moon.distance_km)}},
                                       {"/moon/phase_deg", {round_to_micro(moon.phase_deg)}}});
}

void add_wind(Frame& frame, const Wind& wind, Milliseconds since) {
  constexpr double kMillisecondsInSecond = 1e3;
  constexpr double kMetresInKm = 1e3;
  constexpr std::array<const char*, 2> kKeys = {"/east_km", "/north_km"};
  for (std::size_t i = 0; i < kKeys.size(); ++i) {
    double way = wind.speed.at(i) * (static_cast<double>(since) / kMillisecondsInSecond) / kMetresInKm;
    if (wind.period.at(i) > 0.0) {
      way = std::remainder(way, wind.period.at(i));
    }
    frame.keys.push_back({wind.pointer + kKeys.at(i), {wind.from.at(i) + round_to_micro(way)}});
  }
}

Frame frame_of(const SunPath& path, std::size_t index) {
  Frame frame;
  const Milliseconds utc = path.first + static_cast<Milliseconds>(index) * path.step;
  SunAngles sun = sun_angles(utc, path.place);
  if (path.refraction) sun.elevation_deg += refraction_deg(sun.elevation_deg, *path.refraction);
  frame.keys = {{kElevation, {std::min(90.0, round_to_micro(sun.elevation_deg))}},
                {kAzimuth, {round_to_micro(sun.azimuth_deg)}}};
  if (path.moon) add_moon(frame, path, utc);
  if (path.stars) {
    frame.keys.insert(frame.keys.end(), {{"/camera/julian_date", {julian_date(utc)}},
                                         {"/camera/latitude_deg", {path.place.latitude_deg}},
                                         {"/camera/longitude_deg", {path.place.longitude_deg}}});
  }
  for (const Wind& wind : path.winds) {
    add_wind(frame, wind, utc - path.first);
  }
  return frame;
}

Frame frame_of(const Sweep& sweep, std::size_t index) {
  const double elevation = sweep.first_deg + static_cast<double>(index) * sweep.step_deg;
  return {0, {}, {{kElevation, {round_to_micro(elevation)}}}};
}

Frame frame_of(const KeyFrames& sequence, std::size_t index) {
  Frame frame;
  const double at = static_cast<double>(sequence.frames.front().at) + static_cast<double>(index);
  std::set<std::string> pointers;
  for (const KeyFrame& key_frame : sequence.frames) {
    for (const auto& [pointer, values] : key_frame.values) pointers.insert(pointer);
  }
  for (const std::string& pointer : pointers) {
    frame.keys.emplace_back(pointer, value_at(sequence, pointer, at));
  }
  return frame;
}

std::size_t count_of(const KeyFrames& sequence) {
  return static_cast<std::size_t>(sequence.frames.back().at - sequence.frames.front().at) + 1;
}

}  // namespace

SunPath make_sun_path(const SunPathOrder& order) {
  SunPath path = path_from(order, "sequence: ", "--from");
  const Milliseconds date = parse_date(order.date, "sequence: --date");
  const Milliseconds from = parse_time_of_day(order.from, "sequence: --from");
  const Milliseconds to = parse_time_of_day(order.to, "sequence: --to");
  path.step = parse_step(order.step, "sequence: --step");
  const Milliseconds end = order.until ? parse_date(*order.until, "sequence: --until") : date + (to < from ? kDay : 0);
  const Milliseconds last = utc_on_clock(path.zone, end + to, "sequence: --to");
  if (order.until && end + to < date + from) {
    throw InputError("sequence: --until " + *order.until + ": it ends before it begins, on " + order.date + " at " +
                     order.from + "; give a later date");
  }
  path.count = last < path.first ? 1 : static_cast<std::size_t>((last - path.first) / path.step) + 1;
  return path;
}

SunPath make_moment(const SunPathOrder& order, const std::string& command) {
  return path_from(order, command + ": ", "--time");
}

Sweep parse_sweep(std::string_view text, const std::string& option) {
  const std::optional<std::array<double, 3>> numbers = three_numbers(text);
  const std::string what = option + ": '" + std::string(text) + "'";
  if (!numbers) {
    throw InputError(what + " is not FROM:TO:STEP in degrees; write for example -12:90:1");
  }
  const auto [from, to, step] = *numbers;
  require_coordinate(from, -90.0, 90.0, what);
  require_coordinate(to, -90.0, 90.0, what);
  if (step == 0.0 || (to - from) * step < 0.0) {
    throw InputError(what + ": steps of " + format_number(step) + " never get from " + format_number(from) + " to " +
                     format_number(to) + "; write for example -12:90:1");
  }
  constexpr double kRounding = 1e-9;  // of a step: 0:1:0.1 has eleven frames
  return {from, step, static_cast<std::size_t>((to - from) / step + kRounding) + 1};
}

std::string iso_text(const FrameTime& time) {
  return iso_text(time.utc, time.offset_seconds);
}

std::size_t frame_count(const FrameSource& source) {
  if (const auto* sequence = std::get_if<KeyFrames>(&source)) return count_of(*sequence);
  if (const auto* sweep = std::get_if<Sweep>(&source)) return sweep->count;
  return std::get<SunPath>(source).count;
}

long frame_number(const FrameSource& source, std::size_t index) {
  const auto* sequence = std::get_if<KeyFrames>(&source);
  return static_cast<long>(index) + (sequence == nullptr ? 1 : sequence->frames.front().at);
}

std::optional<FrameTime> frame_time(const FrameSource& source, std::size_t index) {
  const auto* path = std::get_if<SunPath>(&source);
  if (path == nullptr) return std::nullopt;
  const Milliseconds utc = path->first + static_cast<Milliseconds>(index) * path->step;
  return FrameTime{utc, offset_at(path->zone, utc)};
}

Frame frame_at(const FrameSource& source, std::size_t index) {
  Frame frame = std::visit([&](const auto& of_its_kind) { return frame_of(of_its_kind, index); }, source);
  frame.number = frame_number(source, index);
  frame.time = frame_time(source, index);
  return frame;
}

Shard parse_shard(std::string_view text, const std::string& option) {
  Shard shard;
  const std::vector<std::string> parts = split(text, '/');
  if (parts.size() == 2) {
    shard.index = number_from<std::size_t>(parts[0]).value_or(0);
    shard.count = number_from<std::size_t>(parts[1]).value_or(0);
  }
  if (parts.size() != 2 || shard.index < 1 || shard.index > shard.count) {
    throw InputError(option + ": '" + std::string(text) +
                     "' is not I/N with I from 1 to N; write for example 3/16 for the third of sixteen");
  }
  return shard;
}

std::size_t shard_size(const Shard& shard, std::size_t frames) {
  return frames < shard.index ? 0 : (frames - shard.index) / shard.count + 1;
}

std::size_t shard_frame(const Shard& shard, std::size_t k) {
  return shard.index - 1 + k * shard.count;
}

}  // namespace airlight::sequence
