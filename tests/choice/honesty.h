#pragma once
// Whether a tolerance is kept: the chosen rendering of a scene against a near-truth one, pixel by pixel.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/choice/choose.h"
#include "core/gpu/executor.h"
#include "core/scene/scene.h"

namespace airlight::test {

// An unforeseen valid scene of up to 200 pixels a side. Eight in a row share the kinds of their media, since a new list
// of kinds costs a software device's compiler a second.
Scene honesty_scene(std::uint64_t seed);

struct Honesty {
  double tolerance = 0.0;
  bool refused = false;  // nothing was sure to reach it
  std::string method;
  std::string quality;
  double estimated = 0.0;  // where refused: of the best that there was
  double known = 0.0;      // of it: what the reference is not sure of
  double measured = 0.0;   // mean relative error over pixels of the picture; where refused: of `orders` by its defaults
  double noise = 0.0;      // the judge's own
  bool sees_light = true;  // where the judge looks; else no refusal is in vain
  bool can_be_judged() const { return noise <= tolerance; }
  bool missed() const { return !refused && can_be_judged() && measured > tolerance; }
  bool refused_in_vain() const { return refused && sees_light && can_be_judged() && measured <= tolerance; }
};

// path-trace in directions of a scene's picture.
struct Traced {
  choice::Probes probes;
  std::vector<float> radiance;
  double noise = 0.0;  // mean of standard error / radiance
};

// Traces the scene; the result is kept in `folder` from run to run.
Traced trace(const Scene& scene, const std::filesystem::path& folder);

// Mean relative error in those directions, without the noise's share.
double error_against(const Traced& truth, const std::vector<float>& radiance, double dark);

// Judges each tolerance, with probes that are remembered from one to the next. `of_reference`: the mean relative error
// of the plain reference against the fine one, at the probes. The judge is path-trace, in `traced`, or else the fine
// reference over an even lattice of pixels.
std::vector<Honesty> judge_honesty(Executor& executor, const Scene& scene, const std::vector<double>& tolerances,
                                   double* of_reference = nullptr, const Traced* traced = nullptr);

// Radiance of the scene's picture in the directions.
std::vector<float> picture_values(Executor& executor, const Scene& scene, const choice::Probes& probes);

// RGB of an even lattice of the pixels of the scene's picture, by its method, without the sun's disc.
std::vector<float> lattice_values(Executor& executor, const Scene& scene, int columns, int rows);

}  // namespace airlight::test
