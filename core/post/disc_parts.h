#pragma once
// The place of the sun's disc in a picture.

#include <array>
#include <cstdint>
#include <vector>

#include "core/physics/physics.h"
#include "core/scene/scene.h"

namespace airlight {

// Pixels of the picture.
struct DiscRectangle {
  std::uint32_t left = 0;
  std::uint32_t top = 0;
  std::uint32_t width = 0;
  std::uint32_t height = 0;
};

struct DiscPart {
  DiscRectangle pixels;  // that the disc may touch
  physics::Physics::DiscBox box;
};

// Two directions at right angles to the axis and to one another.
std::array<physics::vec3, 2> across(const physics::vec3& axis);

// The visible parts of the disc in the tile: one, or several where the picture is a map that is cut. No two overlap.
// Empty: the disc is switched off, outside the tile or wholly behind the planet. `p`: the scene's geometry.
std::vector<DiscPart> disc_parts(physics::Physics& p, const Scene& scene, const Tile& tile);

}  // namespace airlight
