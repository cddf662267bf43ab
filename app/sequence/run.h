#pragma once
// From a sequence's job to its frames on disk: the device renders the next frame while threads encode the last.

#include <string>

#include "app/sequence/job.h"

namespace airlight::cli {

struct SequenceOutcome {
  int signal = 0;         // that stopped it; 0: none did
  bool complete = false;  // every frame of the shard is whole
};

// Frames that are done already are passed over unless the job says to overwrite them. Throws RunError: the device or
// the disk failed; the frames before are whole, and the manifest says which.
SequenceOutcome run_sequence(const SequenceJob& job);

}  // namespace airlight::cli
