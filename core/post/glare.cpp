// The sun's glare: points of its disc as sources, found on the host in double.

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/air/refraction.h"
#include "core/air/scene_block.h"
#include "core/clouds/cloud_depth.h"
#include "core/plan/bytes.h"
#include "core/post/disc_parts.h"
#include "core/post/host_post.h"
#include "core/post/post.h"

namespace airlight {
namespace {

using physics::vec3;

constexpr int kGlareRings = 4;
constexpr int kGlareAround = 8;
constexpr int kPoints = kGlareRings * kGlareAround;
constexpr double kFar = 24.0;  // radii of the disc: from there on it is a point to 0.2 %

using physics::GlarePoint;

// Points of equal area on the disc.
std::vector<GlarePoint> disc_sources(const Part& part) {
  physics::Physics p = formulas_of(part.air, part.scene);
  p.sun_steps = physics::kTransmittanceSteps;
  part.things.put_into(p);
  const vec3 sun = p.scene.sun.direction;
  const auto [a, b] = across(sun);
  const double radius = part.scene.sun.disc.angular_radius;
  const double half = std::sin(0.5 * radius);
  const double area = 4.0 * std::numbers::pi * half * half / kPoints;
  std::vector<GlarePoint> sources;
  for (int ring = 0; ring < kGlareRings; ++ring) {
    const double off = radius * std::sqrt((ring + 0.5) / kGlareRings);
    for (int k = 0; k < kGlareAround; ++k) {
      const double t = 2.0 * std::numbers::pi * (k + 0.5 * (ring % 2)) / kGlareAround;
      const vec3 direction = sun * std::cos(off) + (a * std::cos(t) + b * std::sin(t)) * std::sin(off);
      const SeenDirection seen = seen_direction(p, direction);
      sources.push_back({seen.direction, 0.0,
                         p.disc_radiance(seen.direction) *
                             (area * seen.spread * past_clouds(part.things.clouds(), part.scene, seen.direction)),
                         radius / std::sqrt(kPoints)});
    }
  }
  return sources;
}

GlarePoint sum_of(const std::vector<GlarePoint>& sources) {
  GlarePoint all{};
  for (const GlarePoint& source : sources) {
    all.irradiance = all.irradiance + source.irradiance;
    all.direction =
        all.direction + source.direction * (source.irradiance.x + source.irradiance.y + source.irradiance.z);
  }
  return all;
}

// The point as the device reads it.
std::array<float, 8> packed(const GlarePoint& point) {
  const auto f = [](double x) { return static_cast<float>(x); };
  return {f(point.direction.x),  f(point.direction.y),  f(point.direction.z),  f(point.far),
          f(point.irradiance.x), f(point.irradiance.y), f(point.irradiance.z), f(point.blur)};
}

}  // namespace

bool sun_glares(const Part& part) {
  if (!part.scene.sun.disc.visible) {
    return false;
  }
  const physics::Physics p = geometry_of(part.scene);
  const bool is_behind = part.scene.camera.projection == Projection::perspective &&
                         physics::dot(p.scene.sun.seen, p.scene.camera.forward) <= 0.0;
  const vec3 light = sum_of(disc_sources(part)).irradiance;
  return !is_behind && light.x + light.y + light.z > 0.0;
}

std::vector<GlarePoint> glare_points(const Part& part) {
  std::vector<GlarePoint> points = disc_sources(part);
  GlarePoint all = sum_of(points);
  const double length = physics::length(all.direction);
  all.direction = length > 0.0 ? all.direction * (1.0 / length) : points.front().direction;
  all.far = kFar * part.scene.sun.disc.angular_radius;
  points.insert(points.begin(), all);
  return points;
}

GlareSources add_glare_sources(Plan& plan, const std::vector<GlarePoint>& all) {
  std::vector<std::array<float, 8>> points;
  for (const GlarePoint& point : all) {
    points.push_back(packed(point));
  }
  return {plan.add_buffer(filled_buffer("glare_sources", bytes_of(points))), static_cast<std::uint32_t>(points.size())};
}

RadianceImage glare_picture(const Scene& scene, const std::vector<GlarePoint>& points, const Tile& tile) {
  physics::Physics p = geometry_of(scene);
  p.glare_points = points;
  const auto count = static_cast<physics::uint>(p.glare_points.size());
  const physics::uint projection = projection_code(scene.camera.projection);
  const double blur = glare_pixel_blur(scene);
  RadianceImage glare{tile.width, tile.height, {}};
  glare.rgba.reserve(4 * static_cast<std::size_t>(tile.width) * static_cast<std::size_t>(tile.height));
  for (int y = tile.y; y < tile.y + tile.height; ++y) {
    for (int x = tile.x; x < tile.x + tile.width; ++x) {
      const auto ray = p.view_ray(p.scene.camera, projection, x + 0.5, y + 0.5);
      const vec3 light = ray.inside ? p.glare_along(ray.direction, count, blur) : vec3(0.0);
      for (const double channel : {light.x, light.y, light.z, 1.0}) {
        glare.rgba.push_back(static_cast<float>(channel));
      }
    }
  }
  return glare;
}

}  // namespace airlight
