#pragma once
// The scene as the physics reads it: the air (air.h) with the picture's own sun, camera and tile, on double for the
// host and on float for the device.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/air/air.h"
#include "core/physics/device_scene.h"
#include "core/physics/physics.h"
#include "core/scene/scene.h"

namespace airlight {

// The air's formulas under the scene's sun, seen from its camera; tables empty.
physics::Physics formulas_of(const Air& air, const Scene& scene);

// The same without air: planet, sun and camera, for who asks for directions and distances alone.
physics::Physics geometry_of(const Scene& scene);

// For Plan::scene_data, the block and its tables; of a plan that renders one tile of the picture, or all of it.
std::vector<std::byte> device_scene_bytes(const Air& air, const Scene& scene);
std::vector<std::byte> device_scene_bytes(const Air& air, const Scene& scene, const Tile& tile);
std::vector<std::byte> device_scene_bytes(const physics::Physics& p, const Tile& tile);

// In float: a number, a vector, the block.
inline float narrowed(double x) {
  return static_cast<float>(x);
}
inline device::vec3 narrowed(const physics::vec3& v) {
  return {narrowed(v.x), narrowed(v.y), narrowed(v.z)};
}
device::SceneData narrowed(const physics::SceneData& data);

// What shaders know as `scene_tables`.
std::vector<std::byte> narrowed_tables(const physics::Physics& p);

inline std::uint32_t projection_code(Projection projection) {
  return static_cast<std::uint32_t>(projection);
}

// The camera's axes in the preset's frame. Positive roll turns the camera clockwise as its operator sees it, so the
// horizon's right end rises in the picture.
struct CameraBasis {
  physics::vec3 right;
  physics::vec3 up;
  physics::vec3 forward;
};
CameraBasis camera_basis(const Camera& camera);

// The share of light without polarisation that reaches the picture: a half through a polarising filter.
inline double light_passed(const Camera& camera) {
  return camera.polariser ? 0.5 : 1.0;
}

}  // namespace airlight
