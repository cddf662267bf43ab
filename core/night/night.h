#pragma once
// The night sky of a scene, as pictures draw it: in the picture's colours or at wavelengths, in the unit of the sun's
// irradiance.

#include <span>
#include <string_view>
#include <vector>

#include "core/air/air.h"
#include "core/physics/physics.h"
#include "core/scene/scene.h"
#include "core/spectra/colour.h"

namespace airlight {

struct NightStar {
  physics::vec3 direction;   // in the preset's frame
  physics::vec3 irradiance;  // above the air
  std::string_view name;     // of a planet or a bright star; empty: of another
  double magnitude = 0.0;    // V, above the air
};

struct Night {
  // As of shaders/physics/night_sky.glsl.
  std::vector<physics::vec3> beyond;
  std::vector<physics::vec3> scattered;
  physics::vec3 airglow{};
  physics::vec3 ground{};  // irradiance on level ground
  std::vector<NightStar> stars;

  // The table of shaders/physics/night_sky.glsl.
  physics::HostTable table() const;
};

// The air as the night's light goes through it.
struct NightAirs {
  std::vector<Air> airs;   // the first is the camera's
  std::vector<double> nm;  // of their channels, ascending, where they are the parts of a scene in colours; else empty
};

// The sky of a scene that has one, or stars. `bands`, nm: of the air's three channels, of a scene with spectra; values
// are then as a part's, radiance over the sun's in the band times the irradiance that the preset gives. Empty: the
// channels are red, green and blue.
Night night_of(const Scene& scene, const NightAirs& through, std::span<const WaveBand> bands = {});

// Greatest error, a share, of the colours of that sky's own spectra summed by the basis: of airglow and lamps, whose
// lines lie between a few wavelengths. 0: the scene has neither.
double night_colour_error(const Scene& scene, const ColourMatrix& matrix, const Nodes& nodes);

}  // namespace airlight
