#include "core/air/moment_axes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace airlight {
namespace {

constexpr int kLayers = 1000;  // the highest row stands at a whole one of them

// The lowest of the layers' edges above which no more than this share of the vertical scattering stands; mean over
// channels.
int layer_below_share(const physics::Physics& p, const Column& column, double share) {
  std::vector<double> up_to{0.0};  // each edge
  for (std::size_t k = 0; k < column.cells(); ++k) {
    double here = 0.0;
    for (physics::uint i = 0; i < p.medium_count(); ++i) {
      const physics::vec3& s = p.scene.media[i].scattering;
      here += column.density[k][i] * (s.x + s.y + s.z);
    }
    up_to.push_back(up_to.back() + here * column.width(k));
  }
  const double aim = up_to.back() * (1.0 - share);
  const auto found = std::upper_bound(up_to.begin(), up_to.end(), aim);
  const auto k = static_cast<std::size_t>(found - up_to.begin());
  if (k >= up_to.size()) {
    return kLayers;  // nothing scatters
  }
  const double part = (aim - up_to[k - 1]) / (up_to[k] - up_to[k - 1]);
  const double h = column.edges[k - 1] + part * column.width(k - 1);
  return std::clamp(static_cast<int>(std::ceil(kLayers * h / column.edges.back())), 1, kLayers);
}

}  // namespace

physics::MomentTableData moment_axes(physics::Physics& p, const Column& column) {
  constexpr double kLeftAbove = 1.5e-4;
  physics::MomentTableData table;
  table.top = p.scene.planet.atmosphere_height * layer_below_share(p, column, kLeftAbove) / kLayers;
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
