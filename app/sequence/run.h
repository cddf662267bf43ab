#pragma once
// Renders a sequence's job to frames on disk: the device renders the next frame while threads encode the last.

#include <string>

#include "app/sequence/job.h"

namespace airlight::cli {

struct SequenceOutcome {
  int signal = 0;         // that stopped it; 0: none
  bool complete = false;  // every frame of the shard is whole
};

// Skips finished frames unless the job says to overwrite them. Throws RunError when the device or the disk fails;
// earlier frames are whole, and the manifest lists them.
SequenceOutcome run_sequence(const SequenceJob& job);

}  // namespace airlight::cli
