#pragma once
// Where a ray goes through air that bends light: places of the true space in which things stand, and chords between
// them, short enough to be taken for the ray. Where the air bends nothing, the ray itself.

#include "core/methods/path_trace/sunbeam.h"

namespace airlight {

// The place at an altitude of the formulas, a vector from the planet's centre in the camera's frame, km.
physics::vec3 true_place(physics::Physics& physics, physics::vec3 up, double h);

// Its inverse: the formulas' altitude of a place.
double altitude_of_place(physics::Physics& physics, physics::vec3 place);

// Direction of the sun that is seen from a place.
physics::vec3 sun_seen_from(physics::Physics& physics, physics::vec3 place, const Sunbeam& beam);

class BentWay {
 public:
  // A ray of the formulas that leaves along `direction` (unit) where the vertical is `up`; `place`: where that is.
  BentWay(physics::Physics& physics, physics::vec3 place, physics::vec3 up, physics::vec3 direction,
          const physics::Physics::Ray& ray);

  // The place at distance t of the ray, and the ray's direction and the vertical there.
  struct Point {
    physics::vec3 place;
    physics::vec3 direction;
    physics::vec3 up;
  };
  Point at(double t) const;
  Point at(double t, double bent) const;  // the ray's bending up to there is known, rad

  struct Chord {
    physics::vec3 from;
    physics::vec3 direction;
    double length = 0.0;
    double start = 0.0;  // of the ray
    double end = 0.0;
    double bent = 0.0;  // rad, from the ray's begin to `start`
  };
  // The ray's distance where it is `along` from the begin of one of its chords; the same to the bit where nothing is
  // bent. Optical lengths are not even along a chord: 2.5 km from the ground on one of 10 km a share of its length
  // would be 120 m off.
  double on_ray(const Chord& chord, double along) const;

  // Visits the chords up to `limit`, in order, until `visit` returns true or the ray has risen above `highest`, an
  // altitude over the true ground, km.
  template <class Visit>
  void chords(double limit, double highest, const Visit& visit) const {
    if (!physics_.refraction) {
      visit(Chord{place_, direction_, limit, 0.0, limit, 0.0});
      return;
    }
    // Bent by a fifth of the planet's curvature, a chord of 10 km leaves the ray by 0.4 m.
    constexpr double kLongest = 10.0;
    Chord chord;
    chord.from = place_;
    while (chord.start < limit) {
      const auto here = physics_.point_on_ray(physics_.scene.planet, ray_, chord.start);
      if (here.mu >= 0.0 && physics_.true_altitude(here.h).h > highest) {
        return;
      }
      chord.end = std::min(chord.start + kLongest, limit);
      const double bent = chord.bent + bending_between(chord.start, chord.end);
      const physics::vec3 to = at(chord.end, bent).place;
      chord.length = length(to - chord.from);
      chord.direction = chord.length > 0.0 ? (to - chord.from) / chord.length : direction_;
      if (visit(chord)) {
        return;
      }
      chord.from = to;
      chord.start = chord.end;
      chord.bent = bent;
    }
  }

 private:
  double bending_between(double from, double to) const;

  physics::Physics& physics_;
  physics::vec3 place_;
  physics::vec3 up_;
  physics::vec3 direction_;
  physics::vec3 level_;  // unit, the ray's heading
  double slope_;         // sine of its zenith angle
  physics::Physics::Ray ray_;
};

}  // namespace airlight
