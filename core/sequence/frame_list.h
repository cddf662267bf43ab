#pragma once
// The frames of a sequence, made one by one on demand: a million of them take no memory.

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "core/scene/key_frames.h"
#include "core/sequence/sun_position.h"
#include "core/sequence/time_zone.h"

namespace airlight::sequence {

// Wind that moves a cloud of the preset with the time since the first frame.
struct Wind {
  std::string pointer;             // of the cloud, "/clouds/0"
  std::array<double, 2> from{};    // km to the east and to the north, in the first frame
  std::array<double, 2> speed{};   // m/s
  std::array<double, 2> period{};  // km after which the cloud repeats itself, so that it never goes far; 0: it does not
};

// The sun over a place, from `first` in equal steps.
struct SunPath {
  Place place;
  TimeZone zone;
  Milliseconds first = 0;  // UTC
  Milliseconds step = 0;   // above 0
  std::size_t count = 0;
  std::optional<Air> refraction = {};  // absent: the true elevation
  bool moon = false;                   // whether frames have the moon's place and phase,
  bool stars = false;                  // and the camera's place and time, by which the stars stand
  std::vector<Wind> winds = {};
};

// The sun's elevation, from `first` in equal steps, up or down.
struct Sweep {
  double first_deg = 0.0;
  double step_deg = 1.0;
  std::size_t count = 0;
};

using FrameSource = std::variant<SunPath, Sweep, KeyFrames>;

struct FrameTime {
  Milliseconds utc = 0;
  int offset_seconds = 0;  // of the clocks there at that time
};

// "2026-06-21T05:00:00+02:00".
std::string iso_text(const FrameTime& time);

struct Frame {
  long number = 0;  // number in its file's name
  std::optional<FrameTime> time;
  // The preset's keys in this frame, each a JSON pointer and its value: one number, or three of a spectrum.
  std::vector<std::pair<std::string, std::vector<double>>> keys;
};

// A sun path as typed on the command line; an empty zone is UTC.
struct SunPathOrder {
  std::string date, from, to, step, zone;
  Place place;
  std::optional<Air> refraction = {};
  std::optional<std::string> until = {};  // the date of `to`
};

// Both ends count if the step meets them; without `until` a `to` before `from` is on the next day. Throws InputError:
// malformed, a step of 0, an unknown zone, a time that the clocks skip on that day, an invalid place, an end before the
// start.
SunPath make_sun_path(const SunPathOrder& order);

// One moment, the order's `from`, as a path of one frame. `command`: the command whose options messages name, "render".
// Throws InputError like make_sun_path().
SunPath make_moment(const SunPathOrder& order, const std::string& command);

// "-12:90:1" = FROM:TO:STEP in degrees. Throws InputError: malformed, outside -90 to 90, a step that does not lead from
// FROM to TO.
Sweep parse_sweep(std::string_view text, const std::string& option);

std::size_t frame_count(const FrameSource& source);

// Those parts of a frame that cost nothing; `index` is below frame_count().
long frame_number(const FrameSource& source, std::size_t index);
std::optional<FrameTime> frame_time(const FrameSource& source, std::size_t index);

// `index` is below frame_count(). Frames of a sun path and of a sweep are numbered from 1, key frames by their own
// `at`.
Frame frame_at(const FrameSource& source, std::size_t index);

// Every N-th frame from the I-th on: "3/16" has the frames 3, 19, 35, ... counted from 1.
struct Shard {
  std::size_t index = 1;  // 1 to count
  std::size_t count = 1;
};

// Throws InputError.
Shard parse_shard(std::string_view text, const std::string& option);

// The shard's number of `frames`, and its k-th frame; k and frame count from 0.
std::size_t shard_size(const Shard& shard, std::size_t frames);
std::size_t shard_frame(const Shard& shard, std::size_t k);

}  // namespace airlight::sequence
