#pragma once
// PNG files of display-encoded pixels.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace airlight {

// Display-encoded pixels, RGB or RGBA (alpha not multiplied in), rows from the top without gaps.
struct PixelImage {
  int width = 0;
  int height = 0;
  int channels = 3;                  // 3 or 4
  int bits = 8;                      // 8 or 16
  std::vector<std::uint8_t> bytes;   // of an 8-bit picture
  std::vector<std::uint16_t> words;  // of a 16-bit picture
};

struct PngOptions {
  bool srgb = true;                          // pixels are sRGB: says so; false leaves the encoding unsaid
  std::map<std::string, std::string> texts;  // tEXt chunks such as Software, Description; UTF-8 becomes iTXt
  bool smallest = false;                     // four times the work for a file to keep in a repository
};

std::vector<std::byte> encode_png(const PixelImage& image, const PngOptions& options);

// Through write_file().
void write_png(const std::filesystem::path& file, const PixelImage& image, const PngOptions& options);

}  // namespace airlight
