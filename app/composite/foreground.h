#pragma once
// The picture that gets the air, decoded: its light in linear Rec.709, its coverage, its distances.

#include <cstdint>
#include <string>
#include <vector>

#include "app/composite/mend.h"
#include "app/composite/order.h"
#include "core/composite/blend.h"
#include "core/foreign/foreign_picture.h"
#include "core/output/working_space.h"

namespace airlight::cli {

struct Foreground {
  foreign::Picture picture;              // as read, its light mended; other channels pass unchanged
  std::array<std::string, 3> colours{};  // channel names of red, green, blue
  std::string alpha;                     // empty: none
  WorkingSpace space = WorkingSpace::linear_rec709;
  std::vector<composite::Thing> things;  // one for each pixel; for a deep picture for each sample
  std::vector<float> distances;          // km, one for each thing
  std::vector<float> backs;              // for a deep picture with ZBack: km at which each sample ends; else empty
  std::vector<std::uint32_t> pixel_of;   // for a deep picture: the pixel of each sample; else empty
  std::string camera;                    // source of the camera, for people
  composite::DepthCounts counts;
  MendedLight mended;
  std::size_t replaced = 0;  // opaque pixels without depth: the other program's own background
};

struct DepthPlace {
  std::string file;
  std::string channel;  // empty: the only depth channel
};

// Splits --depth "FILE:CHANNEL" at the last colon, unless no channel could follow it.
DepthPlace depth_place(const std::string& text, const std::string& beauty);

// Reads the files; sets the scene's picture size and, if the file has one, its camera. Throws InputError: files that
// cannot be read, missing channels (existing ones are listed), differing sizes, unknown primaries.
Foreground read_foreground(const CompositeOrder& order, const std::string& beauty, const std::string& depth,
                           Scene& scene);

}  // namespace airlight::cli
