#pragma once
// All orders of scattering in air cut into shells as if it were level: the planet flat, and each sun's column of the
// table apart from the others. Then an order is a product with one matrix for all suns, and all orders are a matrix,
// too: what a field F that obeys F = S + one_order(F) holds beyond its source S. The bake by shells starts from it and
// corrects its field by it (orders_level.comp).

#include <cstddef>
#include <vector>

#include "core/air/air.h"

namespace airlight {

// Unknowns are the moments M_lm up to degree l and m at the rows, of polarised light P_m up to m, too, and the
// irradiance of the ground.
struct LevelShape {
  int rows = 2;
  int degree = 0;  // harmonics up to it
  bool polarised = false;

  std::size_t values() const;  // of the matrix, three channels each
};

// The matrix as the pass reads it, channels innermost: for each m, for each unknown that gives (by l, then P_m, each by
// row; after those of m = 0 the irradiance), for each unknown that takes, a value a row; at the end, what each unknown
// of m = 0 gives to the irradiance. `lost`: the share of its light that each order is taken to lose besides, which
// keeps the sum of the orders finite. `table_degree`, `delta`: of the table of moments.
std::vector<float> level_orders(const Air& air, const LevelShape& shape, int table_degree, bool delta, double lost);

}  // namespace airlight
