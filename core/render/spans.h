#pragma once
// The air between the camera and things.

#include <array>
#include <span>
#include <vector>

#include "core/render/render.h"

namespace airlight {

// Along one ray up to its distance.
struct AirTo {
  std::array<float, 3> radiance{};       // that the air sends to the camera, in the scene's unit
  std::array<float, 3> transmittance{};  // of light from the ray's end, 0 to 1
};

// In the order of the spans, of the scene's own method, which must have add_span_passes and, where the way is the
// volume, has_volume. The device's buffers take 16 MiB at most, whatever the number of spans. `passes`: times are added
// to them. Throws RunError where the device fails or a result is not finite or negative.
std::vector<AirTo> air_to(Executor& executor, const Scene& scene, std::span<const Span> spans, const SpanWay& way = {},
                          std::vector<PassTiming>* passes = nullptr);

// The same up to the distance of every pixel of the picture, rows from the top; infinite: nothing is there, and no air.
std::vector<AirTo> air_to_all(Executor& executor, const Scene& scene, std::span<const float> distances,
                              const SpanWay& way = {}, std::vector<PassTiming>* passes = nullptr);

}  // namespace airlight
