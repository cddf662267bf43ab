#include "core/methods/path_trace/sunbeam.h"

#include <algorithm>
#include <cmath>

namespace airlight {

using physics::vec3;

namespace {

constexpr double kApart = 1e-4;  // rad, of differences

double across(double mu) {
  return std::sqrt(std::max(1.0 - mu * mu, 0.0));
}

// The cosine of a zenith angle that is less by `angle`.
double raised(double mu, double angle) {
  return mu * std::cos(angle) + across(mu) * std::sin(angle);
}

}  // namespace

Sunbeam sunbeam(physics::Physics& physics, double h, double mu_sun) {
  const physics::PlanetData& planet = physics.scene.planet;
  if (!physics.refraction) {
    return {!physics.meets_ground(planet, h, mu_sun), mu_sun, 1.0};
  }
  Sunbeam beam{physics.sun_is_up(planet, h, mu_sun)};
  if (!beam.up) {
    return beam;
  }
  const double horizon = physics.horizon_mu(planet, h);
  const auto bending = [&](double mu) {
    return physics.bending_to_top(planet, h, std::max(mu, horizon), physics::kBendingSteps);
  };
  // Newton's steps toward angle = bending(true angle - angle), from the horizon up: they do not pass the root.
  constexpr int kMostSteps = 20;
  constexpr double kNear = 1e-9;
  double angle = std::max(std::acos(std::clamp(mu_sun, -1.0, 1.0)) - std::acos(horizon), 0.0);
  for (int i = 0; i < kMostSteps; ++i) {
    const double here = bending(raised(mu_sun, angle));
    const double slope = (here - bending(raised(mu_sun, angle + kApart))) / kApart;
    const double step = std::max(here - angle, 0.0) / (1.0 + slope);
    angle += step;
    if (step < kNear) {
      break;
    }
  }
  beam.mu = std::max(raised(mu_sun, angle), horizon);
  const double here = bending(beam.mu);
  const double one = bending(raised(beam.mu, kApart));
  const double two = bending(raised(beam.mu, 2.0 * kApart));
  beam.spread = physics.beam_spread(planet, h, beam.mu, here, (3.0 * here - 4.0 * one + two) / (2.0 * kApart));
  return beam;
}

double bending_to(physics::Physics& physics, const physics::Physics::Ray& ray,
                  const physics::Physics::RayPoint& point) {
  const physics::PlanetData& planet = physics.scene.planet;
  return physics.bending_ahead(planet, ray.falls, ray.h, ray.mu) -
         physics.bending_ahead(planet, ray.falls, point.h, point.mu);
}

LitPoint lit_point(physics::Physics& physics, const physics::Physics::Ray& ray, double t) {
  const physics::PlanetData& planet = physics.scene.planet;
  if (!physics.refraction) {
    const auto point = physics.point_on_ray(planet, ray, t);
    return {point, sunbeam(physics, point.h, point.mu_sun), ray.nu};
  }
  const auto straight = physics.point_on_ray(planet, ray, t);
  const double bent = bending_to(physics, ray, straight);
  const double s = across(straight.mu);
  const double ahead = s > 1e-9 ? (ray.nu - straight.mu * straight.mu_sun) / s : 0.0;
  LitPoint lit;
  lit.point = straight;
  lit.point.mu_sun = straight.mu_sun * std::cos(bent) + ahead * std::sin(bent);
  lit.beam = sunbeam(physics, lit.point.h, lit.point.mu_sun);
  const double level =
      (ahead * std::cos(bent) - straight.mu_sun * std::sin(bent)) / std::max(across(lit.point.mu_sun), 1e-9);
  lit.nu = std::clamp(straight.mu * lit.beam.mu + s * level * across(lit.beam.mu), -1.0, 1.0);
  return lit;
}

vec3 seen_sun(const Sunbeam& beam, const vec3& up, const vec3& sun) {
  const vec3 level = sun - up * dot(up, sun);
  const double size = length(level);
  return size > 1e-9 ? up * beam.mu + level * (across(beam.mu) / size) : sun;
}

}  // namespace airlight
