#pragma once
// Whether a file on disk is a whole picture of ours, and which: by its header and the places of its parts, not by its
// pixels, so that a thousand frames are looked at in a second.

#include <filesystem>
#include <optional>
#include <string>

namespace airlight {

// What the picture says of itself.
struct FrameMark {
  std::string hash;  // of kHashKey; empty where there is none
  std::string preset_json;
};

// Nothing when the file is missing, cut short, damaged in its structure or of another kind. `file` ends in .exr or
// .png.
std::optional<FrameMark> read_frame_mark(const std::filesystem::path& file);

}  // namespace airlight
