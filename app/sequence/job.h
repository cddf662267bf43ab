#pragma once
// The checked options of `airlight sequence`: plain data for the parts that carry them out.

#include <optional>
#include <string>

#include "app/cli/picture_options.h"
#include "app/cli/scene_options.h"
#include "app/render/publish.h"
#include "core/output/exr.h"
#include "core/scene/preset.h"
#include "core/scene/scene.h"
#include "core/sequence/frame_files.h"
#include "core/sequence/frame_list.h"
#include "core/stage/stage.h"

namespace airlight::cli {

struct SequenceJob {
  SceneOptions scene_options;  // for the device
  Preset preset;               // with all overrides, without its own key frames
  Scene scene;                 // of that preset, for everything that no frame changes
  std::optional<Stage> stage;  // of that scene: frames take over from it what is equal
  sequence::FrameSource source;
  sequence::Shard shard;
  std::optional<sequence::FramePattern> exr;  // at least one of the two
  std::optional<sequence::FramePattern> png;
  PictureOptions picture;
  std::optional<std::string> tile;  // of --tile
  std::string manifest;             // name of the file
  int frames_a_second = 24;
  bool overwrite = false;
  bool clean = false;  // remove older frames that are not in the sequence
  bool quiet = false;
  bool json = false;
};

Targets files_of(const SequenceJob& job, long frame_number);

// The scene of the preset with the frame's keys put in. Throws InputError that names the frame.
Scene scene_of(const SequenceJob& job, const sequence::Frame& frame);

// The frame that `lock:FRAME` names. Throws InputError where the sequence has no frame of that number.
sequence::Frame locked_frame(const SequenceJob& job);

// Time and place for the headers of the frame's files.
FrameAttributes attributes_of(const SequenceJob& job, const sequence::Frame& frame);

// A hash over all that determines a file's contents: the frame's preset, airlight's version, the way from pixels to
// files. The device is not part of it: pictures of two devices agree to rounding, and a farm may have several.
struct FrameHashes {
  std::string exr;
  std::string png;
};
// `display`: OCIO's config, display and view of the PNG; empty for the views that need none.
FrameHashes hashes_of(const PictureOptions& options, const std::string& display, const std::string& preset_json,
                      const FrameAttributes& frame);

// Whether every file of the frame exists, is whole, and has its hash and preset.
bool is_done(const Targets& files, const FrameHashes& hashes, const std::string& preset_json);

}  // namespace airlight::cli
