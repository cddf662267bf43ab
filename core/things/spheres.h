#pragma once
// The spheres of a scene, ready for tracing and lighting.

#include <vector>

#include "core/physics/physics.h"
#include "core/scene/scene.h"

namespace airlight {

// Centres relative to the camera, km.
std::vector<physics::SphereData> spheres_of(const Scene& scene);

}  // namespace airlight
