#pragma once
// Blends things with the air before them and the sky behind them.

#include <array>
#include <span>
#include <vector>

#include "core/render/spans.h"

namespace airlight::composite {

using Rgb = std::array<float, 3>;

// One pixel of a picture, or one sample of a deep pixel. `colour` is premultiplied: light per pixel, of which the share
// `alpha` is covered.
struct Thing {
  Rgb colour{};
  float alpha = 1.0F;
};

// The sum of the thing's light through the air, the air before it over the share that it covers, and the whole sky over
// the rest. The air behind a half-transparent thing is part of the sky's share.
Rgb behind_air(const Thing& thing, const AirTo& air, const Rgb& sky);

// Samples of a deep pixel, the nearest first, each with the air up to it. Each sample dims the light and the air beyond
// it. Without samples the pixel shows the sky.
Rgb behind_air(std::span<const Thing> things, std::span<const AirTo> airs, const Rgb& sky);

// Splits a sample that fills the depths from `front` to `back` into `parts` samples of equal depth that together let
// through and send what it does (OpenEXR's rule: alpha 1 - (1 - a)^(1/n), colour in proportion).
std::vector<Thing> split(const Thing& thing, int parts);

}  // namespace airlight::composite
