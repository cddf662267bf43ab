// The terrain's shadow as a table: at each place the altitude below which the sun is hidden. One sweep along the way
// from the sun is enough: a place is shaded by the terrain next to it on that way, or by what shades that terrain.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "core/air/refraction.h"
#include "core/base/text.h"
#include "core/things/terrain.h"

namespace airlight {
namespace {

using physics::HostTerrain;
using physics::TerrainData;

constexpr double kMostShadowTexels = 2e6;
constexpr double kLongest = 300.0;   // km behind the map; a shadow does not change further on
constexpr double kNoTerrain = -1e4;  // km: height of terrain that casts no shadow

struct Span2 {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
  void add(double x) {
    low = std::min(low, x);
    high = std::max(high, x);
  }
};

// Distance behind the map up to which a shadow of this height is above the ground.
double shadow_length(double height, double elevation, double radius) {
  const double e = std::max(elevation, 0.0);
  const double left = e * e - 2.0 * height / radius;
  const double length = left > 0.0 ? radius * (e - std::sqrt(left)) : kLongest;
  return std::min(length, kLongest);
}

void place_table(TerrainData& t, const Sun& sun, double radius, double highest) {
  t.sunward_east = std::sin(sun.azimuth);
  t.sunward_north = std::cos(sun.azimuth);
  Span2 along;
  Span2 aside;
  for (const double x : {-0.5, 0.5}) {
    for (const double y : {-0.5, 0.5}) {
      const double right = x * (t.columns - 1.0) * t.texel;
      const double up = y * (t.rows - 1.0) * t.texel;
      const double east = t.centre_east + right * t.across_east - up * t.across_north;
      const double north = t.centre_north + right * t.across_north + up * t.across_east;
      along.add(east * t.sunward_east + north * t.sunward_north);
      aside.add(east * t.sunward_north - north * t.sunward_east);
    }
  }
  const double low_sun = sun.elevation + along.low / radius - sun.disc.angular_radius;
  along.low -= shadow_length(highest, low_sun, radius);
  const double area = (along.high - along.low) * (aside.high - aside.low);
  // Finer than the map, since it cuts across the map's heights.
  t.shadow_texel = std::max(0.25 * t.texel, std::sqrt(area / kMostShadowTexels));
  t.shadow_along = along.low;
  t.shadow_aside = aside.low;
  t.shadow_columns = static_cast<physics::uint>(std::ceil((along.high - along.low) / t.shadow_texel)) + 2U;
  t.shadow_rows = static_cast<physics::uint>(std::ceil((aside.high - aside.low) / t.shadow_texel)) + 2U;
}

// How steeply a ray toward the sun rises, km per km of ground. A sun above 1.55 rad counts as one there.
double slope_of(double elevation) {
  constexpr double kSteepest = 1.55;
  return std::tan(std::clamp(elevation, -0.5, kSteepest));
}

// How far a ray toward the sun's upper and lower limb rises over one texel, column by column: km.
std::vector<std::array<double, 2>> rises(const Sun& sun, double radius, const TerrainData& t) {
  std::vector<std::array<double, 2>> all;
  const double limb = sun.disc.angular_radius;
  for (physics::uint k = 0; k < t.shadow_columns; ++k) {
    const double elevation = sun.elevation + (t.shadow_along + (k + 0.5) * t.shadow_texel) / radius;
    all.push_back({slope_of(elevation + limb) * t.shadow_texel, slope_of(elevation - limb) * t.shadow_texel});
  }
  return all;
}

constexpr double kMostSteps = 2097151.0;
constexpr double kMostRoot = 2047.0;
constexpr double kDeep = 100.0;  // km: so far below the ground that a shadow beside none ends at once

// What a texel's bits stand for. `highest`: of the terrain, km.
void place_altitudes(TerrainData& t, const std::vector<std::array<double, 2>>& rise, double highest) {
  double climb = 0.0;  // of a shadow behind which the sun sinks
  double soft = 0.0;   // height of the widest penumbra
  for (const auto& [upper, lower] : rise) {
    climb += std::max(-lower, 0.0);
    soft += upper - lower;
  }
  t.shadow_low = -kDeep;
  t.shadow_step = (highest + climb - t.shadow_low) / kMostSteps;
  t.shadow_soft = soft / (kMostRoot * kMostRoot);
}

// A texel of a shadow whose penumbra reaches from one altitude to the other.
physics::uint texel_of(const TerrainData& t, double dark, double whole) {
  const double steps = std::round((dark - t.shadow_low) / t.shadow_step);
  if (steps < 1.0) {
    return 0;  // nowhere
  }
  const double root = t.shadow_soft > 0.0 ? std::round(std::sqrt((whole - dark) / t.shadow_soft)) : 0.0;
  return static_cast<physics::uint>(std::min(steps, kMostSteps)) << 11U |
         static_cast<physics::uint>(std::min(root, kMostRoot));
}

// The table, swept row by row along the way from the sun.
std::vector<physics::uint> swept(const std::vector<std::array<double, 2>>& rise,
                                 const std::shared_ptr<const HostTerrain>& bare, const TerrainData& t) {
  physics::Physics p;
  p.terrain_maps = bare;
  std::vector<physics::uint> shadows(static_cast<std::size_t>(t.shadow_columns) * t.shadow_rows);
  const auto place = [&](double along, double aside) {
    const double east = along * t.sunward_east + aside * t.sunward_north;
    const double north = along * t.sunward_north - aside * t.sunward_east;
    return std::array{p.map_column(t, east, north), p.map_row(t, east, north)};
  };
  for (physics::uint j = 0; j < t.shadow_rows; ++j) {
    const double aside = t.shadow_aside + j * t.shadow_texel;
    const std::array<double, 2> first = place(t.shadow_along, aside);
    const std::array<double, 2> second = place(t.shadow_along + t.shadow_texel, aside);
    std::array<double, 2> shadow{kNoTerrain, kNoTerrain};  // of the disc's upper and lower limb
    double terrain = kNoTerrain;
    physics::uint* const row_of_table = &shadows[static_cast<std::size_t>(j) * t.shadow_columns];
    for (physics::uint k = t.shadow_columns; k-- > 0;) {
      for (std::size_t edge = 0; edge < 2; ++edge) {
        shadow[edge] = std::max(std::max(shadow[edge], terrain) - rise[k][edge], kNoTerrain);
      }
      const double column = first[0] + k * (second[0] - first[0]);
      const double row = first[1] + k * (second[1] - first[1]);
      const bool on_map = column >= 0.0 && row >= 0.0 && column <= t.columns - 1.0 && row <= t.rows - 1.0;
      terrain = on_map ? p.map_height(t, column, row) : kNoTerrain;
      row_of_table[k] = texel_of(t, shadow[0], shadow[1]);
    }
  }
  return shadows;
}

// Greatest distance of a shadow from the camera, km along the ground.
double shadow_reach(const TerrainData& t) {
  double reach = 0.0;
  for (const double i : {0.0, t.shadow_columns - 1.0}) {
    for (const double j : {0.0, t.shadow_rows - 1.0}) {
      reach = std::max(reach, std::hypot(t.shadow_along + i * t.shadow_texel, t.shadow_aside + j * t.shadow_texel));
    }
  }
  return reach;
}

}  // namespace

HostTerrain with_shadow(const std::shared_ptr<const HostTerrain>& heights, const Sun& sun, double planet_radius) {
  HostTerrain out = *heights;
  place_table(out.shape, sun, planet_radius, static_cast<double>(out.heights->back()));
  out.shape.shadow_reach = shadow_reach(out.shape);
  const std::vector<std::array<double, 2>> rise = rises(sun, planet_radius, out.shape);
  place_altitudes(out.shape, rise, static_cast<double>(out.heights->back()));
  out.shadows = std::make_shared<const std::vector<physics::uint>>(swept(rise, heights, out.shape));
  return out;
}

std::string shadow_key(const Scene& scene) {
  std::string key = height_key(*scene.terrain);
  for (const double number :
       {scene.sun.elevation, scene.sun.azimuth, scene.sun.disc.angular_radius, scene.planet.ground_radius}) {
    key += " " + shortest(number);
  }
  return key + refraction_key(scene.planet);
}

}  // namespace airlight
