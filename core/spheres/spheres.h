#pragma once
// The spheres of a scene as those who trace and light them want them.

#include <vector>

#include "core/physics/physics.h"
#include "core/plan/plan.h"
#include "core/scene/scene.h"

namespace airlight {

// In the camera's place, km.
std::vector<physics::SphereData> spheres_of(const Scene& scene);

// The same in a plan, under a name of its own there (shaders/shared/sphere_list.glsl).
BufferId add_spheres(Plan& plan, const char* name, const Scene& scene);

}  // namespace airlight
