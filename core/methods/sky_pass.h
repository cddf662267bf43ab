#pragma once
// What every sky pass on the device shares: its output, its view rays, its size.

#include <cstdint>
#include <string_view>
#include <vector>

#include "core/methods/method.h"
#include "core/plan/plan.h"

namespace airlight {

// The radiance buffer is carried under this key, so that a second plan can expose what the first one rendered.
inline constexpr std::string_view kRadianceKey = "frame radiance";

struct SkyTarget {
  BufferId radiance;    // shaders/shared/sky_output.glsl: radiance_out
  BufferId directions;  // the listed directions, or one unused
  Extent grid;
  std::uint32_t projection = 0;  // kProjection
};

// Adds the buffers that a sky pass writes and reads for this view.
SkyTarget add_sky_target(Plan& plan, const Scene& scene, const View& view);

}  // namespace airlight
