// The methods' formulas on the host in double, with which the device's 32 bits are compared.

#include "core/methods/ready.h"
#include "core/stability/shot.h"

namespace airlight::stability {
namespace {

using physics::Physics;
using physics::vec3;

vec3 as_floats(const vec3& v) {
  return {as_float(v.x), as_float(v.y), as_float(v.z)};
}

}  // namespace

std::vector<vec3> in_double(const Scene& scene, const Shot& shot, const std::vector<Direction>& directions) {
  const SkyMethod& method = *find_method(scene.render.method);
  // In air that bends light the sun's light comes from a table that these formulas do not take.
  if (method.formula == nullptr || scene.planet.refraction) {
    return {};
  }
  const Part part = ready(scene).whole();
  Physics p = formulas_of(part.air, scene);
  const vec3 sun = as_floats(p.scene.sun.direction);
  p.scene.sun.direction = sun;
  const RayFormula radiance = method.formula(p, part, shot.tables);
  std::vector<vec3> out;
  for (const Direction& d : directions) {
    const vec3 view = as_floats(p.direction_from_angles(d.elevation, d.azimuth));
    out.push_back(
        radiance(p.ray_in_atmosphere(p.scene.planet, p.scene.camera.altitude, view.y, sun.y, physics::dot(view, sun))));
  }
  return out;
}

}  // namespace airlight::stability
