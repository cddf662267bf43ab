#pragma once
// `sequence`: keys of the preset that change from frame to frame.

#include <map>
#include <set>
#include <string>
#include <vector>

namespace airlight {

struct KeyFrame {
  int at = 0;  // the frame's number
  // The values that a frame sets, by JSON pointer: one number, or three of a spectrum.
  std::map<std::string, std::vector<double>, std::less<>> values;
};

struct KeyFrames {
  std::vector<KeyFrame> frames;                   // at least one, `at` ascending
  std::set<std::string, std::less<>> whole = {};  // pointers of keys that take whole numbers alone
};

}  // namespace airlight
