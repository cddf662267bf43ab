#pragma once
// The pixels that the planet's edge crosses. Each is a mean over a few rays (shaders/physics/horizon.glsl).

#include <cstdint>
#include <string>
#include <vector>

#include "core/scene/scene.h"

namespace airlight {

struct EdgePixel {
  std::uint32_t x = 0;
  std::uint32_t y = 0;
};

// The picture's pixels at the edge; their order has no meaning.
std::vector<EdgePixel> edge_pixels_of(const Scene& scene);

// Two scenes of equal keys have the same.
std::string edge_key(const Scene& scene);

}  // namespace airlight
