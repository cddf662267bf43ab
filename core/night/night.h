#pragma once
// The night sky of a scene, as pictures draw it: in the picture's colours and in the unit of the sun's irradiance.

#include <string_view>
#include <vector>

#include "core/air/air.h"
#include "core/physics/physics.h"
#include "core/scene/scene.h"

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

  void put_into(physics::Physics& p) const;
};

// The sky of a scene that has one, or stars. `air`: of its three channels.
Night night_of(const Scene& scene, const Air& air);

}  // namespace airlight
