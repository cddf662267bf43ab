#include "core/things/terrain.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/gpu/kept_values.h"

namespace airlight {
namespace {

using physics::HostTerrain;
using physics::TerrainData;

// Altitude for heights at or below the ground sphere, km: so low that rounding does not lift them above it.
constexpr float kUnderground = -1e-3F;

constexpr int kRidgeColumns = 1024;
constexpr int kRidgeRows = 512;

// A number from -1 to 1 for a corner of the grid (the finalizer of MurmurHash3).
double corner(std::uint32_t seed, int x, int y, int octave) {
  std::uint32_t n = seed * 0x9E3779B9U + static_cast<std::uint32_t>(x) * 0x85EBCA6BU +
                    static_cast<std::uint32_t>(y) * 0xC2B2AE35U + static_cast<std::uint32_t>(octave) * 0x27D4EB2FU;
  n = (n ^ (n >> 16U)) * 0x85EBCA6BU;
  n = (n ^ (n >> 13U)) * 0xC2B2AE35U;
  n ^= n >> 16U;
  return static_cast<double>(n) / 2147483647.5 - 1.0;
}

double fade(double x) {
  return x * x * x * (x * (x * 6.0 - 15.0) + 10.0);
}

// Noise along a row of points. Neighbours mostly share the corners of a cell.
class NoiseRow {
 public:
  NoiseRow(std::uint32_t seed, double y, int octave) : seed_(seed), octave_(octave) {
    row_ = static_cast<int>(std::floor(y));
    down_ = fade(y - row_);
  }

  // x: not negative.
  double at(double x) {
    const auto column = static_cast<int>(x);
    if (column != column_) {
      column_ = column;
      upper_ = {corner(seed_, column, row_, octave_), corner(seed_, column + 1, row_, octave_)};
      lower_ = {corner(seed_, column, row_ + 1, octave_), corner(seed_, column + 1, row_ + 1, octave_)};
    }
    const double across = fade(x - column);
    const double upper = upper_[0] + (upper_[1] - upper_[0]) * across;
    const double lower = lower_[0] + (lower_[1] - lower_[0]) * across;
    return upper + (lower - upper) * down_;
  }

 private:
  std::uint32_t seed_;
  int octave_;
  int row_ = 0;
  int column_ = std::numeric_limits<int>::min();
  double down_ = 0.0;
  std::array<double, 2> upper_{};
  std::array<double, 2> lower_{};
};

// Ridged noise along a row, about 0 to 1: sharp where an octave changes its sign, rough where the previous octaves are
// high.
class RidgedRow {
 public:
  RidgedRow(std::uint32_t seed, double y) {
    for (int octave = 0; octave < kOctaves; ++octave) {
      octaves_.emplace_back(seed, y, octave);
      y = 1.97 * y - 5.1;
    }
  }

  double at(double x) {
    double sum = 0.0;
    double weight = 1.0;
    double strength = 0.5;
    for (NoiseRow& octave : octaves_) {
      const double crest = 1.0 - std::abs(octave.at(x));
      sum += crest * crest * weight * strength;
      weight = std::clamp(1.6 * crest * crest, 0.0, 1.0);
      strength *= 0.5;
      x = 2.03 * x + 17.7;
    }
    return sum;
  }

