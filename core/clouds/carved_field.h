#pragma once
// Fields of clouds whose edges are finer than their grid (shaders/physics/cloud_edge.glsl).

#include "core/clouds/cloud_grid.h"

namespace airlight {

struct Carving {
  double tile = 0.0;      // km, after which the noise repeats itself, about; its largest lobes are a quarter of it
  double most = 0.0;      // km, that the noise takes off
  double soft = 0.0;      // km, over which the extinction falls to 0
  double gentlest = 0.0;  // 1/km, slope of the depths below which they count as this steep
};

// Carves a field of which `extinction` holds depths inside the cloud, of any unit, about 0 at the edge, such that the
// share `cover` of the lines through the columns' middles meets water. `low`, `high`: extinction inside the cloud at
// base and top, 1/km.
void carve_field(CloudGrid& grid, double cover, double low, double high, const Carving& carving);

}  // namespace airlight
