#pragma once
// Light of things and of the air before and behind them, put together.

#include <array>
#include <span>
#include <vector>

#include "core/render/spans.h"

namespace airlight::composite {

using Rgb = std::array<float, 3>;

// What a picture shows in one pixel, or one sample of a deep one. `colour` is premultiplied: light per pixel, of which
// the share `alpha` is covered.
struct Thing {
  Rgb colour{};
  float alpha = 1.0F;
};

// The thing's light through the air, the air before it over the share that it covers, the whole sky over the rest. A
// half-transparent thing shows the air behind it, which belongs to the sky's share.
Rgb behind_air(const Thing& thing, const AirTo& air, const Rgb& sky);

// Samples of a deep pixel, the nearest first, each with the air up to it: what stands before a sample dims its light
// and the air beyond, sample by sample. No sample: the sky.
Rgb behind_air(std::span<const Thing> things, std::span<const AirTo> airs, const Rgb& sky);

// A sample that fills the depths from `front` to `back` as `parts` samples of equal depth, which together let through
// and send what it does (OpenEXR's rule for splitting: alpha 1 - (1 - a)^(1/n), colour in proportion).
std::vector<Thing> split(const Thing& thing, int parts);

}  // namespace airlight::composite
