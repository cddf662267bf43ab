#pragma once
// Names of a sequence's files: a pattern such as "sky.####.exr", and a frame's number.

#include <string>

#include "core/measure/frames.h"
#include "core/sequence/frame_list.h"

namespace airlight::sequence {

using measure::FramePattern;

// Throws InputError: no #, two runs of them, one in a folder's name, another ending. `option`: for messages.
FramePattern require_pattern(const std::string& path, const std::string& ending, const std::string& option);

// "day/sky.0007.exr"; a number with more digits than the pattern has keeps them all.
std::string frame_file(const FramePattern& pattern, long number);

// "day/sky.manifest.json"; "day/sky.manifest.3-of-16.json" for one shard of several.
std::string manifest_file(const FramePattern& pattern, const Shard& shard);
// The manifest's name for a name that the user chose: the shard is inserted before the ending.
std::string manifest_file(const std::string& chosen, const Shard& shard);

}  // namespace airlight::sequence
