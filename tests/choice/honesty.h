#pragma once
// Whether a tolerance is kept: the chosen rendering of a scene against a near-truth one, pixel by pixel.

#include <cstdint>
#include <string>
#include <vector>

#include "core/choice/choose.h"
#include "core/gpu/executor.h"
#include "core/scene/scene.h"

namespace airlight::test {

// A valid scene nobody thought of, of up to 200 pixels a side; eight in a row share the kinds of their media, as a new
// list of kinds is a second of a software device's compiler.
Scene honesty_scene(std::uint64_t seed);

struct Honesty {
  double tolerance = 0.0;
  bool refused = false;  // nothing was sure to reach it
  std::string method;
  std::string quality;
  double estimated = 0.0;  // where refused: of the best that there was
  double known = 0.0;      // of it: what the reference is not sure of
  double measured = 0.0;   // mean relative error over an even lattice of the picture's pixels
  bool missed() const { return !refused && measured > tolerance; }
};

// For each tolerance, by probes that are remembered from one to the next. `of_reference`: the mean relative error of
// the plain reference against the fine one, at the probes.
std::vector<Honesty> judge_honesty(Executor& executor, const Scene& scene, const std::vector<double>& tolerances,
                                   double* of_reference = nullptr);

// RGB of an even lattice of the pixels of the scene's picture, by its method, without the sun's disc.
std::vector<float> lattice_values(Executor& executor, const Scene& scene, int columns, int rows);

}  // namespace airlight::test
