#include "core/render/spans.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstring>
#include <string>

#include "core/error.h"
#include "core/methods/scene_air.h"
#include "core/methods/spectral_sky.h"
#include "core/render/timings.h"
#include "core/scene/photometry.h"

namespace airlight {
namespace {

constexpr std::size_t kMostSpans = std::size_t{1} << 18;
constexpr std::size_t kFloats = 8;  // a span: radiance and transmittance, four each

// A colour may have negative channels, but no negative luminance.
void require_sound(const Span& span, const AirTo& air, bool in_colours) {
  for (const auto* triple : {&air.radiance, &air.transmittance}) {
    const double luminance = bt709_luminance({double{(*triple)[0]}, double{(*triple)[1]}, double{(*triple)[2]}});
    for (const float value : *triple) {
      if (!std::isfinite(value) || (in_colours ? luminance < 0.0 : value < 0.0F)) {
        throw RunError("the air up to " + std::to_string(span.distance) + " km at column " + std::to_string(span.x) +
                       ", row " + std::to_string(span.y) + " comes out as " + std::to_string(value) +
                       "; this is a mistake in airlight, please report it with the preset");
      }
    }
  }
}

// Adds the light and the transmittance of three channels, as colours.
void add_part(std::span<AirTo> sums, std::span<const std::byte> bytes, const std::array<Rgb, 3>& radiance,
              const std::array<Rgb, 3>& transmittance) {
  std::vector<float> values(sums.size() * kFloats);
  std::memcpy(values.data(), bytes.data(), values.size() * sizeof(float));
  const auto add = [](std::array<float, 3>& sum, const float* channels, const std::array<Rgb, 3>& colours) {
    for (std::size_t c = 0; c < 3; ++c) {
      sum[c] += static_cast<float>(colours[0][c] * double{channels[0]} + colours[1][c] * double{channels[1]} +
                                   colours[2][c] * double{channels[2]});
    }
  };
  for (std::size_t i = 0; i < sums.size(); ++i) {
    add(sums[i].radiance, &values[i * kFloats], radiance);
    add(sums[i].transmittance, &values[i * kFloats + 4], transmittance);
  }
}

// What a part of the air before things is rendered with.
struct SpanWork {
  Executor& executor;
  const SkyMethod& method;
  const SpanWay& way;
  std::vector<PassTiming>* passes;
};

void add_channels(const SpanWork& work, const Scene& scene, std::span<const Span> spans, std::span<AirTo> sums,
                  const std::array<Rgb, 3>& radiance, const std::array<Rgb, 3>& transmittance) {
  const Air air = air_of(scene);
  Plan plan;
  plan.scene_data = device_scene_bytes(air, scene);
  const SpanPasses added = work.method.add_span_passes(plan, scene, air, spans, work.way);
  const RunResult result = work.executor.run(plan);
  if (work.passes != nullptr) {
    add_timings(*work.passes, result.passes);
  }
  add_part(sums, result.contents(added.air), radiance, transmittance);
}

}  // namespace

std::vector<AirTo> air_to(Executor& executor, const Scene& scene, std::span<const Span> spans, const SpanWay& way,
                          std::vector<PassTiming>* passes) {
  constexpr std::array<Rgb, 3> kAsTheyAre{{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}};
  const SkyMethod* method = find_method(scene.render.method);
  assert(method != nullptr && method->add_span_passes != nullptr);
  assert(!way.volume || (method->has_volume != nullptr && method->has_volume(scene)));
  std::vector<AirTo> all(spans.size());
  for (std::size_t first = 0; first < spans.size(); first += kMostSpans) {
    const std::span<const Span> some = spans.subspan(first, std::min(kMostSpans, spans.size() - first));
    const std::span<AirTo> sums(all.data() + first, some.size());
    if (scene.spectra) {
      const SpectralScene spectral = spectral_scene(scene);
      for (std::size_t g = 0; g < spectral.groups.size(); ++g) {
        const WavelengthGroup& group = spectral.groups[g];
        SpanWay of_group = way;  // each group keeps tables of its own
        of_group.kept_as += way.kept_as.empty() ? "" : " of group " + std::to_string(g);
        const SpanWork work{executor, *method, of_group, passes};
        add_channels(work, group.scene, some, sums, group.colours, over_the_sun(group.colours, spectral.sun));
      }
    } else {
      add_channels({executor, *method, way, passes}, scene, some, sums, kAsTheyAre, kAsTheyAre);
    }
    for (std::size_t i = 0; i < some.size(); ++i) {
      require_sound(some[i], sums[i], scene.spectra.has_value());
    }
  }
  return all;
}

}  // namespace airlight
