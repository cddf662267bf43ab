#pragma once
// The passes of a scene's sky, whatever its method and however many wavelengths it has.

#include "core/methods/method.h"
#include "core/physics/physics.h"
#include "core/plan/plan.h"
#include "core/scene/scene.h"

namespace airlight {

struct Sky {
  BufferId radiance;                      // as SkyPasses::radiance
  std::vector<ImageId> tables;            // as SkyPasses::tables; of a scene with spectra group by group
  bool disc = false;                      // whether it is in the picture
  std::vector<ImageId> more_tables = {};  // as SkyPasses::more_tables
};

// The method's passes and, if asked for, the sun's disc. A scene with spectra is rendered in groups of three
// wavelengths, whose sum by the scene's matrix is in linear Rec.709; the listed directions' transmittance is then the
// colour of the sun's light that comes through. Fills the plan's scene data.
Sky add_sky(Plan& plan, const Scene& scene, const View& view, bool with_disc);

// The disc alone, added to a buffer of this much of the scene's picture. False: nothing of it can be seen.
bool add_disc_over(Plan& plan, const Scene& scene, BufferId radiance, const Tile& tile);

// The disc alone, on the host, over this much of a picture of the scene. False: nothing of it can be seen.
bool draw_disc_over(RadianceImage& rows, const Scene& scene, const Tile& tile);

// The sources of the sun's glare, in the picture's colours.
std::vector<physics::GlarePoint> glare_points_of(const Scene& scene);

// The picture by a host method, which has no disc.
HostPicture render_on_host(const Scene& scene, const View& view, const HostOptions& options);

// As SkyMethod::spared.
std::vector<std::string> spared_by(const Scene& scene);

// What a listed direction's second value is to be divided by to be a transmittance.
Rgb transmittance_unit(const Scene& scene);

}  // namespace airlight
