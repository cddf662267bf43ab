#include "core/methods/path_trace/single_scattering.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace airlight {

using physics::vec3;
using Ray = physics::Physics::Ray;

namespace {

constexpr double kTolerance = 1e-6;    // of each channel of the ray's radiance
constexpr double kNegligible = 1e-16;  // radiance, far below any night sky
constexpr int kMostLevels = 24;
constexpr int kMostPanels = 20000;  // of a ray; an edge that no corner tells takes some 50

vec3 absolute(vec3 v) {
  return {std::abs(v.x), std::abs(v.y), std::abs(v.z)};
}

bool within(vec3 error, vec3 limit) {
  return error.x <= limit.x && error.y <= limit.y && error.z <= limit.z;
}

}  // namespace

// Radiance scattered once, per km of the ray.
struct SingleScattering::Integrand {
  const SingleScattering& single;
  const Ray& ray;
  physics::Physics::Phases phases;

  vec3 operator()(double t) const {
    physics::Physics& physics = single.physics_;
    const physics::Physics::RayPoint point = physics.point_on_ray(physics.scene.planet, ray, t);
    const vec3 scattering = physics.air_at(point.h, phases).phase_scattering;
    const vec3 sun = single.sunlight(point.h, point.mu_sun);
    if (!(sun.x > 0.0 || sun.y > 0.0 || sun.z > 0.0)) {
      return vec3(0.0);
    }
    return exp(-single.depth_.along(ray.h, ray.mu, t)) * scattering * sun;
  }
};

SingleScattering::SingleScattering(physics::Physics& physics, const OpticalDepth& depth, std::vector<double> edges)
    : physics_(physics), depth_(depth), edges_(std::move(edges)), rule_(gauss_legendre(8)) {}

vec3 SingleScattering::sunlight(double h, double mu_sun) const {
  if (physics_.meets_ground(physics_.scene.planet, h, mu_sun)) {
    return vec3(0.0);
  }
  return exp(-depth_.to_top(h, mu_sun));
}

// Where the ray crosses an edge of the air or of the planet's shadow, turns upward, begins and ends.
std::vector<double> SingleScattering::corners(const Ray& ray) const {
  std::vector<double> list{0.0, ray.length_};
  const auto add = [&](double t) {
    if (t > 0.0 && t < ray.length_) {
      list.push_back(t);
    }
  };
  const double r = physics_.scene.planet.ground_radius + ray.h;
  const double r_mu = r * ray.mu;
  add(-r_mu);
  for (const double h : edges_) {
    const double square = r_mu * r_mu + (h - ray.h) * (r + r + h - ray.h);
    if (square > 0.0) {
      add(-r_mu - std::sqrt(square));
      add(-r_mu + std::sqrt(square));
    }
  }
  // The shadow is a cylinder of the planet's radius around the line to the sun: a t^2 + 2 b t + c = 0 on its side.
  const double a = (1.0 - ray.nu) * (1.0 + ray.nu);
  const double b = r * (ray.mu - ray.mu_sun * ray.nu);
  const double c = ray.h * (r + physics_.scene.planet.ground_radius) - r * r * ray.mu_sun * ray.mu_sun;
  const double square = b * b - a * c;
  if (square > 0.0) {
    const double q = -(b + std::copysign(std::sqrt(square), b));
    if (a > 0.0) {
      add(q / a);
    }
    if (q != 0.0) {
      add(c / q);
    }
  }
  std::sort(list.begin(), list.end());
  return list;
}

vec3 SingleScattering::panel(const Integrand& f, double from, double to) const {
  vec3 sum(0.0);
  for (std::size_t k = 0; k < rule_.nodes.size(); ++k) {
    sum = sum + f(from + (to - from) * rule_.nodes[k]) * rule_.weights[k];
  }
  return sum * (to - from);
}

// Halves the panel until both halves together agree with the whole. The total grows as peaks are found that the first
// nodes missed.
vec3 SingleScattering::refine(const Integrand& f, double from, double to, vec3 whole, Budget& budget,
                              int levels) const {
  const double middle = 0.5 * (from + to);
  const vec3 first = panel(f, from, middle);
  const vec3 second = panel(f, middle, to);
  const vec3 both = first + second;
  budget.total = budget.total + both - whole;
  --budget.panels;
  if (levels == 0 || budget.panels <= 0 ||
      within(absolute(both - whole), absolute(budget.total) * kTolerance + vec3(kNegligible))) {
    return both;
  }
  const vec3 refined = refine(f, from, middle, first, budget, levels - 1);
  return refined + refine(f, middle, to, second, budget, levels - 1);
}

vec3 SingleScattering::radiance(const Ray& ray) const {
  if (!(ray.length_ >= 0.0)) {
    return vec3(0.0);
  }
  const Integrand f{*this, ray, physics_.phases(ray.nu)};
  const std::vector<double> at = corners(ray);
  std::vector<vec3> panels;
  Budget budget{vec3(0.0), kMostPanels};
  for (std::size_t k = 0; k + 1 < at.size(); ++k) {
    panels.push_back(panel(f, at[k], at[k + 1]));
    budget.total = budget.total + panels.back();
  }
  vec3 sum(0.0);
  for (std::size_t k = 0; k + 1 < at.size(); ++k) {
    sum = sum + refine(f, at[k], at[k + 1], panels[k], budget, kMostLevels);
  }
  cut_rays_ += budget.panels <= 0 ? 1 : 0;
  if (ray.at_ground) {
    const physics::PlanetData& planet = physics_.scene.planet;
    const double mu_sun = physics_.point_on_ray(planet, ray, ray.length_).mu_sun;
    const vec3 arrives = sunlight(0.0, mu_sun) * std::max(mu_sun, 0.0);
    sum = sum + exp(-depth_.along(ray.h, ray.mu, ray.length_)) * planet.ground_albedo * arrives / std::numbers::pi;
  }
  return sum;
}

}  // namespace airlight
