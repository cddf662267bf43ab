#include "core/things/spheres.h"

#include "core/air/scene_block.h"

namespace airlight {

static_assert(static_cast<physics::uint>(SphereMaterial::matte) == physics::kSphereMatte &&
              static_cast<physics::uint>(SphereMaterial::mirror) == physics::kSphereMirror &&
              static_cast<physics::uint>(SphereMaterial::translucent) == physics::kSphereTranslucent);

std::vector<physics::SphereData> spheres_of(const Scene& scene) {
  physics::Physics p;
  std::vector<physics::SphereData> all;
  for (const Sphere& sphere : scene.spheres) {
    physics::SphereData data;
    data.centre = p.direction_from_angles(sphere.elevation, sphere.azimuth) * sphere.distance;
    data.radius = sphere.radius;
    data.albedo = vector_of(sphere.albedo);
    data.material = static_cast<physics::uint>(sphere.material);
    data.scatter_strength = sphere.scatter_strength;
    all.push_back(data);
  }
  return all;
}

}  // namespace airlight
