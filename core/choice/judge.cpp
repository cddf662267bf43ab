#include "core/choice/judge.h"

#include <algorithm>
#include <cmath>
#include <ctime>

#include "core/methods/method.h"
#include "core/methods/scene_air.h"

namespace airlight::choice {
namespace {

constexpr double kDark = 1e-12;  // of the sun's irradiance
constexpr int kSeed = 3;         // neither the method's own nor that of the chart's truth

bool is_below(double share, const Scene& scene, std::span<const float> radiance) {
  const double limit = share * *std::ranges::max_element(scene.sun.irradiance);
  return std::ranges::all_of(radiance, [&](float x) { return std::abs(double{x}) <= limit; });
}

std::vector<float> rgb_of(const RadianceImage& image) {
  std::vector<float> values;
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
    values.insert(values.end(), {image.rgba[i], image.rgba[i + 1], image.rgba[i + 2]});
  }
  return values;
}

}  // namespace

bool can_be_traced(const Scene& scene) {
  return find_method("path-trace")->info.knows_spheres || scene.spheres.empty();
}

Traced trace_probes(const Scene& scene, const Probes& probes, double target_error) {
  const SkyMethod& method = *find_method("path-trace");
  Scene traced = with_quality(scene, method, {"judge", {{"seed", kSeed}, {"samples", kMostSamples}}});
  traced.render.parameters.insert_or_assign("target_error", target_error);
  if (traced.spectra) {
    traced.spectra->wavelengths = kMostWavelengths;
  }
  HostOptions options;
  const std::clock_t start = std::clock();
  options.report = [start](double /*done*/) {
    return static_cast<double>(std::clock() - start) < kMostCpuSeconds * CLOCKS_PER_SEC;
  };
  const HostPicture picture =
      method.render_on_host(traced, air_of(traced), View{.directions = probes.directions}, options);
  return {rgb_of(picture.radiance), rgb_of(picture.standard_error)};
}

Judgement judge(std::span<const float> radiance, const Traced& truth, std::span<const double> weights) {
  constexpr double kMeanOfNormal = 0.798;  // mean magnitude over standard deviation
  constexpr double kSpreads = 2.0;
  const measure::SampleError distance = measure::sample_error(radiance, truth.radiance, weights);
  const double noise = kMeanOfNormal * measure::sample_noise(truth.radiance, truth.standard_error, weights);
  const auto without_noise = [&](double d) { return std::sqrt(std::max(d * d - noise * noise, 0.0)); };
  return {without_noise(std::max(distance.mean - kSpreads * distance.spread, 0.0)),
          without_noise(distance.mean + kSpreads * distance.spread)};
}

double dark_radiance(const Scene& scene, const std::vector<float>& reference) {
  constexpr double kNight = 1e-15;
  return is_below(kNight, scene, reference) ? kDark * *std::ranges::max_element(scene.sun.irradiance) : 0.0;
}

Judgement Judge::tell(std::span<const float> radiance, double share) {
  constexpr double kFirst = 0.04;  // standard error / radiance
  constexpr double kOutOfTime = 1.5;
  while (true) {
    if (was_asked()) {
      const Judgement verdict = told(radiance);
      const bool finest = noise_ <= tolerance_ || noise_of(traced_) > kOutOfTime * noise_;
      if (verdict.at_most <= share * tolerance_ || verdict.at_least > tolerance_ || finest) {
        return verdict;
      }
    }
    noise_ = std::max(was_asked() ? 0.5 * noise_ : kFirst, was_asked() ? tolerance_ : 2.0 * tolerance_);
    traced_ = trace_(scene_, probes_, noise_);
  }
}

double Judge::noise_of(const Traced& traced) const {
  return measure::sample_noise(traced.radiance, traced.standard_error, probes_.weights);
}

double Judge::darkness(const std::vector<float>& radiance) const {
  constexpr double kAnyNoise = 1e9;
  const double dark = dark_radiance(scene_, radiance);
  return dark > 0.0 && is_below(kDark, scene_, trace_(scene_, probes_, kAnyNoise).radiance) ? dark : 0.0;
}

}  // namespace airlight::choice
