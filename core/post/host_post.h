#pragma once
// What happens to a picture after the sky, on the host, for a method that renders there: the formulas of the passes
// (post.h), on double. Transmittance is integrated where the passes read a table.

#include <cstddef>
#include <vector>

#include "core/air/air.h"
#include "core/physics/physics.h"
#include "core/post/post.h"
#include "core/radiance_image.h"
#include "core/scene/scene.h"

namespace airlight {

// Adds the sun's disc to this much of the scene's picture. False: nothing of it can be seen there.
bool draw_sun_disc(RadianceImage& picture, const Scene& scene, const Air& air, const Tile& tile);

// Statistics of rows, as their pass leaves them (post.h), for summarize().
std::vector<std::byte> row_statistics_of(const RadianceImage& rows, double brightest, bool signed_colours);

// Of the scene's picture, read back.
Statistics picture_statistics(const RadianceImage& radiance, const Scene& scene);

// Of a table read back. A pass for it would take a first start's compiler longer than the host takes for the table.
Statistics table_statistics(const RadianceImage& table);

// The sun's glare over this much of the scene's picture, scene-linear, before bloom's intensity. `points`: of
// glare_points().
RadianceImage glare_picture(const Scene& scene, const std::vector<physics::GlarePoint>& points, const Tile& tile);

}  // namespace airlight
