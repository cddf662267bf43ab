#include "core/choice/judge.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/clock.h"
#include "core/base/error.h"
#include "core/base/text.h"
#include "core/gpu/kept_values.h"
#include "core/methods/method.h"
#include "core/methods/path_trace/checkpoint.h"
#include "core/methods/ready.h"

namespace airlight::choice {
namespace {

constexpr double kDark = 1e-12;  // of the sun's irradiance
constexpr int kSeed = 3;         // the first run's: neither the method's own nor that of the chart's truth
constexpr double kBatch = 16.0;  // samples
constexpr double kFewestSamples = 2.0 * kBatch;
constexpr double kMostSamples = 1 << 20;

// Of this process, all threads.
double cpu_seconds() {
  return 1e-3 * process_cpu_ms();
}

// What the deviation found from so many normal values is of their distribution's, in the mean; 1 where they are many.
double share_of_deviation(double count) {
  const double freedom = std::max(count - 1.0, 0.0);
  return freedom > 0.0
             ? std::sqrt(2.0 / freedom) * std::exp(std::lgamma(0.5 * freedom + 0.5) - std::lgamma(0.5 * freedom))
             : 1.0;
}

bool is_below(double share, const Scene& scene, std::span<const float> radiance) {
  const double limit = share * *std::ranges::max_element(scene.sun.irradiance);
  return std::ranges::all_of(radiance, [&](float x) { return std::abs(double{x}) <= limit; });
}

// Mean magnitude of a normal value of this mean and deviation (a folded normal distribution's).
double folded_mean(double mean, double deviation) {
  const double ratio = mean / deviation;
  return deviation * measure::kMeanOfNormal * std::exp(-0.5 * ratio * ratio) +
         mean * std::erf(ratio / std::numbers::sqrt2);
}

// The error alike everywhere that adds `excess` to the mean distance that noise alone makes.
double error_behind(double excess, double noise) {
  if (excess <= 0.0 || noise <= 0.0) {
    return std::max(excess, 0.0);
  }
  double low = excess;
  double high = noise + excess;
  for (int i = 0; i < 50; ++i) {
    const double middle = 0.5 * (low + high);
    const bool more = folded_mean(middle, noise / measure::kMeanOfNormal) > noise + excess;
    (more ? high : low) = middle;
  }
  return high;
}

// As kept_floats() keeps it: samples, batches, radiance, standard error.
std::vector<float> floats_of(const HostPicture& picture) {
  const auto samples = static_cast<float>(picture.samples);
  std::vector<float> values{samples, samples / static_cast<float>(kBatch)};
  for (const std::vector<float>& rgb : {rgb_of(picture.radiance.rgba), rgb_of(picture.standard_error.rgba)}) {
    values.insert(values.end(), rgb.begin(), rgb.end());
  }
  return values;
}

Traced traced_of(const std::vector<float>& values) {
  const auto radiance = values.begin() + 2;
  const auto error = radiance + (values.end() - radiance) / 2;
  return {{radiance, error}, {error, values.end()}, values[0], values[1]};
}

}  // namespace

Traced trace_probes(const Stage& stage, const Probes& probes, const TraceOrder& order) {
  const SkyMethod& method = *find_method("path-trace");
  const int samples = static_cast<int>(std::min(order.samples, kMostSamples));
  Scene traced = with_quality(stage.scene(), method, {"judge", {{"seed", order.seed}, {"samples", samples}}});
  traced.render.parameters.insert_or_assign("target_error", order.target_error);
  if (traced.spectra) {
    traced.spectra->wavelengths = kMostWavelengths;
  }
  const Stage judged = ready(traced, stage);
  const View view{.directions = probes.directions};
  HostOptions options;
  const double end = cpu_seconds() + order.cpu_seconds;
  options.report = [end](double /*done*/) { return cpu_seconds() < end; };
  // How far the time went is not in the key: where there are more samples to be had, the next seed's follow.
  const std::string key = "judge " + shortest(order.target_error) + "\n" + checkpoint_identity(judged, view);
  try {
    return traced_of(kept_floats(key, [&] { return floats_of(method.render_on_host(judged, view, options)); }));
  } catch (const RunError&) {
    return {};  // stopped before the first batches
  }
}

Traced together(const Traced& a, const Traced& b) {
  if (a.radiance.empty() || b.radiance.empty()) {
    return a.radiance.empty() ? b : a;
  }
  Traced sum = a;
  sum.samples += b.samples;
  sum.batches += b.batches - 1.0;  // each run tells its own mean
  const double share = b.samples / sum.samples;
  for (std::size_t i = 0; i < sum.radiance.size(); ++i) {
    sum.radiance[i] = static_cast<float>(std::lerp(double{a.radiance[i]}, double{b.radiance[i]}, share));
    sum.standard_error[i] =
        static_cast<float>(std::hypot((1.0 - share) * a.standard_error[i], share * b.standard_error[i]));
  }
  return sum;
}

Judgement judge(std::span<const float> radiance, const Traced& truth, std::span<const double> weights) {
  constexpr double kAbove = 2.5;             // spreads
  constexpr double kSpreadOfNormal = 0.756;  // of a magnitude, over its mean
  constexpr double kBelow = 3.0;             // one look too low in a row of them ends a search
  std::vector<float> sigma = truth.standard_error;
  const auto mend = static_cast<float>(1.0 / share_of_deviation(truth.batches));
  std::ranges::transform(sigma, sigma.begin(), [mend](float s) { return mend * s; });
  const measure::NoisyError found = measure::noisy_error(radiance, truth.radiance, sigma, weights);
  // Of few probes the spread is itself a guess, and no less than that of a normal value's magnitude.
  const double spread =
      std::max(found.spread,
               kSpreadOfNormal * found.noise / std::sqrt(static_cast<double>(std::max<std::size_t>(found.used, 1))));
  return {error_behind(found.excess - kBelow * spread, found.noise),
          error_behind(std::max(found.excess, 0.0) + kAbove * spread, found.noise)};
}

double dark_radiance(const Scene& scene, const std::vector<float>& reference) {
  constexpr double kNight = 1e-15;
  return is_below(kNight, scene, reference) ? kDark * *std::ranges::max_element(scene.sun.irradiance) : 0.0;
}

Judgement Judge::told(std::span<const float> radiance) const {
  return was_asked() ? judge(radiance, traced_, probes_.weights) : Judgement{0.0, measure::kWorstError};
}

// Few paths miss what seldom comes and matters, and tell errors that more of them take back: what they say against a
// picture is only believed where it is far off or they are many.
bool Judge::is_settled(const Judgement& verdict, double share) const {
  constexpr double kEnoughBatches = 8.0;
  constexpr double kFine = 0.5;  // noise / tolerance
  constexpr double kFinest = 0.25;
  constexpr double kFarOff = 3.0;  // error / tolerance
  const double noise = measure::sample_noise(traced_.radiance, traced_.standard_error, probes_.weights) / tolerance_;
  if (traced_.batches < kEnoughBatches) {
    return false;
  }
  return noise <= kFinest || verdict.at_most <= share * tolerance_ ||
         verdict.at_least > (noise <= kFine ? 1.0 : kFarOff) * tolerance_;
}

Judgement Judge::tell(std::span<const float> radiance, double share) {
  constexpr double kFirst = 0.04;  // standard error / radiance
  if (!was_asked()) {
    trace_more(std::max(kFirst, 2.0 * tolerance_));
  }
  Judgement verdict = told(radiance);
  while (was_asked() && !is_settled(verdict, share) && trace_more(0.0)) {
    verdict = told(radiance);
  }
  return verdict;
}

// Half as many samples again as there are, or until the noise is as small as that. False: there is no time for more.
bool Judge::trace_more(double target_error) {
  if (runs_ == 0) {
    end_ = cpu_seconds() + patience_();
  }
  TraceOrder order{.seed = kSeed + runs_,
                   .target_error = target_error,
                   .samples = kMostSamples,
                   .cpu_seconds = std::max(end_ - cpu_seconds(), 0.0)};
  if (was_asked()) {
    const double affordable = order.cpu_seconds * traced_.samples / std::max(cpu_seconds_, 1e-6);
    order.samples = std::max(kFewestSamples, std::min(0.5 * traced_.samples, affordable));
    if (affordable < kFewestSamples || traced_.samples >= kMostSamples) {
      ran_out_ = true;
      return false;
    }
  }
  const double start = cpu_seconds();
  const Traced more = trace_(stage_, probes_, order);
  cpu_seconds_ += cpu_seconds() - start;
  ++runs_;
  traced_ = together(traced_, more);
  ran_out_ = more.radiance.empty();
  return !ran_out_;
}

bool Judge::is_over() const {
  return ran_out_ || (runs_ > 0 && cpu_seconds() >= end_);
}

double Judge::darkness(const std::vector<float>& radiance) {
  constexpr double kAnyNoise = 1e9;
  const double dark = dark_radiance(stage_.scene(), radiance);
  const bool seen = dark > 0.0 && (was_asked() || trace_more(kAnyNoise));
  return seen && is_below(kDark, stage_.scene(), traced_.radiance) ? dark : 0.0;
}

}  // namespace airlight::choice
