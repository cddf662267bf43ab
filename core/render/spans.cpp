#include "core/render/spans.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <utility>

#include "core/base/error.h"
#include "core/methods/method.h"
#include "core/methods/spectral_sums.h"
#include "core/render/timings.h"
#include "core/scene/photometry.h"
#include "core/stage/sums.h"

namespace airlight {
namespace {

constexpr std::size_t kMostSpans = std::size_t{1} << 19;

// Radiance and transmittance.
using Six = std::array<float, 6>;

Six floats_at(std::span<const std::byte> bytes, std::size_t i) {
  Six six;
  std::memcpy(six.data(), bytes.data() + i * sizeof six, sizeof six);
  return six;
}

// shaders/shared/span_air_packed.glsl: in each pair of words, three values of 21 bits, lowest bits first.
Six packed_at(std::span<const std::byte> bytes, std::size_t i) {
  std::array<std::uint64_t, 2> words;
  std::memcpy(words.data(), bytes.data() + i * sizeof words, sizeof words);
  Six six;
  for (std::size_t k = 0; k < six.size(); ++k) {
    const auto bits = static_cast<std::uint32_t>(words[k / 3] >> (21 * (k % 3)) & 0x1FFFFFU);
    six[k] = std::bit_cast<float>(bits << 10);
  }
  return six;
}

// Throws on unsound values. A colour may have negative channels, but no negative luminance.
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

// Adds the light and the transmittance of three channels, converted to colours.
void add_part(std::span<AirTo> sums, std::span<const std::byte> bytes, bool packed, const std::array<Rgb, 3>& radiance,
              const std::array<Rgb, 3>& transmittance) {
  const auto add = [](std::array<float, 3>& sum, const float* channels, const std::array<Rgb, 3>& colours) {
    for (std::size_t c = 0; c < 3; ++c) {
      sum[c] += static_cast<float>(
          add_colour(0.0, colours, c, double{channels[0]}, double{channels[1]}, double{channels[2]}));
    }
  };
  for (std::size_t i = 0; i < sums.size(); ++i) {
    const Six six = packed ? packed_at(bytes, i) : floats_at(bytes, i);
    add(sums[i].radiance, &six[0], radiance);
    add(sums[i].transmittance, &six[3], transmittance);
  }
}

// Adds one part's light up to the spans, and its transmittance as these shares.
void add_air(Executor& executor, const Stage& stage, const Part& part, const std::array<Rgb, 3>& shares,
             const Spans& spans, const SpanWay& way, std::vector<PassTiming>* passes, std::span<AirTo> sums) {
  const ImageSize& image = stage.scene().image;
  Plan plan;
  begin_part(plan, part, {0, 0, image.width, image.height});  // as for the sky, so that its tables are already there
  const SpanPasses added = stage.method().add_span_passes(plan, part, spans, way);
  const RunResult result = executor.run(plan);
  if (passes != nullptr) {
    add_timings(*passes, result.passes);
  }
  add_part(sums, result.contents(added.air), added.packed, part.colours, shares);
}

// Parts of at most kMostSpans, or of one row.
std::vector<Spans> parts_of(const Spans& spans, std::size_t width) {
  std::vector<Spans> parts;
  for (std::size_t first = 0; first < spans.list.size(); first += kMostSpans) {
    parts.push_back({.list = spans.list.subspan(first, std::min(kMostSpans, spans.list.size() - first))});
  }
  constexpr std::size_t kMostRows = 65535;  // a device takes as many workgroups at least
  const std::size_t most = width * std::clamp(kMostSpans / width, std::size_t{1}, kMostRows);
  for (std::size_t first = 0; first < spans.rows.size(); first += most) {
    parts.push_back({.rows = spans.rows.subspan(first, std::min(most, spans.rows.size() - first)),
                     .first_row = static_cast<std::uint32_t>(first / width)});
  }
  return parts;
}

// Span i of a part.
Span one_of(const Spans& spans, std::size_t i, std::size_t width) {
  return spans.rows.empty() ? spans.list[i]
                            : Span{static_cast<std::uint16_t>(i % width),
                                   static_cast<std::uint16_t>(spans.first_row + i / width), spans.rows[i]};
}

std::vector<AirTo> air_of_spans(Executor& executor, const Stage& stage, const Spans& spans, const SpanWay& way,
                                std::vector<PassTiming>* passes) {
  assert(stage.method().add_span_passes != nullptr);
  assert(!way.volume || (stage.method().has_volume != nullptr && stage.method().has_volume(stage.scene())));
  const auto width = static_cast<std::size_t>(stage.scene().image.width);
  std::vector<AirTo> all(spans.size());
  std::span<AirTo> rest = all;
  for (const Spans& some : parts_of(spans, width)) {
    const std::span<AirTo> sums = rest.first(some.size());
    rest = rest.subspan(some.size());
    for (const Part& part : stage.parts()) {
      add_air(executor, stage, part, part.shares, some, way, passes, sums);
    }
    for (const Stage& other : stage.others()) {
      const SpanWay its_way{way.volume, way.kept_as.empty() ? "" : way.kept_as + other.light()};
      for (const Part& part : other.parts()) {
        add_air(executor, other, part, {}, some, its_way, passes, sums);
      }
    }
    for (std::size_t i = 0; i < sums.size(); ++i) {
      require_sound(one_of(some, i, width), sums[i], stage.in_colours());
    }
  }
  return all;
}

}  // namespace

std::vector<AirTo> air_to(Executor& executor, const Stage& stage, std::span<const Span> spans, const SpanWay& way,
                          std::vector<PassTiming>* passes) {
  return air_of_spans(executor, stage, {.list = spans}, way, passes);
}

std::vector<AirTo> air_to_all(Executor& executor, const Stage& stage, std::span<const float> distances,
                              const SpanWay& way, std::vector<PassTiming>* passes) {
  assert(distances.size() ==
         static_cast<std::size_t>(stage.scene().image.width) * static_cast<std::size_t>(stage.scene().image.height));
  return air_of_spans(executor, stage, {.rows = distances}, way, passes);
}

}  // namespace airlight
