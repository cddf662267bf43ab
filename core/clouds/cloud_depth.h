#pragma once
// What a cloud leaves of a beam.

#include <memory>
#include <vector>

#include "core/clouds/cloud_grid.h"
#include "core/physics/physics.h"

namespace airlight {

// Optical depth of the cloud along a straight ray from the camera, which stands at the altitude `h` (km) over the
// grid's origin; up to the ground. `direction`: of length 1, x east, y up, z south.
double cloud_depth(const CloudGrid& grid, double ground_radius, double h, const physics::vec3& direction);

// What the clouds leave of a beam that comes from a direction.
double past_clouds(const std::vector<std::shared_ptr<const CloudGrid>>& clouds, const Scene& scene,
                   const physics::vec3& direction);

}  // namespace airlight
