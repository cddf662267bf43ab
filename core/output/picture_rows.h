#pragma once
// Pictures in formats beside EXR and PNG, given row by row from the top: linear R, G and B without alpha.
//   .hdr   Radiance's RGBE: three mantissas of 8 bits under one exponent; the smallest header, since many readers
//          accept no more.
//   .npy   a NumPy array (height, width, 3) of 32-bit floats.
//   .json  {"width", "height", "channels": ["R", "G", "B"], "pixels": rows of pixels of three numbers}, each number
//          with the fewest digits that are read as the same 32-bit float.
//   .ktx2, .dds   a cube map of half floats with all mips, for a picture that stacks OpenEXR's six faces.
// Equal pictures give equal bytes.

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/radiance_image.h"

namespace airlight {

class PictureRows {
 public:
  // Gets the file's bytes, one piece after the other.
  using Sink = std::function<void(std::span<const std::byte>)>;

  virtual ~PictureRows() = default;
  virtual void add(const RadianceImage& rows) = 0;
  // To be called after the last row. Returns what the format could not hold, a line each.
  virtual std::vector<std::string> finish() = 0;
};

// Endings of those formats: ".hdr", ...
std::span<const std::string_view> row_formats();

// Whether the file's name ends in one of them.
bool has_row_format(const std::string& file);

// Whether the format holds a cube, and nothing else.
bool is_cube_format(const std::string& file);

// For a file of that name. Cubes need a picture six times as high as wide. `prefilter`: a cube's mips are for rough
// surfaces (core/output/prefilter.h), else means.
std::unique_ptr<PictureRows> picture_rows(const std::string& file, PictureRows::Sink sink, int width, int height,
                                          bool prefilter = false);

// Those of cubes, by core/output/cube_texture.cpp.
std::unique_ptr<PictureRows> cube_texture_rows(bool is_dds, bool prefilter, PictureRows::Sink sink, int side);

}  // namespace airlight
