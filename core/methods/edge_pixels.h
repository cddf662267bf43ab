#pragma once
// The pixels that the planet's edge crosses. Each is a mean over a few rays (shaders/physics/horizon.glsl).

#include <cstdint>
#include <memory>
#include <vector>

#include "core/scene/scene.h"

namespace airlight {

struct EdgePixel {
  std::uint32_t x = 0;  // from the tile's upper left pixel
  std::uint32_t y = 0;
};

// The tile's pixels at the edge; their order has no meaning. The last few lists are remembered, so that frames and
// candidates with the same camera share one.
std::shared_ptr<const std::vector<EdgePixel>> edge_pixels(const Scene& scene, const Tile& tile);

}  // namespace airlight
