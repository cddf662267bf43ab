#pragma once
// The truth that the chart measures against: path-trace at listed pixels, at 48 wavelengths for spectra, kept in files
// from run to run.

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "core/chart/pixels.h"
#include "core/stage/stage.h"

namespace airlight::chart {

struct TruthRules {
  double target_error = 0.002;  // mean standard error / radiance at which the truth is good enough
  double time_limit_s = 0.0;    // for further samples; 0: none
};

// The truth of each pixel.
struct Truth {
  std::vector<float> radiance;        // RGB of each pixel
  std::vector<float> standard_error;  // the same
  double samples = 0.0;               // a pixel
  double target_error = 0.0;          // the rules' target when it was made
};

// A short name for the truth's file, made of all that the truth depends on: scene, camera, pixels, sampler and seed.
std::string truth_name(const Stage& stage, const PixelSet& pixels);

// Returns FOLDER/truth_name.txt where it is good enough: at the target, or as good as an earlier run with this target
// or a finer one was given time for. Otherwise continues from FOLDER/truth_name, which holds the samples, and writes
// both. The seed differs from that of the charted method. Throws RunError when a file cannot be written, InputError
// when one is damaged.
Truth find_truth(const Stage& stage, const PixelSet& pixels, const std::filesystem::path& folder,
                 const TruthRules& rules, const std::function<bool(double)>& report);

}  // namespace airlight::chart
