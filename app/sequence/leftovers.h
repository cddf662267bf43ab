#pragma once
// What earlier runs have left beside a sequence's frames: frames that are no part of it, and files half written.

#include <string>
#include <vector>

#include "app/sequence/job.h"

namespace airlight::cli {

// Whole frames of `airlight sequence` whose names match the job's patterns, but with numbers that the whole sequence
// does not have, such as those of a run with a finer step; by name. Files of anything else are not among them.
std::vector<std::string> frames_beyond(const SequenceJob& job);

// Removes them where the job says so; else tells of them, in one line.
void tidy_frames_beyond(const SequenceJob& job);

// Removes what killed runs have left half written of frames and manifest.
void remove_half_written(const SequenceJob& job);

}  // namespace airlight::cli
