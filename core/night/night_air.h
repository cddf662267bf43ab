#pragma once
// Light that the air scatters out of an even sky above it, in the mean over azimuths.

#include <vector>

#include "core/air/air.h"
#include "core/physics/physics.h"

namespace airlight {

struct NightAir {
  // Radiance by zenith cosine of the view from one altitude, of a sky of radiance 1 above the air: by night_slope() of
  // shaders/physics/night_sky.glsl.
  std::vector<physics::vec3> scattered;
  physics::vec3 ground;  // irradiance on level ground
};

enum class NightSource { sky, ground };

// Orders of scattering one after the other over level altitudes, each scattered evenly into all directions; the ground
// reflects. `camera`: altitude, km. Of the source `ground`: the ground shines with the radiance 1, under a black sky;
// what a ray sees of it is in `scattered`.
NightAir night_air(const Air& air, double camera, NightSource source = NightSource::sky);

}  // namespace airlight
