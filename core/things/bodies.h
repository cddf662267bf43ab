#pragma once
// The bodies of a scene (shaders/physics/bodies.glsl), ready for tracing and lighting.

#include <functional>
#include <string>
#include <vector>

#include "core/physics/device_scene.h"
#include "core/physics/physics.h"
#include "core/scene/scene.h"

namespace airlight {

using TellNumber = std::function<void(const std::string& key, double value)>;

// What the file of each kind defines, such as core/things/spheres.cpp:
//   spheres_of(scene): centres relative to the camera, km
//   narrowed(body): as the device has it
//   tell_spheres(scene, tell): all numbers of the preset that the bodies hang on
#define BODY_KIND(Data, one, all, bit, place)              \
  std::vector<physics::Data> all##_of(const Scene& scene); \
  device::Data narrowed(const physics::Data& body);        \
  void tell_##all(const Scene& scene, const TellNumber& tell);
BODY_KINDS(BODY_KIND)
#undef BODY_KIND

// Those of all kinds.
physics::HostBodies bodies_of(const Scene& scene);
void tell_bodies(const Scene& scene, const TellNumber& tell);

}  // namespace airlight
