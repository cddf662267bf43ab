#pragma once
// One case of each kind, by its number: nothing where the program does what it should, else what is wrong.

#include <cstdint>
#include <filesystem>
#include <string>

namespace airlight::fuzz {

struct Outcome {
  std::string fault = {};  // empty: none
  std::string input = {};  // what made it: a preset, an EXR
  bool refused = false;    // by a message: this one
  std::string message = {};
};

// A preset changed by the token: every answer is a scene that its own text gives again, or a message that is short and
// holds nothing that a terminal obeys.
Outcome text_case(std::uint64_t seed);

// An EXR of ours changed by the byte, read by everything that reads one.
Outcome exr_case(std::uint64_t seed, const std::filesystem::path& folder);

// A valid preset anywhere in the documented ranges, rendered at a few pixels: every number of the picture is finite and
// none is negative, or the scene is refused.
Outcome scene_case(std::uint64_t seed);

// The text of scene_case().
std::string scene_text(std::uint64_t seed);

}  // namespace airlight::fuzz
