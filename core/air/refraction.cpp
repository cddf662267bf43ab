#include "core/air/refraction.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "core/air/air.h"
#include "core/base/text.h"
#include "core/scene/refractive_index.h"

namespace airlight {
namespace {

using physics::vec3;

// The altitude below `top` at which a rising function has this value.
template <class Rising>
double where(const Rising& f, double value, double top) {
  double low = 0.0;
  double high = top;
  for (int i = 0; i < 45; ++i) {
    const double middle = 0.5 * (low + high);
    (f(middle) < value ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

// The same of a function that rises at least as fast as its argument, and nearly straight: secants come so near the
// place that few of the middles above are left to be tried. The result is the same to the bit.
template <class Steep>
double where_steep(const Steep& f, double value, double top) {
  double before = 0.0;
  double error_before = f(before) - value;
  double guess = before - error_before;
  double error = f(guess) - value;
  for (int i = 0; i < 8 && std::abs(error) > 1e-15 && error != error_before; ++i) {
    const double next = guess - error * (guess - before) / (error - error_before);
    before = std::exchange(guess, next);
    error_before = std::exchange(error, f(next) - value);
  }
  const double apart = 2.0 * std::abs(error) + 1e-14;  // how far the place can be from the guess
  const auto known = [&](double x) {
    return std::abs(x - guess) > apart ? (x < guess ? value - 1.0 : value + 1.0) : f(x);
  };
  return where(known, value, top);
}

// The altitude of an optical one, by Newton's steps from a guess.
double altitude_of(RefractiveIndex& index, double optical, double guess) {
  for (int i = 0; i < 6; ++i) {
    guess = std::max(guess - (index.optical_altitude(guess) - optical) / index.curvature(guess), 0.0);
  }
  return guess;
}

// Needs the nodes' altitudes.
double sun_lift(physics::Physics& p, double g) {
  const physics::PlanetData& planet = p.scene.planet;
  const double horizon = p.horizon_mu(planet, g);
  const double bent = p.bending_to_top(planet, g, horizon, physics::kBendingSteps);
  const double mu = horizon * std::cos(bent) - std::sqrt(1.0 - horizon * horizon) * std::sin(bent);
  return (horizon - mu) / (1.0 - mu * mu);
}

}  // namespace

void put_planet(physics::Physics& p, const Planet& planet) {
  p.scene.planet = {planet.ground_radius, planet.atmosphere_height, vector_of(planet.ground_albedo)};
  p.refraction = planet.refraction.has_value();
  if (!p.refraction) {
    return;
  }
  RefractiveIndex index(planet);
  const double scale = planet.refraction->scale;
  p.scene.planet.ground_radius = radius_for_things(planet);
  p.scene.planet.atmosphere_height = scale * index.optical_altitude(planet.atmosphere_height);
  p.scene.refraction.ground_radius = planet.ground_radius;
  p.scene.refraction.scale = scale;
  constexpr physics::uint kCells = physics::kRefractionCells;
  double h = 0.0;
  for (physics::uint i = 0; i <= kCells; ++i) {
    const double u = static_cast<double>(i) / kCells;
    h = altitude_of(index, p.scene.planet.atmosphere_height / scale * u * u, h);
    p.scene.refraction.nodes[i] = {h, 1.0 / (scale * index.curvature(h)), 0.0};
  }
  for (physics::uint i = 0; i <= kCells; ++i) {
    const double u = static_cast<double>(i) / kCells;
    p.scene.refraction.nodes[i].z = sun_lift(p, p.scene.planet.atmosphere_height * u * u);
  }
}

double scale_for_things(const Planet& planet, double camera_altitude) {
  constexpr double kNear = 0.01;  // km, over which the air's gradient is that at the ground
  RefractiveIndex index(planet);
  const double h = std::max(camera_altitude, kNear);
  return h / index.optical_altitude(h);
}

double radius_for_things(const Planet& planet) {
  return !planet.refraction ? planet.ground_radius
                            : RefractiveIndex(planet).at(0.0) * planet.ground_radius * planet.refraction->scale;
}

std::string refraction_key(const Planet& planet) {
  std::string key;
  if (const auto& bent = planet.refraction) {
    const Density& d = bent->density;
    for (const double number : {bent->n_minus_1, bent->scale, static_cast<double>(d.profile)}) {
      key += " " + shortest(number);
    }
    for (const DensityNumber& number : kDensityNumbers) {
      key += " " + shortest(d.*number.value);
    }
    for (const DensityLayer& layer : d.layers) {
      key += " " + shortest(layer.altitude) + " " + shortest(layer.density);
    }
  }
  return key;
}

double optical_altitude(physics::Physics& p, double h) {
  if (!p.refraction) {
    return h;
  }
  const double optical_top = p.scene.planet.atmosphere_height;
  const double top = p.true_altitude(optical_top).h;
  if (h >= top) {
    return p.optical_scale() * (h - top) + optical_top;
  }
  return where([&](double g) { return p.true_altitude(g).h; }, h, optical_top);
}

double true_length(physics::Physics& p, double mu, double optical) {
  if (!p.refraction) {
    return optical;
  }
  // Beyond the air both are the same.
  const physics::PlanetData& planet = p.scene.planet;
  const auto ray = p.ray_in_atmosphere(planet, p.scene.camera.altitude, mu, 0.0, 0.0);
  const double before = p.air_entry(planet, p.scene.camera.altitude, mu).distance_;
  const double inside = std::min(optical - before, ray.length_);
  double length = (optical - std::max(inside, 0.0)) / p.optical_scale();
  constexpr int kSteps = 64;
  for (int i = 0; i < kSteps && inside > 0.0; ++i) {
    const double t = inside * (i + 0.5) / kSteps;
    length += p.true_altitude(p.point_on_ray(planet, ray, t).h).stretch * inside / kSteps;
  }
  return length;
}

SeenDirection seen_direction(physics::Physics& p, const vec3& direction) {
  const physics::PlanetData& planet = p.scene.planet;
  const double g = p.scene.camera.altitude;
  const double level = std::sqrt(std::max(1.0 - direction.y * direction.y, 0.0));
  if (!p.refraction || g > planet.atmosphere_height || level < 1e-9) {
    return {direction, 1.0};
  }
  const double horizon = p.horizon_mu(planet, g);
  const auto raised = [&](double angle) { return direction.y * std::cos(angle) + level * std::sin(angle); };
  const auto bending = [&](double angle) {
    return p.bending_to_top(planet, g, std::max(raised(angle), horizon), physics::kBendingSteps);
  };
  // Bending falls as the direction rises, so that what is too much grows.
  const double angle = where_steep([&](double a) { return a - bending(a); }, 0.0, 0.1);
  constexpr double kApart = 1e-4;
  const double slope = (bending(angle) - bending(angle + kApart)) / kApart;
  const double scale = (level * std::cos(angle) - direction.y * std::sin(angle)) / level;
  return {{direction.x * scale, raised(angle), direction.z * scale},
          p.beam_spread(planet, g, raised(angle), bending(angle), slope)};
}

double seen_elevation(const Planet& planet, double altitude, double elevation) {
  if (!planet.refraction) {
    return elevation;
  }
  physics::Physics p;
  put_planet(p, planet);
  p.scene.camera.altitude = optical_altitude(p, altitude);
  const SeenDirection seen = seen_direction(p, {std::cos(elevation), std::sin(elevation), 0.0});
  return std::asin(std::clamp(seen.direction.y, -1.0, 1.0));
}

BentSky::BentSky(physics::Physics& p) {
  const physics::PlanetData& planet = p.scene.planet;
  const double g = p.scene.camera.altitude;
  if (!p.refraction || g > planet.atmosphere_height) {
    return;
  }
  // Seen elevations, dense above the horizon, where light just passes the ground.
  constexpr int kRows = 160;
  const double horizon = std::asin(p.horizon_mu(planet, g)) + 1e-7;
  const auto bending = [&](double seen) { return p.bending_to_top(planet, g, std::sin(seen), physics::kBendingSteps); };
  for (int i = 0; i < kRows; ++i) {
    const double x = static_cast<double>(i) / (kRows - 1);
    const double seen = horizon + (0.5 * std::numbers::pi - horizon) * x * x;
    const double lift = bending(seen);
    constexpr double kApart = 1e-4;
    const double slope = (lift - bending(seen + kApart)) / kApart;
    rows_.push_back({seen - lift, lift, p.beam_spread(planet, g, std::sin(seen), lift, slope)});
  }
}

SeenDirection BentSky::seen(const vec3& direction) const {
  const double level = std::hypot(direction.x, direction.z);
  if (rows_.empty() || level < 1e-9) {
    return {direction, 1.0};
  }
  const double elevation = std::atan2(direction.y, level);
  const auto above =
      std::clamp(std::ranges::upper_bound(rows_, elevation, {}, &Row::elevation), rows_.begin() + 1, rows_.end() - 1);
  const Row& low = *(above - 1);
  const double u = std::clamp((elevation - low.elevation) / (above->elevation - low.elevation), 0.0, 1.0);
  const double up = elevation + low.lift + u * (above->lift - low.lift);
  const double scale = std::cos(up) / level;
  return {{direction.x * scale, std::sin(up), direction.z * scale}, low.spread + u * (above->spread - low.spread)};
}

}  // namespace airlight
