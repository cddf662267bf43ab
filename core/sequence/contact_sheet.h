#pragma once
// Small pictures of a sequence in rows, with a line of text below each.

#include <cstddef>
#include <string>
#include <vector>

#include "core/measure/raster.h"

namespace airlight::sequence {

// An 8-bit RGB picture, rows from the top without gaps.
struct Thumbnail {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgb;
  std::string label;
};

// Which of `frames` a sheet of at most `most` shows: evenly spread, the first and the last among them; ascending.
std::vector<std::size_t> frames_shown(std::size_t frames, std::size_t most);

// At most `largest_side` pixels on each side; smaller pictures stay. `channels` of the source are 3 or 4, the fourth is
// dropped. Averages in light: by squares, near enough to sRGB's curve.
Thumbnail shrink(int width, int height, int channels, const std::vector<std::uint8_t>& pixels, int largest_side);

// All in a grid whose columns make it about 16:9. At least one.
measure::Raster contact_sheet(const std::vector<Thumbnail>& thumbnails);

}  // namespace airlight::sequence
