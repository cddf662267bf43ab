#include "core/methods/path_trace/sky_guide.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/methods/path_trace/random.h"

namespace airlight {

using physics::vec3;

namespace {

constexpr double kPi = std::numbers::pi;

// Any horizontal unit vector.
vec3 some_level(vec3 up) {
  const vec3 other = std::abs(up.x) < 0.5 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0);
  return normalize(cross(up, other));
}

}  // namespace

SkyFrame::SkyFrame(physics::Physics& physics, double altitude, vec3 vertical, bool ground)
    : h(altitude), at_ground(ground), up(vertical) {
  const vec3 sun = physics.scene.sun.direction;
  horizon = physics.horizon_mu(physics.scene.planet, h);
  mu_sun = std::clamp(dot(up, sun), -1.0, 1.0);
  const vec3 level = sun - up * mu_sun;
  const double size = length(level);
  toward_sun = size > 1e-6 ? level / size : some_level(up);
}

// Zenith cosine of edge `row` of the bins, from the nadir up, dense toward the horizon on both sides.
double SkyGuide::edge(double horizon, std::size_t row) {
  if (row <= kBelow) {
    const double v = 1.0 - static_cast<double>(row) / kBelow;
    return horizon - (1.0 + horizon) * v * v;
  }
  const double v = static_cast<double>(row - kBelow) / kAbove;
  return horizon + (1.0 - horizon) * v * v;
}

SkyGuide::SkyGuide(physics::Physics& physics, const Flight& flight)
    : physics_(physics),
      flight_(flight),
      skies_((flight.shell_count() + 1) * kSuns),
      filled_((flight.shell_count() + 1) * kSuns) {
  const physics::PlanetData& planet = physics.scene.planet;
  // Greatest distance of a path from below the camera: to the camera's horizon, then twice the air's own horizon.
  const auto reach = [&](double h) { return std::acos(planet.ground_radius / (planet.ground_radius + h)); };
  const double far = reach(physics.scene.camera.altitude) + 2.0 * reach(planet.atmosphere_height);
  const double zenith = std::acos(std::clamp(physics.scene.sun.direction.y, -1.0, 1.0));
  first_sun_ = std::max(zenith - far, 0.0);
  sun_step_ = (std::min(zenith + far, kPi) - first_sun_) / (kSuns - 1);
}

void SkyGuide::fill(std::size_t place, std::size_t sun) const {
  const physics::PlanetData& planet = physics_.scene.planet;
  const bool at_ground = place == flight_.shell_count();
  const double h = at_ground ? 0.0 : flight_.shell_middle(place);
  const double mu_sun = std::cos(first_sun_ + sun_step_ * static_cast<double>(sun));
  const double horizon = physics_.horizon_mu(planet, h);
  std::array<Sky, 3>& channels = skies_[place * kSuns + sun];
  Channels all{};
  FlightPlan plan;
  for (std::size_t row = 0; row < kAbove + kBelow; ++row) {
    const double mu = 0.5 * (edge(horizon, row) + edge(horizon, row + 1));
    // The ground's share of a direction is in proportion to the cosine.
    const double share = (at_ground ? std::max(mu, 0.0) : 1.0) * (edge(horizon, row + 1) - edge(horizon, row));
    for (Sky& sky : channels) {
      sky.rows[row] = 0.0;
    }
    for (std::size_t k = 0; k < kAround; ++k) {
      const double azimuth = kPi * (static_cast<double>(k) + 0.5) / kAround;
      const double nu = mu * mu_sun + std::sqrt((1.0 - mu * mu) * (1.0 - mu_sun * mu_sun)) * std::cos(azimuth);
      flight_.plan_guided(physics_.ray_in_atmosphere(planet, h, mu, mu_sun, nu), 1.0, plan);
      for (std::size_t c = 0; c < 3; ++c) {
        channels[c].shares[row][k] = share * plan.total[c];
        channels[c].rows[row] += share * plan.total[c];
        all[c] += share * plan.total[c];
      }
    }
  }
  for (std::size_t c = 0; c < 3; ++c) {
    for (std::size_t row = 0; row < kAbove + kBelow; ++row) {
      double& sum = channels[c].rows[row];
      for (double& share : channels[c].shares[row]) {
        share = sum > 0.0 ? share / sum : 0.0;
      }
      sum = all[c] > 0.0 ? sum / all[c] : 0.0;
    }
  }
}

