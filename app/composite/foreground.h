#pragma once
// The picture that the air is put into, read and understood: its light in linear Rec.709, its cover, its distances.

#include <cstdint>
#include <string>
#include <vector>

#include "app/composite/order.h"
#include "core/composite/blend.h"
#include "core/foreign/foreign_picture.h"
#include "core/output/working_space.h"

namespace airlight::cli {

struct Foreground {
  foreign::Picture picture;              // as read; its other channels pass unchanged
  std::array<std::string, 3> colours{};  // channel names of red, green, blue
  std::string alpha;                     // empty: none
  WorkingSpace space = WorkingSpace::linear_rec709;
  std::vector<composite::Thing> things;  // of each pixel; deep: of each sample
  std::vector<float> distances;          // km, likewise
  std::vector<float> backs;              // deep with ZBack: km where each sample ends; else empty
  std::vector<std::uint32_t> pixel_of;   // deep: the pixel of each sample; else empty
  std::string camera;                    // where the camera comes from, for people
  composite::DepthCounts counts;
  std::size_t replaced = 0;  // opaque pixels without depth: the other program's own background
};

struct DepthPlace {
  std::string file;
  std::string channel;  // empty: the only one of depths
};

// Takes --depth "FILE:CHANNEL" apart at the last colon, unless no channel could follow it.
DepthPlace depth_place(const std::string& text, const std::string& beauty);

// Reads the files and sets the scene's picture size and, where the file tells it, its camera. Throws InputError: files
// that cannot be read, channels that are missing (those present are listed), sizes that differ, unknown primaries.
Foreground read_foreground(const CompositeOrder& order, const std::string& beauty, const std::string& depth,
                           Scene& scene);

}  // namespace airlight::cli
