#pragma once
// The passes of a scene's sky, for any method and any number of wavelengths.

#include "core/methods/method.h"
#include "core/physics/physics.h"
#include "core/plan/plan.h"
#include "core/scene/scene.h"

namespace airlight {

struct Sky {
  BufferId radiance;                      // as SkyPasses::radiance
  std::vector<ImageId> tables;            // as SkyPasses::tables; for a scene with spectra group by group
  bool disc = false;                      // whether the disc is in the picture
  std::vector<ImageId> more_tables = {};  // as SkyPasses::more_tables
};

// Adds the method's passes and, if asked for, the sun's disc. A scene with spectra is rendered in groups of three
// wavelengths, which the scene's matrix sums to linear Rec.709; the transmittance of listed directions is then the
// colour of the sunlight that comes through. Fills the plan's scene data.
Sky add_sky(Plan& plan, const Scene& scene, const View& view, bool with_disc);

// Adds the disc alone to a buffer with this tile of the scene's picture. False: no part of the disc shows there.
bool add_disc_over(Plan& plan, const Scene& scene, BufferId radiance, const Tile& tile);

// Draws the disc alone, on the host, over this tile of a picture of the scene. False: no part of it shows there.
bool draw_disc_over(RadianceImage& rows, const Scene& scene, const Tile& tile);

// The sources of the sun's glare, in the picture's colours.
std::vector<physics::GlarePoint> glare_points_of(const Scene& scene);

// The picture by a host method, without the disc.
HostPicture render_on_host(const Scene& scene, const View& view, const HostOptions& options);

// As SkyMethod::spared.
std::vector<std::string> spared_by(const Scene& scene);

// Divisor that makes a listed direction's second value a transmittance.
Rgb transmittance_unit(const Scene& scene);

}  // namespace airlight
