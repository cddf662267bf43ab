#pragma once
// Directions that stand for a picture's pixels: few, and denser where methods err most.

#include <cstddef>
#include <span>
#include <vector>

#include "core/methods/method.h"
#include "core/scene/scene.h"

namespace airlight::choice {

struct Probes {
  std::vector<Direction> directions;  // of pixel centres inside the picture
  std::vector<double> weights;        // how many pixels each stands for, up to a factor
};

// About `count` of the picture's pixels, or all of them where it has no more: four times as dense within a few degrees
// of the true horizon and around the sun, and where a ray runs both in the planet's shadow and in sunlight. The same
// for the same scene.
Probes choose_probes(const Scene& scene, std::size_t count);

// Every `step`th of the probes, which stand for the same picture, and of their RGB values.
Probes every(const Probes& probes, std::size_t step);
std::vector<float> every(std::span<const float> rgb, std::size_t step);

}  // namespace airlight::choice
