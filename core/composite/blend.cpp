#include "core/composite/blend.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace airlight::composite {

Rgb behind_air(const Thing& thing, const AirTo& air, const Rgb& sky) {
  Rgb out{};
  for (std::size_t c = 0; c < 3; ++c) {
    out[c] = thing.colour[c] * air.transmittance[c] + thing.alpha * air.radiance[c] + (1.0F - thing.alpha) * sky[c];
  }
  return out;
}

Rgb behind_air(std::span<const Thing> things, std::span<const AirTo> airs, const Rgb& sky) {
  assert(things.size() == airs.size());
  Rgb out{};
  Rgb before{};        // radiance of the air up to the last sample
  float clear = 1.0F;  // transmittance of the samples so far
  for (std::size_t i = 0; i < things.size(); ++i) {
    for (std::size_t c = 0; c < 3; ++c) {
      out[c] += clear * (airs[i].radiance[c] - before[c] + things[i].colour[c] * airs[i].transmittance[c]);
    }
    before = airs[i].radiance;
    clear *= 1.0F - things[i].alpha;
  }
  for (std::size_t c = 0; c < 3; ++c) {
    out[c] += clear * (sky[c] - before[c]);
  }
  return out;
}

std::vector<Thing> split(const Thing& thing, int parts) {
  const double alpha = std::clamp(static_cast<double>(thing.alpha), 0.0, 1.0);
  Thing part = thing;
  double share = 1.0 / parts;
  if (alpha >= 1.0) {
    // An opaque thing hides everything behind its first part.
    return {thing};
  }
  if (alpha > 0.0) {
    const double one = -std::expm1(std::log1p(-alpha) / parts);
    part.alpha = static_cast<float>(one);
    share = one / alpha;
  }
  for (float& value : part.colour) {
    value = static_cast<float>(static_cast<double>(value) * share);
  }
  return std::vector<Thing>(static_cast<std::size_t>(parts), part);
}

}  // namespace airlight::composite
