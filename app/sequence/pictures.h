#pragma once
// Pictures of a finished sequence for people: a film by ffmpeg, and a contact sheet.

#include <optional>
#include <string>

#include "app/sequence/job.h"

namespace airlight::cli {

struct SequencePictures {
  std::optional<std::string> preview;  // FILE.mp4 or FILE.gif
  int frames_a_second = 24;
  std::optional<std::string> contact_sheet;  // FILE.png
};

// To be called before anything is rendered. Throws InputError: another ending, a file that cannot be written, no
// ffmpeg, one shard of several, only EXRs under a view that only the renderer can show.
void check_pictures(const SequencePictures& pictures, const SequenceJob& job);

// Makes the pictures of a sequence whose frames are all whole. It reads them back: the PNGs if the job has them, else
// the EXRs through the display transform. Prints the names of the files. Throws RunError.
void make_pictures(const SequencePictures& pictures, const SequenceJob& job);

}  // namespace airlight::cli
