#pragma once
// Exposure shared by several pictures: metered once, on a small picture of a midday or of one frame.

#include "core/render/render.h"

namespace airlight {

// The scene at midday: the sun 45 degrees high at the camera's back.
Scene by_day(const Scene& scene);

// The stage's picture, automatically exposed. A picture of more than 65 536 pixels is rendered smaller; a method that
// samples renders one of 2304 pixels with 32 samples each. Throws RunError where it is at fault.
Rendering metered_picture(const DeviceOnDemand& device, const Stage& stage);

// The exposure of that picture, without compensation, to four digits, so that devices agree on it.
double metered_exposure(const DeviceOnDemand& device, const Stage& stage);

}  // namespace airlight
