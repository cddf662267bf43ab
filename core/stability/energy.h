#pragma once
// Energy that leaves a planet over energy that reaches it.

#include "core/stability/shot.h"
#include "core/stability/subject.h"

namespace airlight::stability {

// Light that leaves the air over the whole globe, with what passes through its rim unscattered, over sunlight on the
// disc of the top of the air, in the largest channel. It is 1 where nothing absorbs, at most 1 for air and ground that
// add no light.
double returned_share(const DeviceOnDemand& device, const Subject& subject, const Place& place);

}  // namespace airlight::stability
