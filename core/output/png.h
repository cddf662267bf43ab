#pragma once
// PNG files of display-encoded pixels.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/output/colour_code.h"

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
  // Colours of the pixels, written as sRGB or cICP, with gAMA and cHRM for older readers; absent: not written.
  std::optional<ColourCode> colours = kSrgbCode;
  std::map<std::string, std::string> texts;  // tEXt chunks such as Software, Description; UTF-8 becomes iTXt
  bool smallest = false;                     // four times the work, for a file kept in a repository
};

// A PNG whose rows are given from the top, some at a time. The bytes equal those of encode_png() on all rows. Throws
// RunError, and whatever the sink throws.
class PngRows {
 public:
  using Sink = std::function<void(std::span<const std::byte> bytes)>;

  // `format`: channels, bits and width; its pixels are not read.
  PngRows(Sink sink, const PixelImage& format, int height, const PngOptions& options);
  ~PngRows();
  PngRows(const PngRows&) = delete;
  PngRows& operator=(const PngRows&) = delete;

  void add(const PixelImage& rows);
  void finish();  // after the last row

 private:
  struct State;
  std::unique_ptr<State> state_;
};

std::vector<std::byte> encode_png(const PixelImage& image, const PngOptions& options);

// Through write_file().
void write_png(const std::filesystem::path& file, const PixelImage& image, const PngOptions& options);

}  // namespace airlight
