#include "app/sequence/job.h"

#include <cmath>

#include "app/cli/frame_scene.h"
#include "core/base/hash.h"
#include "core/output/frame_state.h"
#include "core/scene/json_format.h"

namespace airlight::cli {
namespace {

// "2026:06:21 05:00:00", on the place's clocks.
std::string capture_date(const sequence::FrameTime& time) {
  const std::string iso = iso_text(time);
  return iso.substr(0, 4) + ":" + iso.substr(5, 2) + ":" + iso.substr(8, 2) + " " + iso.substr(11, 8);
}

}  // namespace

Targets files_of(const SequenceJob& job, long frame_number) {
  return {job.exr ? sequence::frame_file(*job.exr, frame_number) : "",
          job.png ? sequence::frame_file(*job.png, frame_number) : ""};
}

Scene scene_of(const SequenceJob& job, const sequence::Frame& frame) {
  return frame_scene(job.preset, frame, job.scene);
}

sequence::Frame locked_frame(const SequenceJob& job) {
  return frame_numbered(job.source, job.scene.display.metered_frame,
                        "sequence: the exposure " + metering_text(job.scene.display));
}

FrameAttributes attributes_of(const SequenceJob& job, const sequence::Frame& frame) {
  FrameAttributes attributes;
  attributes.label = "frame " + std::to_string(frame.number);
  attributes.number = static_cast<int>(frame.number);
  attributes.frames_a_second = job.frames_a_second;
  if (frame.time) {
    attributes.label += ", " + iso_text(*frame.time);
    attributes.capture_date = capture_date(*frame.time);
    attributes.utc_offset = static_cast<float>(-frame.time->offset_seconds);
  }
  if (const auto* path = std::get_if<sequence::SunPath>(&job.source)) {
    constexpr double kMetres = 1000.0;
    attributes.latitude = static_cast<float>(path->place.latitude_deg);
    attributes.longitude = static_cast<float>(std::remainder(path->place.longitude_deg, 360.0));
    attributes.altitude = static_cast<float>(kMetres * path->place.altitude_km);
  }
  return attributes;
}

FrameHashes hashes_of(const PictureOptions& options, const std::string& display, const std::string& preset_json,
                      const FrameAttributes& frame) {
  const std::string common = preset_json + "airlight " + AIRLIGHT_VERSION + ", " + frame.label;
  const bool is_ours = working_space_of(options) == WorkingSpace::linear_rec709;
  std::string exr = common +
                    (options.full_float   ? ", float"
                     : options.half_float ? ", half"
                                          : "") +
                    (is_ours ? "" : ", " + options.colorspace) +
                    (options.layers.empty()           ? ""
                     : options.layers == kLightLayers ? ", layers"
                                                      : ", layers " + options.layers);
  exr += ", " + std::to_string(frame.frames_a_second.value_or(0)) + " a second";
  for (const std::optional<float>& number : {frame.latitude, frame.longitude, frame.altitude}) {
    exr += number ? ", " + format_number(static_cast<double>(*number)) : "";
  }
  return {hash_text(exr), hash_text(common + ", " + std::to_string(options.bits) + " bits, " + display)};
}

bool is_done(const Targets& files, const FrameHashes& hashes, const std::string& preset_json) {
  if (!files.exr.empty()) {
    const std::optional<FrameMark> mark = read_frame_mark(files.exr);
    if (!mark || mark->hash != hashes.exr || mark->preset_json != preset_json) {
      return false;
    }
  }
  if (!files.png.empty()) {
    const std::optional<FrameMark> mark = read_frame_mark(files.png);
    return mark && mark->hash == hashes.png;
  }
  return true;
}

}  // namespace airlight::cli
