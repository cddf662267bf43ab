#pragma once
// The noise that carves the edges of fields of clouds finer than their grid's cells (shaders/physics/cloud_edge.glsl).

#include <vector>

namespace airlight {

// A cube of noise that repeats itself toward all sides: 0 in the middles of lobes, up to 1 in the creases.
struct CarvingNoise {
  static constexpr int kSide = 64;  // texels
  std::vector<float> values;        // in the texels' middles, x fastest, then y, then z

  // Linear between the middles; places in cubes.
  double at(double x, double y, double z) const;
};

// The same on every machine. Kept (core/gpu/kept_values.h).
CarvingNoise carving_noise();

}  // namespace airlight
