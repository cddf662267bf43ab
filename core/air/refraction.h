#pragma once
// Air that bends light (shaders/physics/refraction.glsl): its planet and its altitudes become optical.

#include <string>
#include <vector>

#include "core/physics/physics.h"
#include "core/scene/scene.h"

namespace airlight {

// Puts the planet into `p`; where it has refraction, its optical form.
void put_planet(physics::Physics& p, const Planet& planet);

// The unit of optical lengths (Refraction::scale) in which the altitudes of the camera and of the ground below it are
// true: h over the optical altitude. It makes the planet's radius the effective one of surveyors, and the dip of the
// horizon is exact. The planet has refraction.
double scale_for_things(const Planet& planet, double camera_altitude);

// Radius of the planet on which things stand: true where the air bends no light, else optical, in the unit set.
double radius_for_things(const Planet& planet);

// Two planets of equal keys and radii bend light alike.
std::string refraction_key(const Planet& planet);

// The optical altitude of a true one, km; the same where the air bends no light. Above the air too.
double optical_altitude(physics::Physics& p, double h);

// The true length of a camera ray's optical one, both km; the same where the air bends no light.
double true_length(physics::Physics& p, double mu, double optical);

// Where light from a direction above the air arrives at the camera; from space the same direction.
struct SeenDirection {
  physics::vec3 direction;
  double spread;  // solid angle as it is seen over that above the air, times n^2
};
SeenDirection seen_direction(physics::Physics& p, const physics::vec3& direction);

// The elevation at which light from a true elevation is seen at an altitude, rad; the same where nothing is bent.
double seen_elevation(const Planet& planet, double altitude, double elevation);

// The same as seen_direction() for many directions, by a table over the elevation: within 0.2 arc seconds of it above
// the horizon.
class BentSky {
 public:
  explicit BentSky(physics::Physics& p);
  SeenDirection seen(const physics::vec3& direction) const;

 private:
  struct Row {
    double elevation;  // above the air, rad
    double lift;       // rad
    double spread;
  };
  std::vector<Row> rows_;  // empty: nothing is bent
};

}  // namespace airlight
