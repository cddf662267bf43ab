#pragma once
// Pairs of files to compare: two files, two folders, or two frame patterns such as sky.####.exr.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace airlight::measure {

// "sky.####.exr": a run of # in the file's name stands for a frame number with at least as many digits, padded with
// zeros. One # stands for as many digits as needed.
struct FramePattern {
  std::string folder;  // "." where none is given
  std::string before;
  std::string after;
  int digits = 0;
};

// None when the name has no #. Throws InputError when it has two runs, or one in a folder's name.
std::optional<FramePattern> frame_pattern(const std::string& path);

// The frame number in a file name; none where the name is not of the pattern.
std::optional<long> frame_number(const FramePattern& pattern, std::string_view file_name);

struct FilePair {
  std::string name;  // "sky.0007.exr", or the path inside the folders
  std::string a;
  std::string b;
  std::vector<std::string> standard_errors;
  std::string problem;  // reason why this pair cannot be compared: one side is missing
};

struct FilePairs {
  bool several = false;  // folders or patterns were given, however many they hold
  std::vector<FilePair> pairs;
};

// Throws InputError: nothing there, unlike kinds, no EXR files, no matching files.
FilePairs pair_files(const std::string& a, const std::string& b, const std::vector<std::string>& standard_errors);

}  // namespace airlight::measure
