#pragma once
// One case of each kind, by its number: an empty outcome where the program behaves, else its fault.

#include <cstdint>
#include <filesystem>
#include <string>

namespace airlight::fuzz {

struct Outcome {
  std::string fault = {};  // empty: none
  std::string input = {};  // input that caused it: a preset, an EXR
  bool refused = false;    // by a message: this one
  std::string message = {};
  double seconds = 0.0;  // of the processor, for the dearest of several pictures; 0: nothing is told apart
};

// A preset with changed tokens. The answer must be a scene that its own text gives again, or a short message without
// anything that controls a terminal.
Outcome text_case(std::uint64_t seed);

// An EXR of ours with changed bytes, read by every reader of EXRs.
Outcome exr_case(std::uint64_t seed, const std::filesystem::path& folder);

// A valid preset anywhere in the documented ranges, rendered at a few pixels. All numbers of the picture are finite and
// not negative, or the scene is refused.
Outcome scene_case(std::uint64_t seed);

// The text of scene_case().
std::string scene_text(std::uint64_t seed);

// The scene of that text by every method that takes it, as a picture and as tables, in some directions, and as the air
// before a plate, whose light and depth may be anything.
Outcome method_case(std::uint64_t seed, const std::filesystem::path& folder);

}  // namespace airlight::fuzz
