#pragma once
// Grids of a cloud's extinction that differ in the size of their cells. All cores take part.

#include <cstddef>
#include <cstdint>
#include <vector>

namespace airlight {

// Cells of a cloud between two altitudes, x to the east fastest, then y to the north, then up. The grid repeats itself
// in x and y.
struct CloudCells {
  std::uint32_t nx = 1;
  std::uint32_t ny = 1;
  std::uint32_t nz = 1;
  double cell_x = 1.0;  // km
  double cell_y = 1.0;
  double cell_z = 1.0;
  std::vector<float> extinction = {};  // 1/km

  std::size_t count() const { return std::size_t{nx} * ny * nz; }
};

// What a cell's value is: the mean over it, or that of its middle, linear between the middles and constant beyond the
// outermost upward and downward.
enum class CellValues { means, middles };

// Cells without values of the same cloud, at most so many a side.
CloudCells coarse_shape(const CloudCells& cells, std::uint32_t most_x, std::uint32_t most_y, std::uint32_t most_z);

// The mean over boxes of cells, at most so many a side; what is left over at the far edge is shared out by length.
CloudCells coarsened(const CloudCells& cells, std::uint32_t most_x, std::uint32_t most_y, std::uint32_t most_z,
                     CellValues values = CellValues::means);

// The coarse cells with less extinction where the fine ones that they are the means of differ, since light goes past
// lumps of water: over 1 + 0.02 V, of the variance V over the square of the mean. After Cairns, Lacis and Carlson 2000,
// whose lumps are small beside a free path; these are not, and 0.02 is what pictures ask for.
CloudCells with_lumps(CloudCells coarse, CloudCells fine, CellValues values);

// For each cell, the number of steps to the nearest cell with water, at most 64; a step goes to any of 26 neighbours.
std::vector<float> gaps_of(const CloudCells& cells);

}  // namespace airlight
