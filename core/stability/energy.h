#pragma once
// Energy that leaves a planet over energy that reaches it.

#include "core/stability/shot.h"
#include "core/stability/subject.h"

namespace airlight::stability {

// In the largest channel, light that leaves the air upward over the whole globe, over sunlight on the disc of the top
// of the air. At most 1 for air and ground that add no light. Light that passes the air unscattered counts as neither.
double reflected_share(const DeviceOnDemand& device, const Subject& subject, const Place& place);

}  // namespace airlight::stability
