#pragma once
// Pictures of other programs, flat or deep, as planes of floats over the display window. EXRs are read by OpenEXR, the
// other formats of kPictureFormats by the module that links OpenImageIO, which is loaded when it is needed.

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
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
  const Channel* find(const std::string& name) const {
    const auto found = std::ranges::find(channels, name, &Channel::name);
    return found == channels.end() ? nullptr : &*found;
  }
  // "R, G, B, ViewLayer.Depth.Z", for messages.
  std::string channel_list() const;
};

// The formats that the module opens, as OpenImageIO calls them. Among its others are some that make pictures of
// nothing, or hand the file to a large decoder.
inline constexpr std::array<std::string_view, 10> kPictureFormats{"openexr", "png", "tiff", "hdr", "jpeg",
                                                                  "webp",    "pnm", "bmp",  "dpx", "targa"};
inline constexpr std::string_view kPictureFormatWords = "EXR, PNG, TIFF, HDR, JPEG, WebP, PNM, BMP, DPX or TGA";

// Told the header, before a pixel is decoded: width, height, depth or not. Throws InputError to refuse the picture.
using Accept = std::function<void(const Picture& header)>;

// Throws InputError: missing, no regular file, of another format, not readable, damaged, a window far larger than what
// is stored, or what `accept` throws; RunError where the module cannot be loaded.
Picture read_picture(const std::string& file, const Accept& accept = {});

// The module's entry. Never throws: `problem` is one line, empty on success.
inline constexpr const char* kReadEntry = "airlight_read_picture";
using ReadFunction = void (*)(const std::string& file, const Accept& accept, Picture& picture, std::string& problem);

}  // namespace airlight::foreign
