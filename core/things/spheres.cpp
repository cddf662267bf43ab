#include "core/air/scene_block.h"
#include "core/things/bodies.h"

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

device::SphereData narrowed(const physics::SphereData& s) {
  return {narrowed(s.centre), narrowed(s.radius), narrowed(s.albedo), s.material, narrowed(s.scatter_strength)};
}

void tell_spheres(const Scene& scene, const TellNumber& tell) {
  for (std::size_t i = 0; i < scene.spheres.size(); ++i) {
    const Sphere& sphere = scene.spheres[i];
    const std::string here = "/scene/spheres/" + std::to_string(i);
    tell(here + "/azimuth (rad)", sphere.azimuth);
    tell(here + "/elevation (rad)", sphere.elevation);
    tell(here + "/distance (km)", sphere.distance);
    tell(here + "/radius (km)", sphere.radius);
    tell(here + "/material", static_cast<int>(sphere.material));
    for (std::size_t c = 0; c < 3; ++c) {
      tell(here + "/albedo/" + std::to_string(c), sphere.albedo[c]);
    }
    if (sphere.material == SphereMaterial::translucent) {
      tell(here + "/scatter_strength", sphere.scatter_strength);
    }
  }
}

}  // namespace airlight