const std::array<SkyGuide::Sky, 3>& SkyGuide::skies(const SkyFrame& frame) const {
  const double nearest = (std::acos(frame.mu_sun) - first_sun_) / sun_step_ + 0.5;
  const auto sun = static_cast<std::size_t>(std::clamp(nearest, 0.0, kSuns - 1.0));
  const std::size_t place = frame.at_ground ? flight_.shell_count() : flight_.shell_of(frame.h);
  const std::size_t k = place * kSuns + sun;
  std::call_once(filled_[k], [&] { fill(place, sun); });
  return skies_[k];
}

vec3 SkyGuide::draw_direction(const SkyFrame& frame, const Channels& weight, double u, double turn) const {
  u *= weight[0] + weight[1] + weight[2];
  const auto weight_of = [&](std::size_t c) { return weight[c]; };
  const std::size_t channel = draw(3, weight_of, u);
  const Sky& sky = skies(frame)[channel];
  const auto share_of_row = [&](std::size_t k) { return sky.rows[k]; };
  const std::size_t row = draw(sky.rows.size(), share_of_row, u);
  const double low = edge(frame.horizon, row);
  const double mu = std::clamp(low + u * (edge(frame.horizon, row + 1) - low), -1.0, 1.0);
  // Either half turn mirrors the other.
  const double side = turn < 0.5 ? 1.0 : -1.0;
  double place = 2.0 * turn - (turn < 0.5 ? 0.0 : 1.0);
  const auto share_of_bin = [&](std::size_t k) { return sky.shares[row][k]; };
  const std::size_t bin = draw(kAround, share_of_bin, place);
  const double azimuth = kPi * (static_cast<double>(bin) + place) / kAround;
  const double sine = std::sqrt(std::max(1.0 - mu * mu, 0.0));
  const vec3 aside = cross(frame.up, frame.toward_sun);
  return normalize(frame.up * mu + frame.toward_sun * (sine * std::cos(azimuth)) +
                   aside * (side * sine * std::sin(azimuth)));
}

double SkyGuide::density(const SkyFrame& frame, const Channels& weight, vec3 direction) const {
  static const std::array<double, kAround - 1> cosines = [] {
    std::array<double, kAround - 1> list;
    for (std::size_t k = 0; k < list.size(); ++k) {
      list[k] = std::cos(kPi * static_cast<double>(k + 1) / kAround);
    }
    return list;
  }();
  const double mu = std::clamp(dot(direction, frame.up), -1.0, 1.0);
  std::size_t row = 0;
  if (mu < frame.horizon) {
    const double v = std::sqrt((frame.horizon - mu) / (1.0 + frame.horizon));
    row = static_cast<std::size_t>(std::clamp((1.0 - v) * kBelow, 0.0, kBelow - 1.0));
  } else {
    const double v = std::sqrt((mu - frame.horizon) / (1.0 - frame.horizon));
    row = kBelow + static_cast<std::size_t>(std::clamp(v * kAbove, 0.0, kAbove - 1.0));
  }
  const double level = dot(direction, frame.toward_sun);
  const double sine = std::sqrt(std::max(1.0 - mu * mu, 0.0));
  std::size_t bin = 0;
  while (bin < cosines.size() && level < cosines[bin] * sine) {
    ++bin;
  }
  const double all = weight[0] + weight[1] + weight[2];
  double sum = 0.0;
  const std::array<Sky, 3>& channels = skies(frame);
  for (std::size_t c = 0; c < 3; ++c) {
    sum += weight[c] / all * channels[c].rows[row] * channels[c].shares[row][bin];
  }
  // The bins of this very altitude: the guide's shell has another horizon.
  const double height = edge(frame.horizon, row + 1) - edge(frame.horizon, row);
  return sum / (height * 2.0 * kPi / kAround);
}

}  // namespace airlight
