#pragma once
// The passes of a scene's sky, for any method and any number of wavelengths.

#include "core/methods/method.h"
#include "core/physics/physics.h"
#include "core/plan/plan.h"
#include "core/post/post.h"
#include "core/scene/scene.h"

namespace airlight {

struct Sky {
  BufferId radiance;                      // as SkyPasses::radiance
  std::vector<ImageId> tables;            // as SkyPasses::tables; of several parts one after the other
  bool disc = false;                      // whether the disc is in the picture
  std::vector<ImageId> more_tables = {};  // as SkyPasses::more_tables
};

// Adds the method's passes and, if asked for, the disc, for each light in turn, of listed directions for the sun alone:
// of several parts a picture each, which their colours sum to linear Rec.709; the transmittance of listed directions is
// then the colour of the sunlight that comes through. Fills the plan's scene data.
Sky add_sky(Plan& plan, const Stage& stage, const View& view, bool with_disc);

// Draws the disc alone, on the host, over this tile of a picture of the stage. False: no part of it shows there.
bool draw_disc_over(RadianceImage& rows, const Stage& stage, const Tile& tile);

// Adds the night sky alone, over nothing, in this tile of the picture. Fills the plan's scene data.
BufferId add_night_picture(Plan& plan, const Stage& stage, const Tile& tile);

// What the method's clouds leave of a beam along each pixel's ray, of buffers added from the `first` on; none: there
// are no clouds. Parts have much the same.
std::optional<BufferId> cloud_transmittance(const Plan& plan, std::size_t first);

// Adds what clouds stand before to a picture.
void add_behind_clouds(Plan& plan, BufferId behind, BufferId through, const Picture& picture);

// The sources of the glare of the brightest light that the camera sees, in the picture's colours. Beside the sun's the
// moon's does not show.
std::vector<physics::GlarePoint> glare_points_of(const Stage& stage);

// Whether any light glares.
bool glares(const Stage& stage);

// As SkyMethod::spared.
std::vector<std::string> spared_by(const Stage& stage);

}  // namespace airlight
