#include "core/chart/truth.h"

#include <cstdio>
#include <fstream>
#include <iomanip>
#include <optional>
#include <sstream>

#include "core/base/error.h"
#include "core/base/hash.h"
#include "core/measure/sample_error.h"
#include "core/methods/method.h"
#include "core/methods/path_trace/checkpoint.h"
#include "core/methods/ready.h"
#include "core/output/atomic_file.h"

namespace airlight::chart {
namespace {

constexpr int kSeed = 2;

Stage truth_stage(const Stage& stage, const TruthRules& rules) {
  Scene truth = with_quality(stage.scene(), *find_method("path-trace"), {"truth", {{"seed", kSeed}}});
  truth.render.parameters.insert_or_assign("target_error", rules.target_error);
  truth.render.parameters.insert_or_assign("time_limit_s", rules.time_limit_s);
  if (truth.spectra) {
    truth.spectra->wavelengths = kMostWavelengths;
  }
  return ready(truth, stage);
}

// A line of samples and target, then six numbers a pixel.
std::string text_of(const Truth& truth) {
  std::ostringstream out;
  out << std::setprecision(9) << truth.samples << ' ' << truth.target_error << '\n';
  for (std::size_t i = 0; i < truth.radiance.size(); i += 3) {
    for (const std::vector<float>* values : {&truth.radiance, &truth.standard_error}) {
      out << (*values)[i] << ' ' << (*values)[i + 1] << ' ' << (*values)[i + 2] << ' ';
    }
    out << '\n';
  }
  return out.str();
}

std::optional<Truth> read_truth(const std::filesystem::path& file, std::size_t pixels) {
  std::ifstream in(file);
  if (!in) {
    return std::nullopt;
  }
  Truth truth;
  in >> truth.samples >> truth.target_error;
  for (std::size_t i = 0; i < pixels; ++i) {
    for (std::vector<float>* values : {&truth.radiance, &truth.standard_error}) {
      for (int c = 0; c < 3; ++c) {
        float value = 0.0F;
        in >> value;
        values->push_back(value);
      }
    }
  }
  std::string more;
  if (!in || in >> more) {
    throw InputError(file.string() + ": is no truth of " + std::to_string(pixels) +
                     " pixels, or damaged; remove it, and it is made again");
  }
  return truth;
}

}  // namespace

std::string truth_name(const Stage& stage, const PixelSet& pixels) {
  return hash_text(checkpoint_identity(truth_stage(stage, {}), View{.directions = pixels.directions}));
}

Truth find_truth(const Stage& stage, const PixelSet& pixels, const std::filesystem::path& folder,
                 const TruthRules& rules, const std::function<bool(double)>& report) {
  const std::filesystem::path samples = folder / truth_name(stage, pixels);
  const std::filesystem::path finished = samples.string() + ".txt";
  if (std::optional<Truth> known = read_truth(finished, pixels.places.size())) {
    const double noise = measure::sample_noise(known->radiance, known->standard_error);
    if (noise <= rules.target_error || known->target_error <= rules.target_error) {
      return *std::move(known);
    }
  }
  HostOptions options;
  options.report = report;
  options.checkpoint = samples.string();
  options.checkpoint_interval_s = 10.0;
  const Stage traced = truth_stage(stage, rules);
  const HostPicture picture = traced.method().render_on_host(traced, View{.directions = pixels.directions}, options);
  Truth truth;
  truth.radiance = rgb_of(picture.radiance.rgba);
  truth.standard_error = rgb_of(picture.standard_error.rgba);
  truth.samples = static_cast<double>(picture.samples);
  truth.target_error = rules.target_error;
  const std::string text = text_of(truth);
  write_file(finished, text);
  return truth;
}

}  // namespace airlight::chart
