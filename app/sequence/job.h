#pragma once
// What `airlight sequence` has been asked for, checked: plain data for the parts that carry it out.

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

namespace airlight::cli {

struct SequenceJob {
  SceneOptions scene_options;  // for the device
  Preset preset;               // all overrides applied, its own key frames taken out
  Scene scene;                 // of that preset, for what no frame changes
  sequence::FrameSource source;
  sequence::Shard shard;
  std::optional<sequence::FramePattern> exr;  // at least one of the two
  std::optional<sequence::FramePattern> png;
  PictureOptions picture;
  std::optional<std::string> tile;  // of --tile
  std::string manifest;             // the file
  int frames_a_second = 24;
  bool overwrite = false;
  bool clean = false;  // remove older frames that the sequence does not have
  bool quiet = false;
  bool json = false;
};

Targets files_of(const SequenceJob& job, long frame_number);

// The preset with the frame's keys put in, judged like any other. Throws InputError that names the frame.
Scene scene_of(const SequenceJob& job, const sequence::Frame& frame);

// The frame that `lock:FRAME` names. Throws InputError where the sequence has none of that number.
sequence::Frame locked_frame(const SequenceJob& job);

// What the frame's files say of its time and place.
FrameAttributes attributes_of(const SequenceJob& job, const sequence::Frame& frame);

// A hash over all that decides what a file holds: the frame's preset, airlight's version, how pixels become files. Not
// the device: pictures of two devices agree to rounding, and a farm may have several.
struct FrameHashes {
  std::string exr;
  std::string png;
};
// `display`: OCIO's config, display and view of the PNG; empty for the views that need none.
FrameHashes hashes_of(const PictureOptions& options, const std::string& display, const std::string& preset_json,
                      const FrameAttributes& frame);

// Whether every file of the frame is there, whole, and of its hash and preset.
bool is_done(const Targets& files, const FrameHashes& hashes, const std::string& preset_json);

}  // namespace airlight::cli
