#include "core/stability/energy.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/methods/ready.h"
#include "core/physics/gauss.h"

namespace airlight::stability {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr int kGroundNodes = 12;  // to either side of the point opposite to the sun
constexpr int kLimbNodes = 6;
constexpr int kHalfAzimuths = 16;
constexpr int kDayNodes = 8;
constexpr int kDuskNodes = 3;
constexpr int kRimNodes = 48;
constexpr int kRimSteps = 256;
constexpr double kAlmostTop = 0.999;  // of the air's height: some methods march from outside, where tables do not hold

struct Weighted {
  std::vector<Direction> directions;
  std::vector<double> weights;  // |mu| d omega, mirror images included
};

// Directions between two zenith cosines, dense next to the first of them and next to the azimuth opposite the sun,
// where light scattered back has a peak.
void add_band(Weighted& out, double mu_from, double mu_to, int nodes) {
  const GaussRule rule = gauss_legendre(nodes);
  const GaussRule around = gauss_legendre(kHalfAzimuths);
  const double range = std::abs(mu_to - mu_from);
  for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
    const double z = rule.nodes[i];
    const double mu = mu_from + (mu_to - mu_from) * z * z;
    const double band = std::abs(mu) * range * 2.0 * z * rule.weights[i];
    for (std::size_t j = 0; j < around.nodes.size(); ++j) {
      const double y = around.nodes[j];
      out.directions.push_back({std::asin(mu), kPi * (1.0 - y * y)});
      out.weights.push_back(band * 2.0 * kPi * 2.0 * y * around.weights[j]);
    }
  }
}

Weighted looks_down(double horizon, double mu_sun) {
  Weighted looks;
  const double opposite = std::min(-mu_sun, horizon);
  add_band(looks, opposite, -1.0, kGroundNodes);
  if (opposite < horizon) {
    add_band(looks, opposite, horizon, kGroundNodes);
  }
  add_band(looks, horizon, 0.0, kLimbNodes);
  return looks;
}

double upward_flux(const Shot& shot, const std::vector<double>& weights, std::size_t c) {
  double sum = 0.0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    sum += weights[i] * channel(shot.radiance[i], c);
  }
  return sum;
}

// Share of the sunlight on the sphere around the planet at this altitude that passes through the rim of the air without
// meeting air or ground.
physics::vec3 passing_share(physics::Physics p, double altitude) {
  const physics::PlanetData& planet = p.scene.planet;
  const GaussRule rule = gauss_legendre(kRimNodes);
  const double radius = planet.ground_radius + altitude;
  physics::vec3 share(0.0);
  for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
    const double z = rule.nodes[i];
    const double h = altitude * z * z;
    const physics::vec3 depth = p.optical_depth_to_top(planet, h, 0.0, kRimSteps) * 2.0;
    const double ring = 2.0 * (planet.ground_radius + h) * altitude * 2.0 * z * rule.weights[i] / (radius * radius);
    share = share + exp(-depth) * ring;
  }
  return share;
}

}  // namespace

double returned_share(const DeviceOnDemand& device, const Subject& subject, const Place& place) {
  Scene scene = scene_at(place);
  scene.camera.altitude = kAlmostTop * scene.planet.atmosphere_height;
  scene.sun.azimuth = 0.0;
  const Stage stage = ready(rendered_by(subject, scene, place));
  const physics::Physics p = formulas_of(stage.whole().air, stage.scene());
  const double horizon = physics::Physics(p).horizon_mu(p.scene.planet, scene.camera.altitude);
  const physics::vec3 passing = passing_share(p, scene.camera.altitude);
  double out[3] = {passing.x, passing.y, passing.z};
  const auto add_suns = [&](double low, double high, int nodes) {
    const GaussRule rule = gauss_legendre(nodes);
    for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
      const double mu_sun = low + (high - low) * rule.nodes[i];
      scene.sun.elevation = std::asin(mu_sun);
      const Weighted looks = looks_down(horizon, mu_sun);
      const Shot shot = shoot(device, rendered_by(subject, scene, place), looks.directions, {});
      for (std::size_t c = 0; c < 3; ++c) {
        out[c] += 2.0 * (high - low) * rule.weights[i] * upward_flux(shot, looks.weights, c);
      }
    }
  };
  add_suns(0.0, 1.0, kDayNodes);
  add_suns(horizon, 0.0, kDuskNodes);
  const bool finite = std::isfinite(out[0]) && std::isfinite(out[1]) && std::isfinite(out[2]);
  return finite ? std::max({out[0], out[1], out[2]}) : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace airlight::stability
