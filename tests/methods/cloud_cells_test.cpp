// Grids of a cloud's cells.
#include "core/luts/cloud_cells.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <vector>

namespace airlight {
namespace {

// The most steps along an axis of `count` cells; `repeats`: the way round may be shorter.
int steps_between(int a, int b, int count, bool repeats) {
  const int way = std::abs(a - b);
  return repeats ? std::min(way, count - way) : way;
}

// Steps go to any of 26 neighbours, so their number is the largest of the three along the axes.
TEST(CloudCells, GapsAreDistancesToWater) {
  struct Place {
    int x, y, z;
  };
  const std::vector<std::vector<Place>> fields{
      {}, {{1, 7, 2}}, {{1, 7, 2}, {8, 3, 0}, {4, 0, 5}}, {{0, 0, 0}, {8, 7, 5}, {3, 3, 3}, {3, 4, 3}}};
  for (const std::vector<Place>& water : fields) {
    CloudCells cells{.nx = 9, .ny = 8, .nz = 6};
    cells.extinction.assign(cells.count(), 0.0F);
    const auto index = [](int x, int y, int z) { return static_cast<std::size_t>((z * 8 + y) * 9 + x); };
    for (const Place& p : water) cells.extinction[index(p.x, p.y, p.z)] = 1.0F;
    const std::vector<float> gaps = gaps_of(cells);
    for (int z = 0; z < 6; ++z) {
      for (int y = 0; y < 8; ++y) {
        for (int x = 0; x < 9; ++x) {
          int nearest = 64;
          for (const Place& p : water) {
            nearest = std::min(nearest, std::max({steps_between(x, p.x, 9, true), steps_between(y, p.y, 8, true),
                                                  steps_between(z, p.z, 6, false)}));
          }
          EXPECT_EQ(gaps[index(x, y, z)], static_cast<float>(nearest)) << x << " " << y << " " << z;
        }
      }
    }
  }
}

// Far from all water the distance is not told.
TEST(CloudCells, GapsEndAtSixtyFour) {
  CloudCells cells{.nx = 200, .ny = 1, .nz = 1};
  cells.extinction.assign(cells.count(), 0.0F);
  cells.extinction[0] = 1.0F;
  const std::vector<float> gaps = gaps_of(cells);
  EXPECT_EQ(gaps[63], 63.0F);
  EXPECT_EQ(gaps[100], 64.0F);
  EXPECT_EQ(gaps[199], 1.0F);
}

}  // namespace
}  // namespace airlight
