#pragma once
// The spheres of a scene, ready for tracing and lighting.

#include <vector>

#include "core/physics/physics.h"
#include "core/plan/plan.h"
#include "core/scene/scene.h"

namespace airlight {

// Centres relative to the camera, km.
std::vector<physics::SphereData> spheres_of(const Scene& scene);

// The same spheres in a plan, as a buffer of this name (shaders/shared/sphere_list.glsl).
BufferId add_spheres(Plan& plan, const char* name, const Scene& scene);

}  // namespace airlight
