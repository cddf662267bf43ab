#include "core/air/refraction.h"

#include <algorithm>
#include <cmath>

#include "core/scene/refractive_index.h"

namespace airlight {
namespace {

using physics::vec3;

// The altitude below `top` at which a rising function has this value.
template <class Rising>
double where(const Rising& f, double value, double top) {
  double low = 0.0;
  double high = top;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (f(middle) < value ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

constexpr physics::uint kSteps = 256;

// Needs the nodes' altitudes.
double sun_lift(physics::Physics& p, double g) {
  const physics::PlanetData& planet = p.scene.planet;
  const double horizon = p.horizon_mu(planet, g);
  const double bent = p.bending_to_top(planet, g, horizon, kSteps);
  const double mu = horizon * std::cos(bent) - std::sqrt(1.0 - horizon * horizon) * std::sin(bent);
  return (horizon - mu) / (1.0 - mu * mu);
}

}  // namespace

void put_planet(physics::Physics& p, const Planet& planet, const std::vector<Medium>& media) {
  p.scene.planet = {planet.ground_radius, planet.atmosphere_height, vector_of(planet.ground_albedo)};
  p.refraction = planet.refraction.has_value();
  if (!p.refraction) {
    return;
  }
  RefractiveIndex index(planet, media);
  p.scene.planet.ground_radius = index.at(0.0) * planet.ground_radius;
  p.scene.planet.atmosphere_height = index.optical_altitude(planet.atmosphere_height);
  p.scene.refraction.ground_radius = planet.ground_radius;
  constexpr physics::uint kCells = physics::kRefractionCells;
  for (physics::uint i = 0; i <= kCells; ++i) {
    const double u = static_cast<double>(i) / kCells;
    const double g = p.scene.planet.atmosphere_height * u * u;
    const double h = i == 0 ? 0.0
                     : i == kCells
                         ? planet.atmosphere_height
                         : where([&](double x) { return index.optical_altitude(x); }, g, planet.atmosphere_height);
    p.scene.refraction.nodes[i] = {h, 1.0 / index.curvature(h), 0.0};
  }
  for (physics::uint i = 0; i <= kCells; ++i) {
    const double u = static_cast<double>(i) / kCells;
    p.scene.refraction.nodes[i].z = sun_lift(p, p.scene.planet.atmosphere_height * u * u);
  }
}

double optical_altitude(const physics::Physics& p, double h) {
  if (!p.refraction) {
    return h;
  }
  physics::Physics::TrueAltitude top{};
  const physics::PlanetData& planet = p.scene.planet;
  auto& formulas = const_cast<physics::Physics&>(p);  // GLSL's functions have no const
  top = formulas.true_altitude(planet.atmosphere_height);
  if (h >= top.h) {
    return h - top.h + planet.atmosphere_height;
  }
  return where([&](double g) { return formulas.true_altitude(g).h; }, h, planet.atmosphere_height);
}

vec3 seen_direction(physics::Physics& p, const vec3& direction) {
  const physics::PlanetData& planet = p.scene.planet;
  const double g = p.scene.camera.altitude;
  if (!p.refraction || g > planet.atmosphere_height) {
    return direction;
  }
  const double level = std::sqrt(std::max(1.0 - direction.y * direction.y, 0.0));
  if (level < 1e-9) {
    return direction;
  }
  const double horizon = p.horizon_mu(planet, g);
  // Bending falls as the direction rises, so that what is too much grows.
  const auto excess = [&](double angle) {
    const double mu = direction.y * std::cos(angle) + level * std::sin(angle);
    return angle - p.bending_to_top(planet, g, std::max(mu, horizon), kSteps);
  };
  const double angle = where(excess, 0.0, 0.1);
  const double y = direction.y * std::cos(angle) + level * std::sin(angle);
  const double scale = (level * std::cos(angle) - direction.y * std::sin(angle)) / level;
  return {direction.x * scale, y, direction.z * scale};
}

}  // namespace airlight
