#include "core/methods/path_trace/optical_depth.h"

#include <algorithm>
#include <cmath>

#include "core/air/refraction.h"

namespace airlight {

using physics::MediumData;
using physics::uint;
using physics::vec3;

namespace {

constexpr int kMostNodes = 12;
constexpr int kSmoothNodes = 6;  // of a smooth piece that a ray crosses without bending round the planet
// Number of scale heights at which an exponential medium ends: exp(-18) = 1.5e-8 of it is left out.
constexpr double kOver = 18.0;

}  // namespace

OpticalDepth::OpticalDepth(physics::Physics& physics) : physics_(physics), plain_(1), falling_(1) {
  for (int n = 1; n <= kMostNodes; ++n) {
    plain_.push_back(gauss_legendre(n));
    falling_.push_back(gauss_falling(n));
  }
  for (uint i = 0; i < physics_.medium_count(); ++i) {
    const vec3 extinction = physics_.medium(i).scattering + physics_.medium(i).absorption;
    if (extinction.x > 0.0 || extinction.y > 0.0 || extinction.z > 0.0) {
      add_pieces(i);
    }
  }
}

void OpticalDepth::add_piece(Shape shape, uint i, MediumData medium, double low, double high) {
  const double top = physics_.scene.planet.atmosphere_height;
  low = optical_altitude(physics_, std::max(low, 0.0));
  high = std::min(optical_altitude(physics_, high), top);
  const vec3 extinction = physics_.medium(i).scattering + physics_.medium(i).absorption;
  const auto add = [&](double from, double to) {
    pieces_.push_back({shape, i, physics_.density_profile(i), medium, extinction, from, to});
  };
  if (physics_.refraction && (shape == Shape::constant || shape == Shape::linear)) {
    // Over optical altitudes nothing is constant or quite linear, least near the ground.
    constexpr double kSmooth = 4.0;  // km
    constexpr double kShare = 0.5;   // of the altitude
    shape = Shape::linear;
    for (double step = kSmooth; high - low > step; step = std::max(kSmooth, kShare * low)) {
      add(low, low + step);
      low += step;
    }
  }
  if (low < high) {
    add(low, high);
  }
}

void OpticalDepth::add_pieces(uint i) {
  const MediumData m = physics_.medium(i);
  const ProfileRow& row = profile_row(physics_.density_profile(i));
  const double top = physics_.true_altitude(physics_.scene.planet.atmosphere_height).h;
  std::vector<double> edges = row.panels != nullptr ? row.panels(m, top) : row.marks(physics_, m);
  if (row.panels == nullptr) {
    edges.insert(edges.begin(), 0.0);
    edges.push_back(top);
  }
  for (uint k = 0; k + 1 < edges.size(); ++k) {
    const Shape shape = k == 0 ? row.under : k + 2 == edges.size() ? row.above : row.between;
    if (shape != Shape::none) {
      // Each segment of layers becomes layers of its own, so that a look-up need not pass through all of them.
      MediumData part = m;
      part.first_layer += k == 0 ? 0 : k - 1;
      part.layer_count = shape == Shape::linear ? 2 : 1;
      add_piece(shape, i, part, edges[k], edges[k + 1]);
    }
  }
}

// Visits the ray as one climb, or as two from its lowest point.
template <class Visit>
void OpticalDepth::for_each_climb(double h, double mu, double distance, const Visit& visit) const {
  const physics::Physics::Ray ray{h, mu, 0.0, 0.0, distance, false, 0.0, false};
  const physics::PlanetData& planet = physics_.scene.planet;
  const physics::Physics::RayPoint end = physics_.point_on_ray(planet, ray, distance);
  if (mu >= 0.0) {
    visit(climb(h, mu, distance, end.h));
    return;
  }
  const double to_lowest = -(planet.ground_radius + h) * mu;
  if (distance <= to_lowest) {
    visit(climb(end.h, std::max(-end.mu, 0.0), distance, h));
    return;
  }
  const double lowest = physics_.point_on_ray(planet, ray, to_lowest).h;
  visit(climb(lowest, 0.0, to_lowest, h));
  visit(climb(lowest, 0.0, distance - to_lowest, end.h));
}

template <class Visit>
void OpticalDepth::for_each_climb_to_top(double h, double mu, const Visit& visit) const {
  const physics::PlanetData& planet = physics_.scene.planet;
  const double distance = physics_.distance_to_top(planet, h, mu);
  if (mu >= 0.0) {
    visit(climb(h, mu, distance, planet.atmosphere_height));
    return;
  }
  for_each_climb(h, mu, distance, visit);
}

vec3 OpticalDepth::along(double h, double mu, double distance) const {
  vec3 depth(0.0);
  for_each_climb(h, mu, distance, [&](const Climb& path) { depth = depth + depth_of(path); });
  return depth;
}

vec3 OpticalDepth::to_top(double h, double mu) const {
  vec3 depth(0.0);
  for_each_climb_to_top(h, mu, [&](const Climb& path) { depth = depth + depth_of(path); });
  return depth;
}

vec3 OpticalDepth::through(const Columns& columns) const {
  vec3 depth(0.0);
  for (uint i = 0; i < physics_.medium_count(); ++i) {
    depth = depth + (physics_.medium(i).scattering + physics_.medium(i).absorption) * columns[i];
  }
  return depth;
}

Columns OpticalDepth::columns_along(double h, double mu, double distance) const {
  Columns columns{};
  for_each_climb(h, mu, distance, [&](const Climb& path) { columns = columns + columns_of(path); });
  return columns;
}

Columns OpticalDepth::columns_to_top(double h, double mu) const {
  Columns columns{};
  for_each_climb_to_top(h, mu, [&](const Climb& path) { columns = columns + columns_of(path); });
  return columns;
}

OpticalDepth::Climb OpticalDepth::climb(double h, double mu, double length, double h_end) const {
  const double r = physics_.scene.planet.ground_radius + h;
  return {h, r, r * mu, length, std::max(h_end, h)};
}

vec3 OpticalDepth::depth_of(const Climb& path) const {
  vec3 depth(0.0);
  for (const Piece& piece : pieces_) {
    depth = depth + piece.extinction * column(piece, path);
  }
  return depth;
}

Columns OpticalDepth::columns_of(const Climb& path) const {
  Columns columns{};
  for (const Piece& piece : pieces_) {
    columns[piece.index] += column(piece, path);
  }
  return columns;
}

// Integral of the piece's density over the part of the path inside it, km.
double OpticalDepth::column(const Piece& piece, const Climb& path) const {
  const double low = std::max(piece.low, path.h);
  double high = std::min(piece.high, path.h_end);
  if (piece.shape == Shape::falling) {
    high = std::min(high, low + kOver * piece.medium.scale_height);
  }
  if (low >= high) {
    // A level path inside the piece has no height but has length.
    const bool inside = path.h == path.h_end && path.h >= piece.low && path.h < piece.high;
    return inside ? panel(piece, path, 0.0, path.length) : 0.0;
  }
  const auto distance = [&](double altitude) {
    const double c = (altitude - path.h) * (path.r + path.r + altitude - path.h);
    return c / (path.r_mu + std::sqrt(path.r_mu * path.r_mu + c));
  };
  double from = low > path.h ? distance(low) : 0.0;
  const double to = high < path.h_end ? distance(high) : path.length;
  if (piece.shape == Shape::constant) {
    return (to - from) * physics_.density(piece.profile, piece.medium, 0.5 * (low + high));
  }
  // On a small planet altitude bends sharply along the ray: a panel is at most twice as long as the radius at its
  // start.
  double sum = 0.0;
  double r = physics_.scene.planet.ground_radius + low;
  while (to - from > 2.0 * r) {
    sum += panel(piece, path, from, from + 2.0 * r);
    from += 2.0 * r;
    r = std::sqrt(path.r * path.r + from * (2.0 * path.r_mu + from));
  }
  return sum + panel(piece, path, from, to);
}

// `fall`: scale heights between the panel's ends.
const GaussRule& OpticalDepth::rule_for(const Piece& piece, double r, double length, double fall) const {
  if (piece.shape == Shape::linear) {
    return plain_[length < 0.1 * r ? 3 : 10];
  }
  if (piece.shape == Shape::smooth) {
    return plain_[length < 0.1 * r ? kSmoothNodes : kMostNodes];
  }
  if (fall < 0.1 && length < 0.1 * r) {
    return plain_[3];
  }
  if (fall < 2.0 && length < 0.1 * r) {
    return plain_[6];
  }
  return falling_[kMostNodes];
}

double OpticalDepth::panel(const Piece& piece, const Climb& path, double from, double to) const {
  const double length = to - from;
  const double rise = length * (2.0 * path.r_mu + from + to) / (2.0 * path.r);
  const GaussRule& rule = rule_for(piece, path.r, length, rise / piece.medium.scale_height);
  double sum = 0.0;
  for (std::size_t k = 0; k < rule.nodes.size(); ++k) {
    const double t = from + length * rule.nodes[k];
    const double q = t * (2.0 * path.r_mu + t);
    const double h = path.h + q / (std::sqrt(path.r * path.r + q) + path.r);
    sum += rule.weights[k] * physics_.density(piece.profile, piece.medium, h);
  }
  return length * sum;
}

}  // namespace airlight
