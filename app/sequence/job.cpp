#include "app/sequence/job.h"

#include "app/cli/frame_scene.h"
#include "core/output/frame_state.h"

namespace airlight::cli {

FrameFiles files_of(const SequenceJob& job, long frame_number) {
  return {job.exr ? sequence::frame_file(*job.exr, frame_number) : "",
          job.png ? sequence::frame_file(*job.png, frame_number) : ""};
}

Scene scene_of(const SequenceJob& job, const sequence::Frame& frame) {
  return frame_scene(job.preset, frame);
}

sequence::Frame locked_frame(const SequenceJob& job) {
  return frame_numbered(job.source, job.scene.display.metered_frame,
                        "sequence: the exposure " + metering_text(job.scene.display));
}

FrameHashes hashes_of(const PictureOptions& options, const std::string& display, const std::string& preset_json) {
  const std::string common = preset_json + "airlight " + AIRLIGHT_VERSION;
  const bool is_ours = working_space_of(options) == WorkingSpace::linear_rec709;
  const std::string exr = common +
                          (options.full_float   ? ", float"
                           : options.half_float ? ", half"
                                                : "") +
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
