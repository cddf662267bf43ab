#include "core/things/spheres.h"

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

}  // namespace airlight
