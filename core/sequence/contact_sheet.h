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

// Indices of the `frames` on a sheet of at most `most`: evenly spread, with the first and the last; ascending.
std::vector<std::size_t> frames_shown(std::size_t frames, std::size_t most);

// A picture reduced to at most `largest_side` pixels on each side; smaller pictures stay. The source has 3 or 4
// `channels`; the fourth is dropped. It averages light: the squares of the values, close to sRGB's curve.
Thumbnail shrink(int width, int height, int channels, const std::vector<std::uint8_t>& pixels, int largest_side);

// All thumbnails, at least one, in a grid whose columns make it about 16:9.
measure::Raster contact_sheet(const std::vector<Thumbnail>& thumbnails);

}  // namespace airlight::sequence
