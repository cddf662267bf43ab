#include "core/methods/path_trace/sunbeam.h"

#include <algorithm>
#include <cmath>

namespace airlight {

using physics::vec3;

namespace {

double across(double mu) {
  return std::sqrt(std::max(1.0 - mu * mu, 0.0));
}

// The cosine of a zenith angle that is less by `angle`.
double raised(double mu, double angle) {
  return mu * std::cos(angle) + across(mu) * std::sin(angle);
}

// Gauss's rule for a part of a ray that is no longer than some hundreds of km.
const GaussRule& rule_of_part() {
  static const GaussRule rule = gauss_legendre(12);
  return rule;
}

// Of a ray from altitude h along mu to the top of the air, as Physics::bending_to_top(), to 1e-6 rad. Twelve steps do,
// but for the part between the lowest point and h, at whose ends the air is thick; Gauss's rule has that.
double bending_to_top(physics::Physics& physics, double h, double mu) {
  constexpr physics::uint kSteps = 12;
  const physics::PlanetData& planet = physics.scene.planet;
  const double sine = across(mu);
  const double r = planet.ground_radius + h;
  const double lowest = mu < 0.0 ? std::max(h - r * mu * mu / (1.0 + sine), 0.0) : h;
  const double level = std::max(mu, 0.0);
  const double above =
      physics.bending_upward(planet, lowest, level, physics.distance_to_top(planet, lowest, level), kSteps);
  return mu < 0.0 ? above + bending_between(physics, lowest, 0.0, {0.0, -r * mu}, rule_of_part()) : above;
}

// The same, below the horizon as at it.
double bending(physics::Physics& physics, double h, double horizon, double mu) {
  return bending_to_top(physics, h, std::max(mu, horizon));
}

// A sun that is lifted by its own bending.
struct Lift {
  double angle;    // rad
  double bending;  // of a sun lifted so, within 1e-9 of the angle
};

// Bending falls with the lift, so that the lift lies between the least one, the horizon's, and the bending there: the
// Illinois rule of false position.
template <class Bending>
Lift lift_of(double least, const Bending& bending) {
  constexpr int kMostTurns = 20;
  constexpr double kNear = 1e-9;
  double low = least;
  double above = bending(low) - low;
  if (above <= kNear) {
    return {low, low + above};
  }
  double high = low + above;
  double below = bending(high) - high;
  double lift = high;
  double off = below;
  for (int turn = 0, side = 0; turn < kMostTurns && std::abs(off) > kNear; ++turn) {
    lift = (low * below - high * above) / (below - above);
    off = bending(lift) - lift;
    if (off > 0.0) {
      low = lift;
      above = off;
      below = side > 0 ? 0.5 * below : below;
      side = 1;
    } else {
      high = lift;
      below = off;
      above = side < 0 ? 0.5 * above : above;
      side = -1;
    }
  }
  return {lift, lift + off};
}

}  // namespace

double bending_between(physics::Physics& physics, double h, double mu, const Reach& reach, const GaussRule& rule) {
  const physics::PlanetData& planet = physics.scene.planet;
  const physics::Physics::Ray ray{h, mu, mu, 1.0, reach.to, false, 0.0, false};
  const double impact = (planet.ground_radius + h) * across(mu);
  double sum = 0.0;
  for (std::size_t k = 0; k < rule.nodes.size(); ++k) {
    const double t = reach.from + (reach.to - reach.from) * rule.nodes[k];
    const double g = physics.point_on_ray(planet, ray, t).h;
    const double q = planet.ground_radius + g;
    sum += rule.weights[k] * physics.bending_rate(planet, g) * impact / (q * q);
  }
  return sum * (reach.to - reach.from);
}

Sunbeam unspread_sunbeam(physics::Physics& physics, double h, double mu_sun) {
  const physics::PlanetData& planet = physics.scene.planet;
  if (!physics.refraction) {
    return {!physics.meets_ground(planet, h, mu_sun), mu_sun, 1.0};
  }
  Sunbeam beam{physics.sun_is_up(planet, h, mu_sun)};
  if (!beam.up) {
    return beam;
  }
  const double horizon = physics.horizon_mu(planet, h);
  const double least = std::max(std::acos(std::clamp(mu_sun, -1.0, 1.0)) - std::acos(horizon), 0.0);
  const Lift lift = lift_of(least, [&](double angle) { return bending(physics, h, horizon, raised(mu_sun, angle)); });
  beam.mu = std::max(raised(mu_sun, lift.angle), horizon);
  beam.bent = lift.bending;
  return beam;
}

namespace {

double spread_of(physics::Physics& physics, double h, const Sunbeam& beam) {
  if (!physics.refraction || !beam.up) {
    return 1.0;
  }
  constexpr double kApart = 1e-6;  // rad
  const double horizon = physics.horizon_mu(physics.scene.planet, h);
  const double slope = (beam.bent - bending(physics, h, horizon, raised(beam.mu, kApart))) / kApart;
  return physics.beam_spread(physics.scene.planet, h, beam.mu, beam.bent, slope);
}

}  // namespace

Sunbeam sunbeam(physics::Physics& physics, double h, double mu_sun) {
  Sunbeam beam = unspread_sunbeam(physics, h, mu_sun);
  beam.spread = spread_of(physics, h, beam);
  return beam;
}

LitRay::LitRay(physics::Physics& physics, const physics::Physics::Ray& ray)
    : physics_(physics), ray_(ray), bending_(bending_from(ray.h, ray.mu)) {}

// To the top of the air; of a ray that falls to the ground less that which it would have if it went the other way.
double LitRay::bending_from(double h, double mu) const {
  if (!physics_.refraction) {
    return 0.0;
  }
  return ray_.falls ? -bending_to_top(physics_, h, -mu) : bending_to_top(physics_, h, mu);
}

double LitRay::bending_to(double t) const {
  if (!physics_.refraction) {
    return 0.0;
  }
  const auto point = physics_.point_on_ray(physics_.scene.planet, ray_, t);
  return bending_ - bending_from(point.h, point.mu);
}

double bending_of_flight(physics::Physics& physics, const physics::Physics::Ray& ray, double t) {
  constexpr double kShort = 100.0;  // km
  if (!physics.refraction) {
    return 0.0;
  }
  return t < kShort ? bending_between(physics, ray.h, ray.mu, {0.0, t}, rule_of_part())
                    : LitRay(physics, ray).bending_to(t);
}

// `beam`: the sun's, of a point and the true sun's zenith cosine there.
template <class Beam>
LitPoint LitRay::point(double t, double bent, const Beam& beam) const {
  LitPoint lit;
  lit.point = physics_.point_on_ray(physics_.scene.planet, ray_, t);
  if (!physics_.refraction) {
    lit.beam = beam(lit.point.h, lit.point.mu_sun);
    lit.nu = ray_.nu;
    return lit;
  }
  const double mu_sun = lit.point.mu_sun;
  const double s = across(lit.point.mu);
  const double ahead = s > 1e-9 ? (ray_.nu - lit.point.mu * mu_sun) / s : 0.0;
  lit.bent = bent;
  lit.point.mu_sun = mu_sun * std::cos(bent) + ahead * std::sin(bent);
  lit.beam = beam(lit.point.h, lit.point.mu_sun);
  const double level = (ahead * std::cos(bent) - mu_sun * std::sin(bent)) / std::max(across(lit.point.mu_sun), 1e-9);
  lit.nu = std::clamp(lit.point.mu * lit.beam.mu + s * level * across(lit.beam.mu), -1.0, 1.0);
  return lit;
}

LitPoint LitRay::unspread_at(double t) const {
  return point(t, bending_to(t), [&](double h, double mu_sun) { return unspread_sunbeam(physics_, h, mu_sun); });
}

LitPoint LitRay::bent_by(double t, double bent, double beam_bent) const {
  return point(t, bent, [&](double h, double mu_sun) {
    const physics::PlanetData& planet = physics_.scene.planet;
    const double mu = std::max(raised(mu_sun, beam_bent), physics_.horizon_mu(planet, h));
    return Sunbeam{physics_.sun_is_up(planet, h, mu_sun), mu, 1.0, beam_bent};
  });
}

namespace {

constexpr int kSpan = 16;                    // places
constexpr std::array<int, 3> kOf{0, 8, 15};  // of which are looked at

// A parabola through values at these places.
double between(const std::array<double, 3>& values, int place) {
  double sum = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    sum += values[i] * ((place - kOf[j]) * (place - kOf[k])) / ((kOf[i] - kOf[j]) * (kOf[i] - kOf[k]));
  }
  return sum;
}

// How far the middle value is off the line between the others.
double off_line(const std::array<double, 3>& values) {
  const double line = values[0] + (values[2] - values[0]) * (kOf[1] - kOf[0]) / (kOf[2] - kOf[0]);
  return std::abs(values[1] - line);
}

}  // namespace

