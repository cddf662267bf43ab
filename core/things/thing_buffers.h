#pragma once
// The things of a scene as what a pass reads.

#include <vector>

#include "core/plan/plan.h"
#include "core/things/things.h"

namespace airlight {

// What shaders/shared/things.glsl reads; where a thing is missing its buffers hold none.
struct ThingInputs {
  std::vector<Binding> reads;
  std::vector<Specialization> constants;
};
ThingInputs add_things(Plan& plan, const Scene& scene, const Things& things);

// The pass as it is where things hide what it draws: its shader's twin, SHADER_things, which reads them. The pass as it
// is where none stand in the air.
PassDesc behind_things(Plan& plan, const Scene& scene, const Things& things, PassDesc pass);

// The part of it that is the ground by maps (shaders/shared/ground_maps.glsl).
std::vector<Binding> add_ground_maps(Plan& plan, const Scene& scene, const Things& things);

}  // namespace airlight
