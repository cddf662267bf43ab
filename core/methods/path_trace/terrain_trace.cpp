#include "core/methods/path_trace/terrain_trace.h"

#include <algorithm>
#include <cmath>

#include "core/air/scene_block.h"

namespace airlight {

using physics::vec3;

namespace {

constexpr double kNear = 1e-5;      // km: nearer than this to the terrain is on it
constexpr double kShortest = 2e-4;  // km, of a step
constexpr double kPartOfCell = 0.05;
constexpr int kMostSteps = 20000;
constexpr double kStretch = 1.02;  // most that distances on the map exceed those in the air, with some room

double steepest_slope(const physics::HostTerrain& maps) {
  const physics::TerrainData& t = maps.shape;
  double across = 0.0;
  double down = 0.0;
  for (physics::uint j = 0; j < t.rows; ++j) {
    for (physics::uint i = 0; i < t.columns; ++i) {
      const auto at = [&](physics::uint x, physics::uint y) {
        return static_cast<double>((*maps.heights)[y * t.columns + x]);
      };
      across = i + 1 < t.columns ? std::max(across, std::abs(at(i + 1, j) - at(i, j))) : across;
      down = j + 1 < t.rows ? std::max(down, std::abs(at(i, j + 1) - at(i, j))) : down;
    }
  }
  return std::hypot(across, down) / t.texel;
}

}  // namespace

TracedTerrain::TracedTerrain(const Scene& scene, std::shared_ptr<const physics::HostTerrain> maps)
    : physics_(geometry_of(scene)),
      radius_(scene.planet.ground_radius),
      highest_(static_cast<double>(maps->heights->back())),
      steepest_(steepest_slope(*maps)) {
  physics_.terrain_maps = std::move(maps);
}

TracedTerrain::MapPlace TracedTerrain::map_place(vec3 place) const {
  const physics::TerrainData& t = physics_.terrain_maps->shape;
  const double level = std::hypot(place.x, place.z);
  const double ground = radius_ * std::atan2(level, place.y);
  const double east = level > 0.0 ? ground * place.x / level : 0.0;
  const double north = level > 0.0 ? -ground * place.z / level : 0.0;
  MapPlace at{physics_.map_column(t, east, north), physics_.map_row(t, east, north), 0.0};
  const double off_columns = std::max({-at.column, at.column - (t.columns - 1.0), 0.0});
  const double off_rows = std::max({-at.row, at.row - (t.rows - 1.0), 0.0});
  at.beside = std::hypot(off_columns, off_rows) * t.texel;
  return at;
}

double TracedTerrain::clearance(vec3 place) const {
  const MapPlace at = map_place(place);
  const double altitude = length(place) - radius_;
  return at.beside > 0.0 ? altitude : altitude - physics_.map_height(physics_.terrain_maps->shape, at.column, at.row);
}

std::optional<double> TracedTerrain::hit(vec3 from, vec3 direction, double limit) const {
  double t = 0.0;
  double before = 0.0;
  for (int i = 0; i < kMostSteps && t < limit; ++i) {
    const vec3 place = from + direction * t;
    const double r = length(place);
    const double over = r - radius_ - highest_;
    const double mu = dot(place, direction) / r;
    if (over > 0.0) {
      // Moves on to where the ray comes down to the highest peak, if it does.
      const double summit = radius_ + highest_;
      const double square = summit * summit - r * r * (1.0 - mu * mu);
      if (mu >= 0.0 || square <= 0.0) {
        return std::nullopt;
      }
      before = t;
      t += -r * mu - std::sqrt(square) + kShortest;
      continue;
    }
    const MapPlace at = map_place(place);
    const double clear = clearance(place);
    if (clear < kNear && at.beside <= 0.0) {
      if (t <= 0.0) {
        return 0.0;
      }
      double low = before;
      double high = t;
      for (int k = 0; k < 40; ++k) {
        const double middle = 0.5 * (low + high);
        (clearance(from + direction * middle) < kNear ? high : low) = middle;
      }
      return high < limit ? std::optional(high) : std::nullopt;
    }
    before = t;
    const double safe = std::max(clear / (1.0 + kStretch * steepest_), at.beside / kStretch);
    // Over rough maps that step would be next to nothing: a small part of a cell misses no terrain of note.
    const double across = std::sqrt(std::max(1.0 - mu * mu, 0.0));
    const double part =
        at.beside > 0.0 ? 0.0 : kPartOfCell * physics_.terrain_maps->shape.texel / std::max(across, 0.01);
    t += std::max({safe, part, kShortest});
  }
  return std::nullopt;
}

vec3 TracedTerrain::normal(vec3 place) const {
  const physics::TerrainData& t = physics_.terrain_maps->shape;
  const MapPlace at = map_place(place);
  const auto slope = physics_.map_slope(t, at.column, at.row, 0.5);
  const double to_east = slope.across * t.across_east - slope.up * t.across_north;
  const double to_north = slope.across * t.across_north + slope.up * t.across_east;
  const vec3 up = normalize(place);
  // The map's east and north at the camera, moved along the great circle to the place.
  const double level = std::hypot(up.x, up.z);
  const vec3 heading = level > 1e-12 ? vec3(up.x / level, 0.0, up.z / level) : vec3(0.0, 0.0, -1.0);
  const vec3 ahead = heading * up.y - vec3(0.0, level, 0.0);
  const vec3 right(-heading.z, 0.0, heading.x);
  const double slope_ahead = to_east * heading.x - to_north * heading.z;
  const double slope_right = to_east * right.x - to_north * right.z;
  return normalize(up - ahead * slope_ahead - right * slope_right);
}

physics::vec2 TracedTerrain::on_map(vec3 place) const {
  const MapPlace at = map_place(place);
  return {at.column, at.row};
}

vec3 TracedTerrain::albedo(vec3 place) const {
  const MapPlace at = map_place(place);
  return physics_.map_albedo(physics_.terrain_maps->shape, at.column, at.row);
}

}  // namespace airlight