 private:
  static constexpr int kOctaves = 8;
  std::vector<NoiseRow> octaves_;
};

double smooth(double x) {
  const double t = std::clamp(x, 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

// Of a range's columns: where its crest stands, and how its height falls toward the ends.
struct RidgeColumn {
  double x;
  double crest;
  double ends;
};

std::vector<RidgeColumn> ridge_columns(std::uint32_t seed) {
  NoiseRow bends(seed, 0.5, 31);
  std::vector<RidgeColumn> columns;
  for (int column = 0; column < kRidgeColumns; ++column) {
    const double x = static_cast<double>(column) / (kRidgeColumns - 1);
    columns.push_back({x, 0.5 + 0.12 * bends.at(3.0 * x), smooth(8.0 * x) * smooth(8.0 * (1.0 - x))});
  }
  return columns;
}

// A seeded mountain range: heights in km, row by row, 0 at the edges; the highest is the ridge's height.
std::vector<float> ridge_heights(const Ridge& ridge) {
  constexpr double kFeatures = 9.0;  // of the coarsest octave along the range
  const auto seed = static_cast<std::uint32_t>(ridge.seed);
  const std::vector<RidgeColumn> columns = ridge_columns(seed);
  std::vector<double> heights;
  heights.reserve(static_cast<std::size_t>(kRidgeColumns) * static_cast<std::size_t>(kRidgeRows));
  for (int row = 0; row < kRidgeRows; ++row) {
    const double y = static_cast<double>(row) / (kRidgeRows - 1);
    RidgedRow peaks(seed, 0.5 * kFeatures * y);
    for (const RidgeColumn& column : columns) {
      const double across = std::abs(y - column.crest) / (y < column.crest ? column.crest : 1.0 - column.crest);
      const double flank = std::pow(std::max(1.0 - across, 0.0), 1.3);
      heights.push_back(flank * column.ends * (0.25 + peaks.at(kFeatures * column.x)));
    }
  }
  const double highest = *std::ranges::max_element(heights);
  std::vector<float> scaled;
  scaled.reserve(heights.size());
  for (const double h : heights) {
    scaled.push_back(static_cast<float>(h * (ridge.height / highest)));
  }
  return scaled;
}

std::vector<float> heights_of(const Terrain& terrain) {
  if (terrain.ridge) {
    return terrain.ridge_heights ? *terrain.ridge_heights : *ridge_heights_of(*terrain.ridge);
  }
  std::vector<float> heights;
  heights.reserve(terrain.files->heights.size());
  for (const float value : terrain.files->heights) {
    heights.push_back(
        static_cast<float>(terrain.lowest + (terrain.highest - terrain.lowest) * static_cast<double>(value)));
  }
  return heights;
}

// The greatest of the four heights of each cell, then of each four cells, and so on to one.
void append_maxima(TerrainData& t, std::vector<float>& heights) {
  std::size_t across = t.columns - 1;
  std::size_t down = t.rows - 1;
  std::size_t below = 0;
  t.levels = 0;
  for (;; ++t.levels) {
    const std::size_t first = heights.size();
    t.level_first[t.levels] = static_cast<physics::uint>(first);
    const bool cells = t.levels == 0;
    const std::size_t wide = cells ? t.columns : ((t.columns - 2U) >> (t.levels - 1U)) + 1U;
    const std::size_t high = cells ? t.rows : ((t.rows - 2U) >> (t.levels - 1U)) + 1U;
    for (std::size_t j = 0; j < down; ++j) {
      for (std::size_t i = 0; i < across; ++i) {
        const std::size_t x0 = cells ? i : 2 * i;
        const std::size_t y0 = cells ? j : 2 * j;
        const std::size_t x1 = std::min(x0 + 1, wide - 1);
        const std::size_t y1 = std::min(y0 + 1, high - 1);
        const auto at = [&](std::size_t x, std::size_t y) { return heights[below + y * wide + x]; };
        heights.push_back(std::max(std::max(at(x0, y0), at(x1, y0)), std::max(at(x0, y1), at(x1, y1))));
      }
    }
    below = first;
    if (across == 1 && down == 1) {
      ++t.levels;
      return;
    }
    across = (across + 1) / 2;
    down = (down + 1) / 2;
  }
}

physics::uint packed(const std::array<double, 3>& albedo) {
  physics::uint bits = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    const double root = std::sqrt(std::clamp(albedo[c], 0.0, 1.0));
    bits |= static_cast<physics::uint>(std::lround(root * 1023.0)) << (10U * c);
  }
  return bits;
}

void put_colours(HostTerrain& out, const Terrain& terrain) {
  const TerrainFiles* files = terrain.files.get();
  out.colours.clear();
  if (files == nullptr || files->colours.empty()) {
    out.shape.colour_columns = 1;
    out.shape.colour_rows = 1;
    out.colours = {packed(terrain.albedo)};
    return;
  }
  out.shape.colour_columns = static_cast<physics::uint>(files->colour_columns);
  out.shape.colour_rows = static_cast<physics::uint>(files->colour_rows);
  out.colours.reserve(files->colours.size() / 3);
  for (std::size_t i = 0; i + 2 < files->colours.size(); i += 3) {
    std::array<double, 3> albedo{};
    for (std::size_t c = 0; c < 3; ++c) {
      albedo[c] = terrain.albedo[c] * mixed(terrain.mix, c, &files->colours[i]);
    }
    out.colours.push_back(packed(albedo));
  }
}

}  // namespace

std::shared_ptr<const std::vector<float>> ridge_heights_of(const Ridge& ridge) {
  const std::string key = "ridge " + std::to_string(ridge.seed) + " " + shortest(ridge.height);
  return std::make_shared<const std::vector<float>>(kept_floats(key, [&ridge] { return ridge_heights(ridge); }));
}

HostTerrain placed_heights(const Terrain& terrain) {
  HostTerrain out;
  TerrainData& t = out.shape;
  t.columns = static_cast<physics::uint>(terrain.ridge ? kRidgeColumns : terrain.files->columns);
  t.rows = static_cast<physics::uint>(terrain.ridge ? kRidgeRows : terrain.files->rows);
  t.texel = terrain.width / (t.columns - 1.0);
  t.centre_east = terrain.distance * std::sin(terrain.bearing);
  t.centre_north = terrain.distance * std::cos(terrain.bearing);
  t.across_east = std::cos(terrain.turn);
  t.across_north = -std::sin(terrain.turn);
  std::vector<float> heights = heights_of(terrain);
  for (float& h : heights) {
    h = h > 0.0F ? h : kUnderground;
  }
  append_maxima(t, heights);
  out.heights = std::make_shared<const std::vector<float>>(std::move(heights));
  return out;
}

// A map may reach below the ground, but not with all of it: then there is nothing to see, and no shadow to place.
void refuse_sunken(const Terrain& terrain, const HostTerrain& maps) {
  if (maps.heights->back() > 0.0F) {
    return;
  }
  if (terrain.highest > 0.0) {
    throw InputError("/planet/terrain/height_map: " + terrain.height_map +
                     ": even its brightest pixel does not rise above the ground; raise lowest_km, take a map that is "
                     "not black all over, or remove the terrain");
  }
  throw InputError("/planet/terrain/highest_km: " + rounded(terrain.highest, 6) +
                   " leaves no point of the map above the ground; raise it above 0, or remove the terrain");
}

void refuse_buried_camera(double altitude, const std::shared_ptr<const HostTerrain>& terrain) {
  physics::Physics p;
  p.terrain_maps = terrain;
  const TerrainData& t = terrain->shape;
  const double column = p.map_column(t, 0.0, 0.0);
  const double row = p.map_row(t, 0.0, 0.0);
  const bool beside = column < 0.0 || row < 0.0 || column > t.columns - 1.0 || row > t.rows - 1.0;
  const double height = beside ? 0.0 : p.map_height(t, column, row);
  if (height >= altitude) {
    throw InputError("/camera/altitude_km: " + rounded(altitude, 6) + " km is inside the terrain, which is " +
                     rounded(height, 4) + " km high there; raise the camera above it");
  }
}

std::string height_key(const Terrain& terrain) {
  std::string key =
      terrain.ridge ? "ridge " + std::to_string(terrain.ridge->seed) + " " + shortest(terrain.ridge->height) : "map";
  key += terrain.files ? " of " + terrain.files->identity : "";
  for (const double number :
       {terrain.width, terrain.lowest, terrain.highest, terrain.bearing, terrain.distance, terrain.turn}) {
    key += " " + shortest(number);
  }
  return key;
}

std::string terrain_key(const Terrain& terrain) {
  std::string key = height_key(terrain);
  for (std::size_t c = 0; c < 3; ++c) {
    key += " " + shortest(terrain.albedo[c]);
    for (std::size_t j = 0; j < 3 && !terrain.albedo_map.empty(); ++j) {
      key += " " + shortest(terrain.mix[c][j]);
    }
  }
  return key;
}

HostTerrain with_albedo(const HostTerrain& heights, const Terrain& terrain) {
  HostTerrain out = heights;
  put_colours(out, terrain);
  return out;
}

}  // namespace airlight
