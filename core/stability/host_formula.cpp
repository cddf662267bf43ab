// The methods' formulas on the host in double: what the device's 32 bits are measured against.

#include <algorithm>
#include <cmath>
#include <string_view>

#include "core/methods/analytic_sky.h"
#include "core/methods/march_passes.h"
#include "core/methods/marched_picture.h"
#include "core/methods/scene_air.h"
#include "core/stability/shot.h"

namespace airlight::stability {
namespace {

using physics::Physics;
using physics::vec3;

double as_float(double x) {
  return static_cast<double>(static_cast<float>(x));
}

vec3 as_floats(const vec3& v) {
  return {as_float(v.x), as_float(v.y), as_float(v.z)};
}

Physics::Ray ray_toward(Physics& p, const Direction& d) {
  const vec3 sun = p.scene.sun.direction;
  const vec3 view = as_floats(p.direction_from_angles(d.elevation, d.azimuth));
  return p.ray_in_atmosphere(p.scene.planet, p.scene.camera.altitude, view.y, sun.y, physics::dot(view, sun));
}

template <class F>
std::vector<vec3> along(Physics& p, const std::vector<Direction>& directions, const F& radiance) {
  p.scene.sun.direction = as_floats(p.scene.sun.direction);
  std::vector<vec3> out;
  for (const Direction& d : directions) {
    out.push_back(radiance(ray_toward(p, d)));
  }
  return out;
}

std::uint32_t constant_of(const Plan& plan, std::string_view name) {
  for (const PassDesc& pass : plan.passes()) {
    for (const Specialization& constant : pass.specialization) {
      if (constant.name == name) {
        return constant.value;
      }
    }
  }
  return 0;
}

physics::HostTable table_of(const Shot& shot, const std::string& name) {
  const auto found = shot.tables.find(name);
  return found == shot.tables.end() ? physics::HostTable() : found->second;
}

std::vector<vec3> marched(const Scene& scene, const Shot& shot, const std::vector<Direction>& directions) {
  Physics p = make_physics(scene);
  p.transmittance_lut = table_of(shot, "transmittance");
  p.multiple_scattering_lut = table_of(shot, "multiple_scattering");
  p.ground_irradiance_lut = table_of(shot, "ground_irradiance");
  const auto steps = static_cast<physics::uint>(scene.render.get<int>("steps"));
  const std::uint32_t distribution = step_distribution_code(scene);
  const double place = place_in_step(scene);
  return along(p, directions, [&](const Physics::Ray& ray) {
    return p.march_at(p.scene.planet, p.scene.sun, ray, steps, distribution, place, p.scene.multiple_scattering_scale)
        .radiance;
  });
}

std::vector<vec3> nested(const Scene& scene, const std::vector<Direction>& directions) {
  Physics p = make_physics(scene);
  p.sun_steps = static_cast<physics::uint>(scene.render.get<int>("sun_steps"));
  p.multiple_scattering_lut = {1, 1, {vec3(0.0)}};
  p.ground_irradiance_lut = {1, 1, {vec3(0.0)}};
  const auto steps = static_cast<physics::uint>(scene.render.get<int>("steps"));
  const std::uint32_t distribution = step_distribution_code(scene);
  const double place = place_in_step(scene);
  return along(p, directions, [&](const Physics::Ray& ray) {
    return p.march_at(p.scene.planet, p.scene.sun, ray, steps, distribution, place, 0.0).radiance;
  });
}

std::vector<vec3> by_moments(const Scene& scene, const Shot& shot, const std::vector<Direction>& directions) {
  Physics p = make_physics(scene);
  p.transmittance_lut = table_of(shot, "transmittance");
  p.moments_lut = table_of(shot, "moments");
  p.moment_columns = constant_of(shot.plan, "kMomentColumns");
  p.degree = constant_of(shot.plan, "kMomentDegree");
  p.delta = constant_of(shot.plan, "kDeltaScaled") != 0;
  p.sun_table = table_of(shot, "sun_table");
  const auto steps = static_cast<physics::uint>(scene.render.get<int>("steps"));
  const physics::uint shells = p.shell_rows() > 0 ? p.shell_rows() - 1 : 0;
  const physics::uint parts = shells > 0 ? std::max((steps + shells / 2) / shells, 1U) : 0;
  return along(p, directions, [&](const Physics::Ray& ray) {
    const Physics::SkyFactors factors = shells > 0 ? p.shell_sky_factors(p.scene.planet, p.scene.moments, ray, parts)
                                                   : p.sky_factors(p.scene.planet, p.scene.moments, ray, steps);
    return p.phased(factors, p.phases(ray.nu)) * p.scene.sun.irradiance;
  });
}

std::vector<vec3> closed_form(const Scene& scene, const std::vector<Direction>& directions) {
  Physics p = make_analytic_physics(air_of(scene), scene);
  const bool exponential = scene.render.get<std::string>("variant") == "exponential";
  return along(p, directions, [&](const Physics::Ray& ray) {
    return exponential ? p.analytic_exponential(p.scene.planet, p.scene.sun, ray, p.scene.sun.direction.y).radiance
                       : p.analytic_zenith_density(p.scene.planet, p.scene.sun, ray).radiance;
  });
}

}  // namespace

std::vector<vec3> in_double(const Scene& scene, const Shot& shot, const std::vector<Direction>& directions) {
  const std::string& method = scene.render.method;
  if (method == "march") {
    return marched(scene, shot, directions);
  }
  if (method == "nested") {
    return nested(scene, directions);
  }
  if (method == "orders") {
    return by_moments(scene, shot, directions);
  }
  if (method == "analytic") {
    return closed_form(scene, directions);
  }
  return {};
}

}  // namespace airlight::stability
