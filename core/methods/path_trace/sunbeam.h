#pragma once
// The sun as a point of the air sees it, by exact rays where the air bends light.

#include <array>

#include "core/physics/gauss.h"
#include "core/physics/physics.h"

namespace airlight {

struct Sunbeam {
  bool up = false;      // not behind the planet
  double mu = 0.0;      // zenith cosine of the sun that is seen there
  double spread = 1.0;  // irradiance over that of the same beam unbent
  double bent = 0.0;    // angle by which it is bent, rad
};

// `mu_sun`: zenith cosine of the true sun.
Sunbeam sunbeam(physics::Physics& physics, double h, double mu_sun);

// The same but for the spread, which is left at 1.
Sunbeam unspread_sunbeam(physics::Physics& physics, double h, double mu_sun);

// Between two distances of a ray, km.
struct Reach {
  double from;
  double to;
};

// Bending of a ray that leaves altitude h along zenith cosine mu, between these distances, rad.
double bending_between(physics::Physics& physics, double h, double mu, const Reach& reach, const GaussRule& rule);

// A point of a ray, with the true sun as it stands there.
struct LitPoint {
  physics::Physics::RayPoint point;
  Sunbeam beam;
  double nu = 0.0;    // cosine between the ray and the sun that is seen there
  double bent = 0.0;  // of the ray up to here, rad
};

// The points of a ray under the sun.
class LitRay {
 public:
  LitRay(physics::Physics& physics, const physics::Physics::Ray& ray);

  LitPoint at(double t) const;
  LitPoint unspread_at(double t) const;  // with unspread_sunbeam()

  // The same where both bendings are known, rad: of the ray up to there, and of the sun's beam.
  LitPoint bent_by(double t, double bent, double beam_bent) const;

  // Bending of the ray up to a distance, rad; 0 where the air bends no light.
  double bending_to(double t) const;

 private:
  double bending_from(double h, double mu) const;
  template <class Beam>
  LitPoint point(double t, double bent, const Beam& beam) const;

  physics::Physics& physics_;
  physics::Physics::Ray ray_;
  double bending_;  // of the whole ray
};

// Places of a ray under the sun, ((i + 1/2) / count)^2 of its length from the start, asked for in any order but fastest
// in their own. Of neighbours three are looked at; where these see the sun and their bendings lie near a line, those of
// the others are on a parabola through them, to 2e-5 rad.
class LitPlaces {
 public:
  LitPlaces(const LitRay& ray, double length, int count, bool refraction);

  double distance(int i) const;
  LitPoint at(int i);  // as LitRay::unspread_at() of its distance

 private:
  void look_at(int span);

  const LitRay& ray_;
  double length_;
  int count_;
  int span_;  // of neighbours, of which the following is known
  bool refraction_;
  bool even_ = false;
  std::array<double, 3> bent_{};
  std::array<double, 3> beam_bent_{};
};

// LitRay::bending_to() of a distance that alone is asked for.
double bending_of_flight(physics::Physics& physics, const physics::Physics::Ray& ray, double t);

// Direction of the sun that is seen at a point with this vertical.
physics::vec3 seen_sun(const Sunbeam& beam, const physics::vec3& up, const physics::vec3& sun);

}  // namespace airlight
