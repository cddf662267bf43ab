#pragma once
// Pictures of other programs: any file that OpenImageIO reads, flat or deep, as planes of floats over the display
// window. EXRs are read by OpenEXR, all others by the module that links OpenImageIO, which is loaded when it is needed.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace airlight::foreign {

struct Channel {
  std::string
      name;  // full: "ViewLayer.Depth.Z"; in the parts of a file after the first, with the part's name before it
  bool half = false;          // stored as 16 bits
  std::vector<float> values;  // rows from the top; of a deep file sample by sample, pixel by pixel
};

struct Picture {
  std::string file;
  int width = 0;
  int height = 0;
  std::vector<Channel> channels;
  bool deep = false;
  std::vector<std::uint32_t> samples;  // of a deep file: number of samples of each pixel
  // Row-vector matrices in OpenEXR's convention, where the file has them.
  std::optional<std::array<double, 16>> world_to_camera;
  std::optional<std::array<double, 16>> world_to_ndc;
  std::optional<std::array<float, 8>> chromaticities;  // CIE xy of red, green, blue, white
  bool srgb = false;                                   // display-encoded: the module has decoded R, G and B to linear
  bool is_airlight = false;                            // carries a preset of ours

  // Null where there is no channel of that name.
  const Channel* find(const std::string& name) const;
  // "R, G, B, ViewLayer.Depth.Z", for messages.
  std::string channel_list() const;
};

// Throws InputError: missing, a folder, not readable, damaged; RunError where the module cannot be loaded.
Picture read_picture(const std::string& file);

// The module's entry. Never throws: `problem` is one line, empty on success.
inline constexpr const char* kReadEntry = "airlight_read_picture";
using ReadFunction = void (*)(const std::string& file, Picture& picture, std::string& problem);

}  // namespace airlight::foreign
