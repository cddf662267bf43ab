#include "core/render/spans.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstring>
#include <string>

#include "core/error.h"
#include "core/methods/scene_air.h"

namespace airlight {
namespace {

constexpr std::size_t kMostSpans = std::size_t{1} << 18;
constexpr std::size_t kFloats = 8;  // a span: radiance and transmittance, four each

void require_sound(const Span& span, const AirTo& air) {
  for (const auto* triple : {&air.radiance, &air.transmittance}) {
    for (const float value : *triple) {
      if (!std::isfinite(value) || value < 0.0F) {
        throw RunError("the air up to " + std::to_string(span.distance) + " km at column " + std::to_string(span.x) +
                       ", row " + std::to_string(span.y) + " comes out as " + std::to_string(value) +
                       "; this is a mistake in airlight, please report it with the preset");
      }
    }
  }
}

}  // namespace

std::vector<AirTo> air_to(Executor& executor, const Scene& scene, std::span<const Span> spans) {
  const SkyMethod* method = find_method(scene.render.method);
  assert(method != nullptr && method->add_span_passes != nullptr);
  const Air air = air_of(scene);
  std::vector<AirTo> all;
  all.reserve(spans.size());
  while (all.size() < spans.size()) {
    const std::span<const Span> some = spans.subspan(all.size(), std::min(kMostSpans, spans.size() - all.size()));
    Plan plan;
    plan.scene_data = device_scene_bytes(air, scene);
    const SpanPasses passes = method->add_span_passes(plan, scene, air, some);
    const RunResult result = executor.run(plan);
    const std::span<const std::byte> bytes = result.contents(passes.air);
    std::vector<float> values(some.size() * kFloats);
    std::memcpy(values.data(), bytes.data(), values.size() * sizeof(float));
    for (std::size_t i = 0; i < some.size(); ++i) {
      const float* v = &values[i * kFloats];
      all.push_back({{v[0], v[1], v[2]}, {v[4], v[5], v[6]}});
      require_sound(some[i], all.back());
    }
  }
  return all;
}

}  // namespace airlight
