#pragma once
// The air straight up from the ground, sampled once: what is asked of it vertically is a sum over these cells.

#include <array>
#include <cstddef>
#include <vector>

#include "core/physics/physics.h"
#include "core/scene/scene.h"

namespace airlight {

struct Column {
  using PerMedium = std::array<double, kMaxMedia>;

  // The ground, altitudes where a density jumps or bends (of very many each second, third ...), the top: 16 at most.
  std::vector<double> breaks;
  std::size_t cells_between_breaks = 0;  // dense above each break
  std::vector<double> edges;             // of the cells, rising from 0 to the top
  std::vector<PerMedium> density;        // in the middle of each cell
  std::vector<double> depth;             // of extinction from the ground to each edge, mean of the channels
  PerMedium amount{};                    // of each medium, integral of its density, km

  std::size_t cells() const { return density.size(); }
  double width(std::size_t cell) const { return edges[cell + 1] - edges[cell]; }
  double middle(std::size_t cell) const { return 0.5 * (edges[cell] + edges[cell + 1]); }
};

// `p`: formulas and media of the air.
Column column_of(physics::Physics& p);

}  // namespace airlight
