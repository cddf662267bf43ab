#pragma once
// A reference that shares no distance, map, segment or table with the march.

#include <algorithm>
#include <cmath>

#include "core/physics/physics.h"

namespace airlight::test {

// Single scattering by brute force: positions as vectors, shadow by the closest approach of the sun's ray, optical
// depths by uniform midpoints. It shares the media and the phase functions, but no distance, map, segment or table.
class BruteForce {
 public:
  explicit BruteForce(physics::Physics& p) : p_(p) {}

  physics::vec3 radiance(double h, const physics::vec3& view, int steps, int sun_steps) {
    const physics::vec3 start(0.0, radius() + h, 0.0);
    const physics::vec3 sun = p_.scene.sun.direction;
    double length = exit_distance(start, view);
    const double ground = ground_distance(start, view);
    length = ground >= 0.0 ? std::min(length, ground) : length;
    const auto phases = p_.phases(physics::dot(view, sun));
    physics::vec3 sum;
    physics::vec3 depth;
    // Steps grow as the cube of their number: dense at the camera, and unlike the march's own.
    double at = 0.0;
    for (int i = 0; i < steps; ++i) {
      const double next = length * std::pow((i + 1.0) / steps, 3);
      const double width = next - at;
      const physics::vec3 point = start + view * (at + 0.5 * width);
      at = next;
      const double altitude = std::max(physics::length(point) - radius(), 0.0);
      const auto air = p_.air_at(altitude, phases);
      const physics::vec3 middle = depth + air.extinction * (0.5 * width);
      depth = depth + air.extinction * width;
      if (ground_distance(point, sun) < 0.0) {
        sum = sum + physics::exp(-(middle + optical_depth(point, sun, sun_steps))) * air.phase_scattering * width;
      }
    }
    return sum * p_.scene.sun.irradiance;
  }

 private:
  double radius() const { return p_.scene.planet.ground_radius; }

  double exit_distance(const physics::vec3& from, const physics::vec3& direction) const {
    const double top = radius() + p_.scene.planet.atmosphere_height;
    const double b = physics::dot(from, direction);
    return -b + std::sqrt(b * b - physics::dot(from, from) + top * top);
  }

  // Negative where the line passes above the ground or the ground lies behind.
  double ground_distance(const physics::vec3& from, const physics::vec3& direction) const {
    const double b = physics::dot(from, direction);
    const physics::vec3 nearest = from - direction * b;
    if (b >= 0.0 || physics::length(nearest) >= radius()) {
      return -1.0;
    }
    return -b - std::sqrt(radius() * radius() - physics::dot(nearest, nearest));
  }

  physics::vec3 optical_depth(const physics::vec3& from, const physics::vec3& direction, int steps) {
    const double length = exit_distance(from, direction);
    physics::vec3 depth;
    for (int i = 0; i < steps; ++i) {
      const double u = (i + 0.5) / steps;
      const physics::vec3 point = from + direction * (length * u * u);
      depth = depth + p_.extinction_at(std::max(physics::length(point) - radius(), 0.0)) * (length * 2.0 * u / steps);
    }
    return depth;
  }

  physics::Physics& p_;
};

}  // namespace airlight::test
