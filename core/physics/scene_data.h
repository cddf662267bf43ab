#pragma once
// Scene -> what the physics reads, on double for the host and on float for the device.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/physics/device_scene.h"
#include "core/physics/physics.h"
#include "core/scene/scene.h"

namespace airlight {

// Formulas and scene on double; tables empty.
physics::Physics make_physics(const Scene& scene);

device::SceneData device_scene(const Scene& scene);

// The same as bytes, for Plan::scene_data; of a plan that renders one tile of the picture, or all of it.
std::vector<std::byte> device_scene_bytes(const Scene& scene);
std::vector<std::byte> device_scene_bytes(const Scene& scene, const Tile& tile);

// Four bits a medium, as the specialisation constants kDensityProfiles and kPhaseFunctions hold them.
std::uint32_t density_profile_codes(const Scene& scene);
std::uint32_t phase_function_codes(const Scene& scene);

// Bit i: medium i scatters.
std::uint32_t scattering_media(const Scene& scene);

std::uint32_t projection_code(Projection projection);

// The camera's axes in the preset's frame. Positive roll turns the camera clockwise as its operator sees it, so the
// horizon's right end rises in the picture.
struct CameraBasis {
  physics::vec3 right;
  physics::vec3 up;
  physics::vec3 forward;
};
CameraBasis camera_basis(const Camera& camera);

}  // namespace airlight
