#pragma once
// The air between the camera and things.

#include <array>
#include <span>
#include <vector>

#include "core/render/render.h"

namespace airlight {

// The air along one ray up to its distance.
struct AirTo {
  std::array<float, 3> radiance{};       // of the air, as the camera sees it, in the scene's unit
  std::array<float, 3> transmittance{};  // of light from the ray's end, 0 to 1
};

// The air of the spans, in their order, by the stage's method. The method must have add_span_passes, and has_volume
// where the way is the volume. The device's buffers take 16 MiB at most, whatever the number of spans. `passes`: times
// are added to them. Throws RunError where the device fails or a result is not finite or negative.
std::vector<AirTo> air_to(Executor& executor, const Stage& stage, std::span<const Span> spans, const SpanWay& way = {},
                          std::vector<PassTiming>* passes = nullptr);

// The air up to every pixel's distance, rows from the top. An infinite distance has nothing there, and no air.
std::vector<AirTo> air_to_all(Executor& executor, const Stage& stage, std::span<const float> distances,
                              const SpanWay& way = {}, std::vector<PassTiming>* passes = nullptr);

}  // namespace airlight
