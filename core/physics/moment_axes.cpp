#include "core/physics/moment_axes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace airlight {
namespace {

// Henyey-Greenstein's inverse distribution: samples stand where a peaked phase function is large.
double peaked_cosine(double g, double u) {
  if (std::abs(g) < 1e-3) {
    return 2.0 * u - 1.0;
  }
  const double s = (1.0 - g * g) / (1.0 - g + 2.0 * g * u);
  return std::clamp((1.0 + g * g - s * s) / (2.0 * g), -1.0, 1.0);
}

// Scattering optical depth of layers between the ground and the top, from the top down; mean over channels.
std::vector<double> scattering_from_top(physics::Physics& p, int layers) {
  const double height = p.scene.planet.atmosphere_height;
  std::vector<double> sums(static_cast<std::size_t>(layers) + 1, 0.0);
  for (int i = layers - 1; i >= 0; --i) {
    const physics::vec3 s = p.air_at(height * (i + 0.5) / layers, p.equal_phases(0.0)).scattering;
    sums[static_cast<std::size_t>(i)] = sums[static_cast<std::size_t>(i) + 1] + (s.x + s.y + s.z) * height / layers;
  }
  return sums;
}

}  // namespace

std::array<double, 10> legendre_moments(physics::Physics& p, physics::uint phase_code, double g) {
  constexpr int kSamples = 4096;
  std::array<double, 10> moments{};
  for (int i = 0; i < kSamples; ++i) {
    const double nu = peaked_cosine(g, (i + 0.5) / kSamples);
    const double weight =
        p.phase_value(phase_code, g, nu) / p.phase_henyey_greenstein(std::abs(g) < 1e-3 ? 0.0 : g, nu);
    double before = 1.0;
    double polynomial = nu;
    moments[0] += weight / kSamples;
    for (std::size_t l = 1; l < moments.size(); ++l) {
      moments[l] += weight * polynomial / kSamples;
      const double n = static_cast<double>(l);
      const double next = ((2.0 * n + 1.0) * nu * polynomial - n * before) / (n + 1.0);
      before = polynomial;
      polynomial = next;
    }
  }
  // The norm is known; dividing by the sampled one takes most of the quadrature's error out.
  for (std::size_t l = 1; l < moments.size(); ++l) {
    moments[l] /= moments[0];
  }
  moments[0] = 1.0;
  return moments;
}

physics::MomentTableData moment_axes(physics::Physics& p) {
  constexpr int kLayers = 1000;
  constexpr double kLeftAbove = 1.5e-4;
  const double height = p.scene.planet.atmosphere_height;
  const std::vector<double> above = scattering_from_top(p, kLayers);
  int top = kLayers;
  while (top > 1 && above[static_cast<std::size_t>(top) - 1] < kLeftAbove * above.front()) {
    --top;
  }
  physics::MomentTableData table;
  table.top = height * top / kLayers;
  const double dip = -std::asin(p.horizon_mu(p.scene.planet, table.top));
  table.elevation_scale = std::clamp(0.7 * dip, 0.01, 0.35);
  table.v_high = std::asinh(0.5 * std::numbers::pi / table.elevation_scale);
  table.v_low = -table.v_high;
  return table;
}

physics::MomentTableData shell_moment_axes(physics::Physics& p) {
  physics::MomentTableData table;
  table.top = p.scene.planet.atmosphere_height;
  const double dip = -std::asin(p.horizon_mu(p.scene.planet, table.top));
  table.elevation_scale = std::clamp(0.7 * dip, 0.05, 0.35);
  table.v_high = std::asinh(0.5 * std::numbers::pi / table.elevation_scale);
  table.v_low = -std::asinh(std::min(0.5 * std::numbers::pi, 5.0 * dip + 0.02) / table.elevation_scale);
  return table;
}

}  // namespace airlight
