#pragma once
// Examines one subject over one sweep.

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "core/stability/judge.h"
#include "core/stability/shot.h"

namespace airlight::stability {

// Converged radiances, kept from subject to subject and from place to place.
using ConvergedShots = std::map<std::string, std::vector<physics::vec3>>;

// `report` is called with the share of the block that is done, 0 to 1.
Block examine(const DeviceOnDemand& device, const Subject& subject, const Sweep& sweep, ConvergedShots& converged,
              const std::function<void(double)>& report = {});

}  // namespace airlight::stability
