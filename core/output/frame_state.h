#pragma once
// Whether a file on disk is a whole picture of ours, and which one. It reads the header and the places of the file's
// parts, not the pixels, so that a thousand frames take a second.

#include <filesystem>
#include <optional>
#include <string>

namespace airlight {

// The picture's description of itself.
struct FrameMark {
  std::string hash;  // of kHashKey; empty where there is none
  std::string preset_json;
};

// None when the file is missing, cut short, damaged in its structure or of another kind. `file` ends in .exr or .png.
std::optional<FrameMark> read_frame_mark(const std::filesystem::path& file);

}  // namespace airlight
