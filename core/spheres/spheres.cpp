#include "core/spheres/spheres.h"

#include <cstring>

#include "core/air/scene_block.h"

namespace airlight {
namespace {

physics::uint code_of(SphereMaterial material) {
  switch (material) {
    case SphereMaterial::mirror:
      return physics::kSphereMirror;
    case SphereMaterial::translucent:
      return physics::kSphereTranslucent;
    case SphereMaterial::matte:
      break;
  }
  return physics::kSphereMatte;
}

}  // namespace

std::vector<physics::SphereData> spheres_of(const Scene& scene) {
  physics::Physics p;
  std::vector<physics::SphereData> all;
  for (const Sphere& sphere : scene.spheres) {
    physics::SphereData data;
    data.centre = p.direction_from_angles(sphere.elevation, sphere.azimuth) * sphere.distance;
    data.radius = sphere.radius;
    data.albedo = vector_of(sphere.albedo);
    data.material = code_of(sphere.material);
    data.scatter_strength = sphere.scatter_strength;
    all.push_back(data);
  }
  return all;
}

BufferId add_spheres(Plan& plan, const char* name, const Scene& scene) {
  const std::vector<physics::SphereData> spheres = spheres_of(scene);
  const auto count = static_cast<device::uint>(spheres.size());
  std::vector<std::byte> bytes(sizeof count + spheres.size() * sizeof(device::SphereData));
  std::memcpy(bytes.data(), &count, sizeof count);
  for (std::size_t i = 0; i < spheres.size(); ++i) {
    const physics::SphereData& s = spheres[i];
    const device::SphereData data{narrowed(s.centre), static_cast<float>(s.radius), narrowed(s.albedo), s.material,
                                  static_cast<float>(s.scatter_strength)};
    std::memcpy(bytes.data() + sizeof count + i * sizeof data, &data, sizeof data);
  }
  const std::size_t size = bytes.size();
  return plan.add_buffer({.name = name, .bytes = size, .contents = std::move(bytes), .key = {}});
}

}  // namespace airlight
