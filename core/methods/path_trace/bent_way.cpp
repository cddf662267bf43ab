#include "core/methods/path_trace/bent_way.h"

#include <algorithm>
#include <cmath>

#include "core/air/refraction.h"

namespace airlight {

using physics::vec3;

vec3 true_place(physics::Physics& physics, vec3 up, double h) {
  return physics.refraction ? up * (physics.true_ground_radius() + physics.true_altitude(h).h)
                            : up * (physics.scene.planet.ground_radius + h);
}

double altitude_of_place(physics::Physics& physics, vec3 place) {
  return physics.refraction ? optical_altitude(physics, std::max(length(place) - physics.true_ground_radius(), 0.0))
                            : std::max(length(place) - physics.scene.planet.ground_radius, 0.0);
}

vec3 sun_seen_from(physics::Physics& physics, vec3 place, const Sunbeam& beam) {
  const vec3 sun = physics.scene.sun.direction;
  return physics.refraction ? seen_sun(beam, normalize(place), sun) : sun;
}

BentWay::BentWay(physics::Physics& physics, vec3 place, vec3 up, vec3 direction, const physics::Physics::Ray& ray)
    : physics_(physics), place_(place), up_(up), direction_(direction), level_(0.0), slope_(0.0), ray_(ray) {
  const vec3 level = direction - up * dot(direction, up);
  slope_ = length(level);
  level_ = slope_ > 1e-12 ? level / slope_ : vec3(0.0);
}

double BentWay::bending_between(double from, double to) const {
  static const GaussRule rule = gauss_legendre(2);
  return airlight::bending_between(physics_, ray_.h, ray_.mu, {from, to}, rule);
}

// By the Illinois rule of false position: the length from the chord's begin grows with the distance.
double BentWay::on_ray(const Chord& chord, double along) const {
  if (!physics_.refraction || !(chord.length > 0.0)) {
    return along;
  }
  constexpr double kClose = 1e-6;  // km
  constexpr int kMostTurns = 20;
  double low = chord.start;
  double high = chord.end;
  double below = -along;
  double above = chord.length - along;
  double t = low;
  double off = below;
  for (int turn = 0, side = 0; turn < kMostTurns && std::abs(off) > kClose && above > below; ++turn) {
    t = std::clamp((low * above - high * below) / (above - below), chord.start, chord.end);
    off = length(at(t, chord.bent + bending_between(chord.start, t)).place - chord.from) - along;
    if (off < 0.0) {
      low = t;
      below = off;
      above = side < 0 ? 0.5 * above : above;
      side = -1;
    } else {
      high = t;
      above = off;
      below = side > 0 ? 0.5 * below : below;
      side = 1;
    }
  }
  return t;
}

BentWay::Point BentWay::at(double t) const {
  return at(t, bending_of_flight(physics_, ray_, t));
}

BentWay::Point BentWay::at(double t, double bent) const {
  if (!physics_.refraction) {
    const vec3 place = place_ + direction_ * t;
    return {place, direction_, normalize(place)};
  }
  const physics::PlanetData& planet = physics_.scene.planet;
  const double r = planet.ground_radius + ray_.h;
  const auto point = physics_.point_on_ray(planet, ray_, t);
  const double round = std::atan2(t * slope_, r + t * ray_.mu) + bent;
  Point at;
  at.up = up_ * std::cos(round) + level_ * std::sin(round);
  const vec3 ahead = level_ * std::cos(round) - up_ * std::sin(round);
  at.place = true_place(physics_, at.up, point.h);
  at.direction = at.up * point.mu + ahead * std::sqrt(std::max(1.0 - point.mu * point.mu, 0.0));
  return at;
}

}  // namespace airlight
