#pragma once
// What happens to a picture after the sky, on the host, for a method that renders there: the formulas of the passes
// (post.h), on double. Transmittance is integrated where the passes read a table.

#include "core/air/air.h"
#include "core/radiance_image.h"
#include "core/scene/scene.h"

namespace airlight {

// Adds the sun's disc to this much of the scene's picture. False: nothing of it can be seen there.
bool draw_sun_disc(RadianceImage& picture, const Scene& scene, const Air& air, const Tile& tile);

// The sun's glare over this much of the scene's picture, scene-linear, before bloom's intensity.
RadianceImage glare_picture(const Scene& scene, const Air& air, const Tile& tile);

}  // namespace airlight
