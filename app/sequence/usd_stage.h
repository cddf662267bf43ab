#pragma once
// `sequence --usd FILE.usda`: one stage for all frames, with a time sample a frame of the dome's picture, the sun and
// the moon (app/render/usd_file.h).

#include <string>

#include "app/sequence/job.h"

namespace airlight::cli {

struct UsdStageOrder {
  std::string file;
  std::string up = "y";
};

// To be called before anything is rendered. Throws InputError: no EXRs, no whole sky, one shard of several, a name
// that is not a .usda or cannot be written.
void check_usd_stage(const UsdStageOrder& order, const SequenceJob& job);

// Writes the stage once all frames are there, and prints its name. Nothing is written where a signal ends it. Throws
// RunError.
void write_usd_stage(const UsdStageOrder& order, const SequenceJob& job);

}  // namespace airlight::cli
