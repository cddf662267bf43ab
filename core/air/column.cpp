#include "core/air/column.h"

#include <algorithm>
#include <iterator>

#include "core/air/refraction.h"
#include "core/scene/density_profiles.h"

namespace airlight {
namespace {

constexpr std::size_t kCells = 400;
constexpr std::size_t kMostBreaks = 14;  // between the ground and the top

std::vector<double> breaks_of(const physics::Physics& p, double height) {
  std::vector<double> breaks;
  const auto is_inside = [height](double h) { return h > 1e-6 * height && h < (1.0 - 1e-6) * height; };
  for (physics::uint i = 0; i < p.medium_count(); ++i) {
    const ProfileRow& row = profile_row(p.density_profile(i));
    if (!row.is_smooth()) {
      std::ranges::copy_if(row.marks(p, p.medium(i)), std::back_inserter(breaks), is_inside);
    }
  }
  std::ranges::sort(breaks);
  const auto same = [&](double a, double b) { return b - a < 1e-6 * height; };
  breaks.erase(std::unique(breaks.begin(), breaks.end(), same), breaks.end());
  std::vector<double> kept{0.0};
  const std::size_t stride = breaks.size() / kMostBreaks + 1;
  for (std::size_t i = stride - 1; i < breaks.size(); i += stride) {
    kept.push_back(breaks[i]);
  }
  kept.push_back(height);
  return kept;
}

}  // namespace

Column column_of(physics::Physics& p) {
  Column column;
  const double top = p.scene.planet.atmosphere_height;
  column.breaks = breaks_of(p, p.true_altitude(top).h);
  std::ranges::transform(column.breaks, column.breaks.begin(), [&](double h) { return optical_altitude(p, h); });
  column.breaks.back() = top;
  column.cells_between_breaks = kCells;
  column.edges.push_back(0.0);
  column.depth.push_back(0.0);
  for (std::size_t s = 0; s + 1 < column.breaks.size(); ++s) {
    const double low = column.breaks[s];
    const double high = column.breaks[s + 1];
    for (std::size_t k = 1; k <= kCells; ++k) {
      const double x = static_cast<double>(k) / kCells;
      column.edges.push_back(k == kCells ? high : low + (high - low) * x * x);
      const std::size_t cell = column.density.size();
      const double h = column.middle(cell);
      const double dh = column.width(cell);
      Column::PerMedium& density = column.density.emplace_back();
      physics::vec3 extinction;
      for (physics::uint i = 0; i < p.medium_count(); ++i) {
        const physics::MediumData& m = p.scene.media[i];
        density[i] = p.density(p.density_profile(i), m, h);
        column.amount[i] += density[i] * dh;
        extinction = extinction + m.scattering * density[i] + m.absorption * density[i];
      }
      column.depth.push_back(column.depth.back() + channel_mean(extinction) * dh);
    }
  }
  return column;
}

}  // namespace airlight
