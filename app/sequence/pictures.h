#pragma once
// A finished sequence for people: a film by ffmpeg, and a sheet of small pictures.

#include <optional>
#include <string>

#include "app/sequence/job.h"

namespace airlight::cli {

struct SequencePictures {
  std::optional<std::string> preview;  // FILE.mp4 or FILE.gif
  int frames_a_second = 24;
  std::optional<std::string> contact_sheet;  // FILE.png
};

// Before anything is rendered. Throws InputError: another ending, a place that cannot be written, no ffmpeg, one shard
// of several, EXRs alone under a view that only the renderer can show.
void check_pictures(const SequencePictures& pictures, const SequenceJob& job);

// Makes the pictures of a sequence whose frames are all whole. Reads them back: the PNGs where the job has them, else
// the EXRs through the display transform. Tells the files written. Throws RunError.
void make_pictures(const SequencePictures& pictures, const SequenceJob& job);

}  // namespace airlight::cli
