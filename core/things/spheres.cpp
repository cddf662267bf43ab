#include "core/things/spheres.h"

#include "core/air/scene_block.h"
#include "core/plan/bytes.h"

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
  std::vector<std::byte> bytes = bytes_of_one(count);
  for (const physics::SphereData& s : spheres) {
    const std::vector<std::byte> sphere = bytes_of_one(device::SphereData{
        narrowed(s.centre), narrowed(s.radius), narrowed(s.albedo), s.material, narrowed(s.scatter_strength)});
    bytes.insert(bytes.end(), sphere.begin(), sphere.end());
  }
  return plan.add_buffer(filled_buffer(name, std::move(bytes)));
}

}  // namespace airlight
