#pragma once
// The pixels that the planet's edge crosses: means over a few rays each (shaders/physics/horizon.glsl).

#include <cstdint>
#include <memory>
#include <vector>

#include "core/scene/scene.h"

namespace airlight {

struct EdgePixel {
  std::uint32_t x = 0;  // from the tile's upper left pixel
  std::uint32_t y = 0;
};

// The tile's pixels at the edge, in no order that matters. The last few lists are remembered, so that frames and
// candidates that share a camera find theirs made.
std::shared_ptr<const std::vector<EdgePixel>> edge_pixels(const Scene& scene, const Tile& tile);

}  // namespace airlight
