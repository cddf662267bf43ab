#include "core/methods/path_trace/terrain_trace.h"

#include <algorithm>
#include <cmath>

#include "core/air/scene_block.h"

namespace airlight {

using physics::vec3;

namespace {

constexpr double kNear = 1e-5;      // km: nearer than this to the terrain is on it
constexpr double kShortest = 2e-4;  // km, of a step
constexpr double kPartOfCell = 0.01;
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

// The greatest of each element and its neighbours, of numbers in rows.
std::vector<float> with_neighbours(const std::vector<float>& values, int columns, int rows) {
  std::vector<float> most(values.size());
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      float& here = most[static_cast<std::size_t>(j * columns + i)];
      here = values[static_cast<std::size_t>(j * columns + i)];
      for (int y = std::max(j - 1, 0); y <= std::min(j + 1, rows - 1); ++y) {
        for (int x = std::max(i - 1, 0); x <= std::min(i + 1, columns - 1); ++x) {
          here = std::max(here, values[static_cast<std::size_t>(y * columns + x)]);
        }
      }
    }
  }
  return most;
}

// atan2(y, x). Nearly all places are so near that five terms of the series are exact to 1e-14.
double angle_of(double y, double x) {
  constexpr double kNearby = 0.03;
  const double q = y / x;
  const double s = q * q;
  return x > 0.0 && q < kNearby ? q * (1.0 - s * (1.0 / 3.0 - s * (1.0 / 5.0 - s * (1.0 / 7.0 - s / 9.0))))
                                : std::atan2(y, x);
}

}  // namespace

TracedTerrain::TracedTerrain(const Scene& scene, std::shared_ptr<const physics::HostTerrain> maps)
    : physics_(geometry_of(scene)),
      radius_(scene.planet.ground_radius),
      highest_(static_cast<double>(maps->heights->back())),
      steepest_(steepest_slope(*maps)) {
  constexpr int kSmallest = 8;
  constexpr int kTimes = 4;
  const int columns = static_cast<int>(maps->shape.columns);
  const int rows = static_cast<int>(maps->shape.rows);
  for (int side = kSmallest; side < std::max(columns, rows); side *= kTimes) {
    Squares& squares = squares_.emplace_back(Squares{side, (columns - 1) / side + 1, (rows - 1) / side + 1, {}});
    std::vector<float> highest(static_cast<std::size_t>(squares.columns) * static_cast<std::size_t>(squares.rows));
    for (int j = 0; j < rows; ++j) {
      for (int i = 0; i < columns; ++i) {
        float& here = highest[static_cast<std::size_t>(j / side * squares.columns + i / side)];
        here = std::max(
            here, (*maps->heights)[static_cast<std::size_t>(j) * maps->shape.columns + static_cast<std::size_t>(i)]);
      }
    }
    squares.highest = with_neighbours(highest, squares.columns, squares.rows);
  }
  physics_.terrain_maps = std::move(maps);
}

// Length of a ray over the map that meets nothing, since it passes over all that is as near: a lower bound.
double TracedTerrain::free_way(const MapPlace& at, double altitude, double mu) const {
  const double across = std::max(std::sqrt(std::max(1.0 - mu * mu, 0.0)), 0.01);
  double free = 0.0;
  for (const Squares& squares : squares_) {
    const int i = static_cast<int>(at.column) / squares.side;
    const int j = static_cast<int>(at.row) / squares.side;
    const double over =
        altitude - static_cast<double>(squares.highest[static_cast<std::size_t>(j * squares.columns + i)]);
    if (over <= 0.0) {
      break;
    }
    // A height between two cells is of both: a cell less.
    const double beyond = (squares.side - 1) * physics_.terrain_maps->shape.texel / (kStretch * across);
    free = std::max(free, mu < 0.0 ? std::min(beyond, over / -mu) : beyond);
  }
  return free;
}

TracedTerrain::MapPlace TracedTerrain::map_place(vec3 place) const {
  const physics::TerrainData& t = physics_.terrain_maps->shape;
  const double level = std::sqrt(place.x * place.x + place.z * place.z);
  const double ground = radius_ * angle_of(level, place.y);
  const double east = level > 0.0 ? ground * place.x / level : 0.0;
  const double north = level > 0.0 ? -ground * place.z / level : 0.0;
  MapPlace at{physics_.map_column(t, east, north), physics_.map_row(t, east, north), 0.0};
  const double off_columns = std::max({-at.column, at.column - (t.columns - 1.0), 0.0});
  const double off_rows = std::max({-at.row, at.row - (t.rows - 1.0), 0.0});
  at.beside = std::sqrt(off_columns * off_columns + off_rows * off_rows) * t.texel;
  return at;
}

double TracedTerrain::clearance(const MapPlace& at, double altitude) const {
  return at.beside > 0.0 ? altitude : altitude - physics_.map_height(physics_.terrain_maps->shape, at.column, at.row);
}

double TracedTerrain::clearance(vec3 place) const {
  return clearance(map_place(place), length(place) - radius_);
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
    const double clear = clearance(at, r - radius_);
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
    const double safe = std::max({clear / (1.0 + kStretch * steepest_), at.beside / kStretch,
                                  at.beside > 0.0 ? 0.0 : free_way(at, r - radius_, mu)});
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
