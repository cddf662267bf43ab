#include "core/choice/aerial.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/choice/choose.h"

namespace airlight::choice {
namespace {

constexpr std::size_t kMostProbes = 256;
constexpr double kGolden = 0.6180339887498949;  // its multiples fill the unit interval evenly

// One anywhere in each of as many equal stretches of the list: neither rows nor columns of a picture repeat.
std::vector<Span> probes_of(std::span<const Span> spans) {
  const std::size_t count = std::min(kMostProbes, spans.size());
  std::vector<Span> probes;
  for (std::size_t i = 0; i < count; ++i) {
    const double turn = kGolden * static_cast<double>(i + 1);
    const double place = (static_cast<double>(i) + turn - std::floor(turn)) / static_cast<double>(count);
    const auto at = static_cast<std::size_t>(place * static_cast<double>(spans.size()));
    probes.push_back(spans[std::min(at, spans.size() - 1)]);
  }
  return probes;
}

std::vector<float> radiances(const std::vector<AirTo>& airs) {
  std::vector<float> rgb;
  for (const AirTo& air : airs) {
    rgb.insert(rgb.end(), air.radiance.begin(), air.radiance.end());
  }
  return rgb;
}

// Opaque air lets nothing through, so errors are absolute.
measure::SampleError transmittance_error(const std::vector<AirTo>& a, const std::vector<AirTo>& exact) {
  std::vector<float> found;
  for (std::size_t i = 0; i < exact.size(); ++i) {
    for (std::size_t c = 0; c < 3; ++c) {
      found.push_back(1.0F + a[i].transmittance[c] - exact[i].transmittance[c]);
    }
  }
  const std::vector<float> ones(found.size(), 1.0F);
  return measure::sample_error(found, ones);
}

}  // namespace

double volume_error(Executor& executor, const Stage& stage, std::span<const Span> spans, const SpanWay& volume) {
  const std::vector<Span> probes = probes_of(spans);
  const std::vector<AirTo> exact = air_to(executor, stage, probes);
  const std::vector<AirTo> tabulated = air_to(executor, stage, probes, volume);
  const measure::SampleError light = measure::sample_error(radiances(tabulated), radiances(exact));
  return std::max(error_bound(light, 0.0), error_bound(transmittance_error(tabulated, exact), 0.0));
}

}  // namespace airlight::choice
