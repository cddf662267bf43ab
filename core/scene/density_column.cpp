#include "core/scene/density_column.h"

#include <algorithm>
#include <vector>

#include "core/scene/density_profiles.h"

namespace airlight {
namespace {

// By Gauss and Legendre's two points, in pieces of at most a quarter of a scale.
double column_by_quadrature(physics::Physics& p, const ProfileRow& row, double top) {
  const physics::MediumData m = p.medium(0);
  const double scale = std::min({top / 8.0, 0.25 * m.scale_height, 0.25 * m.half_width});
  std::vector<double> edges = row.marks(p, m);
  edges.insert(edges.end(), {0.0, top});
  std::ranges::sort(edges);
  double sum = 0.0;
  for (std::size_t k = 1; k < edges.size(); ++k) {
    const double low = std::clamp(edges[k - 1], 0.0, top);
    const double high = std::clamp(edges[k], 0.0, top);
    const int pieces = static_cast<int>(std::clamp((high - low) / scale + 1.0, 1.0, 1000.0));
    const double width = (high - low) / pieces;
    for (int i = 0; i < pieces && width > 0.0; ++i) {
      const double middle = low + (i + 0.5) * width;
      const double away = 0.28867513459481287 * width;
      sum += 0.5 * width * (p.density(row.code, m, middle - away) + p.density(row.code, m, middle + away));
    }
  }
  return sum;
}

}  // namespace

double density_column(const Density& density, double top) {
  physics::Physics p;
  put_density(p, 0, density);
  const ProfileRow& row = profile_row(density.profile);
  return row.panels != nullptr ? column_by_quadrature(p, row, top) : row.column(p, p.medium(0), top);
}

double column_km(const Density& density, double top) {
  physics::Physics p;
  put_density(p, 0, density);
  return profile_row(density.profile).column(p, p.medium(0), top);
}

double optical_depth_of(const Medium& medium, double top) {
  double largest = 0.0;
  for (std::size_t c = 0; c < 3; ++c) {
    largest = std::max(largest, medium.scattering[c] + medium.absorption[c]);
  }
  return largest * column_km(medium.density, top);
}

}  // namespace airlight