LitPlaces::LitPlaces(const LitRay& ray, double length, int count, bool refraction)
    : ray_(ray), length_(length), count_(count), span_(-1), refraction_(refraction) {}

double LitPlaces::distance(int i) const {
  return length_ * (i + 0.5) * (i + 0.5) / (static_cast<double>(count_) * count_);
}

void LitPlaces::look_at(int span) {
  constexpr double kNearLine = 2e-5;  // rad
  span_ = span;
  even_ = kSpan * span + kOf.back() < count_;
  for (std::size_t i = 0; even_ && i < kOf.size(); ++i) {
    const LitPoint lit = ray_.unspread_at(distance(kSpan * span + kOf[i]));
    even_ = lit.beam.up;
    bent_[i] = lit.bent;
    beam_bent_[i] = lit.beam.bent;
  }
  even_ = even_ && off_line(bent_) < kNearLine && off_line(beam_bent_) < kNearLine;
}

LitPoint LitPlaces::at(int i) {
  const double t = distance(i);
  if (!refraction_) {
    return ray_.unspread_at(t);
  }
  if (i / kSpan != span_) {
    look_at(i / kSpan);
  }
  return even_ ? ray_.bent_by(t, between(bent_, i % kSpan), between(beam_bent_, i % kSpan)) : ray_.unspread_at(t);
}

LitPoint LitRay::at(double t) const {
  LitPoint lit = unspread_at(t);
  lit.beam.spread = spread_of(physics_, lit.point.h, lit.beam);
  return lit;
}

vec3 seen_sun(const Sunbeam& beam, const vec3& up, const vec3& sun) {
  const vec3 level = sun - up * dot(up, sun);
  const double size = length(level);
  return size > 1e-9 ? up * beam.mu + level * (across(beam.mu) / size) : sun;
}

}  // namespace airlight
