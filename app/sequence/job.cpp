#include "app/sequence/job.h"

#include "core/error.h"
#include "core/methods/method.h"
#include "core/output/frame_state.h"
#include "core/scene/resolve.h"

namespace airlight::cli {
namespace {

PresetValue value_of(const std::vector<double>& values) {
  PresetValue value;
  if (values.size() == 1) {
    value.data = values.front();
    return value;
  }
  PresetArray array(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    array[i].data = values[i];
  }
  value.data = std::move(array);
  return value;
}

}  // namespace

FrameFiles files_of(const SequenceJob& job, long frame_number) {
  return {job.exr ? sequence::frame_file(*job.exr, frame_number) : "",
          job.png ? sequence::frame_file(*job.png, frame_number) : ""};
}

Scene scene_of(const SequenceJob& job, const sequence::Frame& frame) {
  const std::string place = "frame " + std::to_string(frame.number);
  Preset preset = job.preset;
  for (const auto& [pointer, values] : frame.keys) {
    PresetValue value = value_of(values);
    value.source = place;
    put_value(preset, pointer, std::move(value), place);
  }
  return resolve(preset, method_infos());
}

FrameHashes hashes_of(const PictureOptions& options, const std::string& display, const std::string& preset_json) {
  const std::string common = preset_json + "airlight " + AIRLIGHT_VERSION;
  const bool is_ours = working_space_of(options) == WorkingSpace::linear_rec709;
  const std::string exr = common + (options.full_float ? ", float" : ", half") +
                          (is_ours ? "" : ", " + options.colorspace) + (options.layers ? ", layers" : "");
  return {sequence::hash_text(exr),
          sequence::hash_text(common + ", " + std::to_string(options.bits) + " bits, " + display)};
}

bool is_done(const FrameFiles& files, const FrameHashes& hashes, const std::string& preset_json) {
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
