// The sun's glare: points of its disc as sources, found on the host in double.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <numbers>
#include <vector>

#include "core/air/scene_block.h"
#include "core/post/post.h"

namespace airlight {
namespace {

using physics::vec3;

constexpr int kRings = 4;
constexpr int kAround = 8;
constexpr int kPoints = kRings * kAround;
constexpr double kFar = 24.0;  // radii of the disc: from there on it is a point to 0.2 %

struct Source {
  vec3 direction;
  vec3 irradiance;
};

// At the camera, through the air; nothing where the planet hides the point.
vec3 disc_radiance(physics::Physics& p, const Scene& scene, const vec3& direction) {
  const auto ray =
      p.ray_in_atmosphere(p.scene.planet, scene.camera.altitude, direction.y, p.scene.sun.direction.y, 1.0);
  if (ray.at_ground) {
    return vec3(0.0);
  }
  const vec3 depth = ray.length_ < 0.0
                         ? vec3(0.0)
                         : p.optical_depth_to_top(p.scene.planet, ray.h, ray.mu, physics::kTransmittanceSteps);
  const double profile = p.disc_profile(p.scene.sun, physics::length(direction - p.scene.sun.direction));
  return p.scene.sun.disc_radiance * vec3(std::exp(-depth.x), std::exp(-depth.y), std::exp(-depth.z)) * profile;
}

// Points of equal area.
std::vector<Source> disc_sources(const Scene& scene, const Air& air) {
  physics::Physics p = formulas_of(air, scene);
  const vec3 sun = p.scene.sun.direction;
  const vec3 any = std::abs(sun.y) < 0.9 ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0);
  const vec3 a = physics::normalize(any - sun * physics::dot(any, sun));
  const vec3 b(sun.y * a.z - sun.z * a.y, sun.z * a.x - sun.x * a.z, sun.x * a.y - sun.y * a.x);
  const double radius = scene.sun.disc.angular_radius;
  const double half = std::sin(0.5 * radius);
  const double area = 4.0 * std::numbers::pi * half * half / kPoints;
  std::vector<Source> sources;
  for (int ring = 0; ring < kRings; ++ring) {
    const double off = radius * std::sqrt((ring + 0.5) / kRings);
    for (int k = 0; k < kAround; ++k) {
      const double t = 2.0 * std::numbers::pi * (k + 0.5 * (ring % 2)) / kAround;
      const vec3 direction = sun * std::cos(off) + (a * std::cos(t) + b * std::sin(t)) * std::sin(off);
      sources.push_back({direction, disc_radiance(p, scene, direction) * area});
    }
  }
  return sources;
}

Source sum_of(const std::vector<Source>& sources) {
  Source all{vec3(0.0), vec3(0.0)};
  for (const Source& source : sources) {
    all.irradiance = all.irradiance + source.irradiance;
    all.direction =
        all.direction + source.direction * (source.irradiance.x + source.irradiance.y + source.irradiance.z);
  }
  return all;
}

std::array<float, 8> packed(const Source& source, double far, double blur) {
  const auto f = [](double x) { return static_cast<float>(x); };
  return {f(source.direction.x),  f(source.direction.y),  f(source.direction.z),  f(far),
          f(source.irradiance.x), f(source.irradiance.y), f(source.irradiance.z), f(blur)};
}

}  // namespace

bool sun_glares(const Scene& scene, const Air& air) {
  if (!scene.sun.disc.visible) {
    return false;
  }
  const physics::Physics p = geometry_of(scene);
  const bool is_behind = scene.camera.projection == Projection::perspective &&
                         physics::dot(p.scene.sun.direction, p.scene.camera.forward) <= 0.0;
  const vec3 light = sum_of(disc_sources(scene, air)).irradiance;
  return !is_behind && light.x + light.y + light.z > 0.0;
}

GlareSources add_glare_sources(Plan& plan, const Scene& scene, const Air& air) {
  const std::vector<Source> sources = disc_sources(scene, air);
  const double radius = scene.sun.disc.angular_radius;
  Source all = sum_of(sources);
  const double length = physics::length(all.direction);
  all.direction = length > 0.0 ? all.direction * (1.0 / length) : sources.front().direction;
  std::vector<std::array<float, 8>> points{packed(all, kFar * radius, 0.0)};
  for (const Source& source : sources) {
    points.push_back(packed(source, 0.0, radius / std::sqrt(kPoints)));
  }
  std::vector<std::byte> contents(points.size() * sizeof points.front());
  std::memcpy(contents.data(), points.data(), contents.size());
  const std::size_t bytes = contents.size();
  return {plan.add_buffer({.name = "glare_sources", .bytes = bytes, .contents = std::move(contents), .key = {}}),
          static_cast<std::uint32_t>(points.size())};
}

}  // namespace airlight
