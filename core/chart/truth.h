#pragma once
// The truth that the chart measures against: path-trace at listed pixels, of spectra at 48 wavelengths, kept in files
// from run to run.

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "core/chart/pixels.h"
#include "core/scene/scene.h"

namespace airlight::chart {

struct TruthRules {
  double target_error = 0.002;  // mean standard error / radiance at which it is good enough
  double time_limit_s = 0.0;    // for what is still missing; 0: none
};

// What is known of each pixel.
struct Truth {
  std::vector<float> radiance;        // RGB of each pixel
  std::vector<float> standard_error;  // the same
  double samples = 0.0;               // a pixel
  double target_error = 0.0;          // of the rules that it was made by
};

// What the truth depends on, as a short name for its file: scene, camera, pixels, sampler and seed.
std::string truth_name(const Scene& scene, const PixelSet& pixels);

// FOLDER/truth_name.txt where that is good enough: at the target, or as good as an earlier run with this target or a
// finer one was given time for. Otherwise goes on from FOLDER/truth_name, which keeps the samples, and writes both. The
// seed is not that of the method as it is charted. Throws RunError when a file cannot be written, InputError when one
// is damaged.
Truth find_truth(const Scene& scene, const PixelSet& pixels, const std::filesystem::path& folder,
                 const TruthRules& rules, const std::function<bool(double)>& report);

}  // namespace airlight::chart
