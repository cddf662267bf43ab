#pragma once
// Files of earlier runs beside a sequence's frames: frames that do not belong to it, and half-written files.

#include <string>
#include <vector>

#include "app/sequence/job.h"

namespace airlight::cli {

// Whole frames of `airlight sequence` whose names match the job's patterns, but whose numbers the whole sequence does
// not have, such as those of a run with a finer step; sorted by name. Other files are never among them.
std::vector<std::string> frames_beyond(const SequenceJob& job);

// Removes these frames if the job says so; otherwise reports them in one line.
void tidy_frames_beyond(const SequenceJob& job);

// Removes half-written frames and manifests of killed runs.
void remove_half_written(const SequenceJob& job);

}  // namespace airlight::cli
