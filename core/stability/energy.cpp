#include "core/stability/energy.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/air/scene_block.h"
#include "core/physics/gauss.h"

namespace airlight::stability {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr int kGroundNodes = 8;
constexpr int kLimbNodes = 6;
constexpr int kHalfAzimuths = 8;
constexpr int kDayNodes = 8;
constexpr int kDuskNodes = 3;
constexpr double kAlmostTop = 0.999;  // of the air's height: some methods march from outside, where tables do not hold

struct Weighted {
  std::vector<Direction> directions;
  std::vector<double> weights;  // |mu| d omega, mirror images counted in
};

void add_band(Weighted& out, double mu_low, double mu_high, int nodes) {
  const GaussRule rule = gauss_legendre(nodes);
  for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
    const double mu = mu_low + (mu_high - mu_low) * rule.nodes[i];
    for (int j = 0; j < kHalfAzimuths; ++j) {
      out.directions.push_back({std::asin(mu), kPi * (j + 0.5) / kHalfAzimuths});
      out.weights.push_back(std::abs(mu) * (mu_high - mu_low) * rule.weights[i] * 2.0 * kPi / kHalfAzimuths);
    }
  }
}

double upward_flux(const Shot& shot, const std::vector<double>& weights, std::size_t c) {
  double sum = 0.0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    const physics::vec3& l = shot.radiance[i];
    sum += weights[i] * (c == 0 ? l.x : c == 1 ? l.y : l.z);
  }
  return sum;
}

}  // namespace

double reflected_share(const DeviceOnDemand& device, const Subject& subject, const Place& place) {
  Scene scene = scene_at(place);
  scene.camera.altitude = kAlmostTop * scene.planet.atmosphere_height;
  scene.sun.azimuth = 0.0;
  physics::Physics p = geometry_of(scene);
  const double horizon = p.horizon_mu(p.scene.planet, scene.camera.altitude);
  Weighted looks;
  add_band(looks, -1.0, horizon, kGroundNodes);
  add_band(looks, horizon, 0.0, kLimbNodes);
  double out[3] = {};
  const auto add_suns = [&](double low, double high, int nodes) {
    const GaussRule rule = gauss_legendre(nodes);
    for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
      scene.sun.elevation = std::asin(low + (high - low) * rule.nodes[i]);
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
