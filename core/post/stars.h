#pragma once
// Stars as points of a picture.

#include <cstdint>
#include <string_view>
#include <vector>

#include "core/base/radiance_image.h"
#include "core/post/post.h"

namespace airlight {

// A pixel of a tile, from its upper left one, and the radiance of its stars above the air.
struct StarPixel {
  std::uint32_t x = 0;
  std::uint32_t y = 0;
  physics::vec3 radiance{};
};

// Each star is shared among the four pixels whose middles are around it, by its distance from them: what it adds to
// radiance times solid angle is its irradiance, at any size, projection and tile. No pixel is listed twice.
std::vector<StarPixel> star_pixels(physics::Physics& p, const Scene& scene, const Night& night, const Tile& tile);

// A planet or a bright star that the picture shows: where it is seen, in rad and in pixels from the upper left corner.
struct NamedPoint {
  std::string_view name;
  double magnitude = 0.0;  // V, above the air
  double elevation = 0.0;
  double azimuth = 0.0;
  double x = 0.0;
  double y = 0.0;
};

// Those of the stage's stars, brightest first. Things and clouds may stand before them.
std::vector<NamedPoint> named_points(const Stage& stage);

// Adds the stage's stars, each pixel seen through a table of transmittance in the picture's colours.
void add_stars(Plan& plan, const Stage& stage, ImageId through, const Picture& picture);

// The same on the host. `p`: the stage's formulas.
void draw_stars(RadianceImage& picture, physics::Physics& p, const Stage& stage, const Tile& tile);

}  // namespace airlight
