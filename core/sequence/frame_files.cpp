#include "core/sequence/frame_files.h"

#include <cstdio>
#include <filesystem>

#include "core/base/error.h"

namespace airlight::sequence {
namespace {

namespace fs = std::filesystem;

std::string shard_suffix(const Shard& shard) {
  return shard.count == 1 ? "" : "." + std::to_string(shard.index) + "-of-" + std::to_string(shard.count);
}

// Puts the folder before the name only if the user named one, since "./" before every name would be noise.
std::string in_folder(const FramePattern& pattern, const std::string& name) {
  return pattern.folder == "." ? name : (fs::path(pattern.folder) / name).string();
}

}  // namespace

FramePattern require_pattern(const std::string& path, const std::string& ending, const std::string& option) {
  if (fs::path(path).extension() != ending) {
    throw InputError(option + ": '" + path + "' does not end in " + ending + ", which is what it writes");
  }
  const std::optional<FramePattern> pattern = measure::frame_pattern(path);
  if (!pattern) {
    throw InputError(option + ": '" + path + "' has no # for the frame's number: every frame would be the same file; " +
                     "write for example " + fs::path(path).replace_extension().string() + ".####" + ending);
  }
  return *pattern;
}

std::string frame_file(const FramePattern& pattern, long number) {
  char digits[32];
  std::snprintf(digits, sizeof digits, "%0*ld", pattern.digits, number);
  return in_folder(pattern, pattern.before + digits + pattern.after);
}

std::string manifest_file(const FramePattern& pattern, const Shard& shard) {
  std::string stem = pattern.before;
  while (!stem.empty() && (stem.back() == '.' || stem.back() == '_' || stem.back() == '-')) stem.pop_back();
  return in_folder(pattern, stem + (stem.empty() ? "" : ".") + "manifest" + shard_suffix(shard) + ".json");
}

std::string manifest_file(const std::string& chosen, const Shard& shard) {
  const fs::path path(chosen);
  return (path.parent_path() / (path.stem().string() + shard_suffix(shard) + path.extension().string())).string();
}

}  // namespace airlight::sequence
