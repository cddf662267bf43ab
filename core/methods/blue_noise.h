#pragma once
// A mask of noise without low frequencies: each pixel its place within the steps, so that what few steps leave shows as
// fine grain, not as bands.

#include <cstddef>
#include <vector>

namespace airlight {

// side x side values, row by row, that repeat seamlessly: (rank + 0.5) / side^2, each rank once, by void and cluster
// [U93]. The same on every machine. side: a power of two, 16 to 128.
std::vector<float> void_and_cluster(std::size_t side);

}  // namespace airlight
