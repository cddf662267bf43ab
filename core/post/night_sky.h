#pragma once
// The night sky in a picture.

#include "core/base/radiance_image.h"
#include "core/post/post.h"

namespace airlight {

// Adds the stage's night sky, seen through a table of transmittance in the picture's colours.
void add_night_sky(Plan& plan, const Stage& stage, ImageId through, const Picture& picture);

// The same and stars on the host in double, where transmittance is integrated: over a tile of the picture, and in one
// direction. Things do not hide it.
void draw_night_sky(RadianceImage& picture, const Stage& stage, const Tile& tile);
physics::vec3 night_sky_along(physics::Physics& p, const physics::vec3& direction);
physics::Physics night_formulas(const Stage& stage);

}  // namespace airlight
