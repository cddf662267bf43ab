#pragma once
// A picture's post-processing on the host, for a method that renders there: the formulas of the passes (post.h), on
// double. Transmittance is integrated where the passes read a table.

#include <cstddef>
#include <vector>

#include "core/base/radiance_image.h"
#include "core/physics/physics.h"
#include "core/post/post.h"
#include "core/scene/scene.h"
#include "core/stage/stage.h"

namespace airlight {

// Adds the sun's disc to the tile of the scene's picture. False: no part of the disc shows there.
bool draw_sun_disc(RadianceImage& picture, const Part& part, const Tile& tile);

// Statistics of rows in the format of their pass (post.h), for summarize().
std::vector<std::byte> row_statistics_of(const RadianceImage& rows, double brightest, bool signed_colours);

// Statistics of the scene's picture, read back.
Statistics picture_statistics(const RadianceImage& radiance, const Scene& scene);

// Statistics of a table, read back. At a first start a pass for it would take longer to compile than the host takes.
Statistics table_statistics(const RadianceImage& table);

// The sun's glare over the tile of the scene's picture, scene-linear, before bloom's intensity. `points`: from
// glare_points().
RadianceImage glare_picture(const Scene& scene, const std::vector<physics::GlarePoint>& points, const Tile& tile);

}  // namespace airlight
