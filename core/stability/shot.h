#pragma once
// One place, rendered by one method on the device and by the same formulas on the host in double.

#include <vector>

#include "core/gpu/executor.h"
#include "core/physics/physics.h"
#include "core/render/render.h"
#include "core/stability/sweep.h"

namespace airlight::stability {

struct Shot {
  std::vector<physics::vec3> radiance;       // one a direction
  std::vector<physics::vec3> transmittance;  // empty for a picture
  // The tables by name as the device filled them, if asked for; the formulas in double read them.
  HostTables tables;
};

struct ShotOptions {
  bool as_picture = false;  // the scene's camera, else its pixels as listed directions
  bool tables = false;
};

Shot shoot(const DeviceOnDemand& device, const Scene& scene, const std::vector<Direction>& directions,
           const ShotOptions& options);

// The radiance by the method's own formulas in double, from the device's tables, in the same directions rounded to 32
// bits as on the device. Empty where the method has no such formulas here.
std::vector<physics::vec3> in_double(const Scene& scene, const Shot& shot, const std::vector<Direction>& directions);

}  // namespace airlight::stability
