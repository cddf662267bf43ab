#pragma once
// The sun as a point of the air sees it, by exact rays where the air bends light.

#include "core/physics/physics.h"

namespace airlight {

struct Sunbeam {
  bool up = false;      // not behind the planet
  double mu = 0.0;      // zenith cosine of the sun that is seen there
  double spread = 1.0;  // irradiance over that of the same beam unbent
};

// `mu_sun`: zenith cosine of the true sun.
Sunbeam sunbeam(physics::Physics& physics, double h, double mu_sun);

// Bending of a ray up to one of its points, rad; 0 where the air bends no light.
double bending_to(physics::Physics& physics, const physics::Physics::Ray& ray, const physics::Physics::RayPoint& point);

// A point of a ray, with the true sun as it stands there.
struct LitPoint {
  physics::Physics::RayPoint point;
  Sunbeam beam;
  double nu = 0.0;  // cosine between the ray and the sun that is seen there
};
LitPoint lit_point(physics::Physics& physics, const physics::Physics::Ray& ray, double t);

// Direction of the sun that is seen at a point with this vertical.
physics::vec3 seen_sun(const Sunbeam& beam, const physics::vec3& up, const physics::vec3& sun);

}  // namespace airlight
