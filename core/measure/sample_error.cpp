#include "core/measure/sample_error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/measure/metrics.h"

namespace airlight::measure {
namespace {

constexpr std::size_t kChannels = 3;

double weight_of(std::span<const double> weights, std::size_t i) {
  return weights.empty() ? 1.0 : weights[i];
}

// Least value that an error is relative to: kRelativeFloor of the channel's mean.
std::array<double, kChannels> floors_of(std::span<const float> reference, std::span<const double> weights) {
  std::array<double, kChannels> sum{};
  double total = 0.0;
  for (std::size_t i = 0; i < reference.size() / kChannels; ++i) {
    const double w = weight_of(weights, i);
    total += w;
    for (std::size_t c = 0; c < kChannels; ++c) {
      const double value = std::abs(static_cast<double>(reference[kChannels * i + c]));
      sum[c] += std::isfinite(value) ? w * value : 0.0;
    }
  }
  for (double& s : sum) {
    s = total > 0.0 ? kRelativeFloor * s / total : 0.0;
  }
  return sum;
}

double error_of(double a, double b, double floor) {
  if (a == b) {
    return 0.0;
  }
  const double error = std::abs(a - b) / std::max(std::abs(b), floor);
  return std::isfinite(error) ? std::min(error, kWorstError) : kWorstError;
}

// The weighted mean of values, and its standard error.
struct Mean {
  double value = 0.0;
  double spread = 0.0;
};

Mean mean_of(const std::vector<std::pair<double, double>>& values) {
  Mean mean;
  double total = 0.0;
  for (const auto& [value, weight] : values) {
    mean.value += weight * value;
    total += weight;
  }
  if (total <= 0.0) {
    return {};
  }
  mean.value /= total;
  double squares = 0.0;
  for (const auto& [value, weight] : values) {
    squares += (weight / total) * (weight / total) * (value - mean.value) * (value - mean.value);
  }
  const auto n = static_cast<double>(values.size());
  mean.spread = n > 1.0 ? std::sqrt(squares * n / (n - 1.0)) : 0.0;
  return mean;
}

bool black(std::span<const float> rgb, std::size_t i) {
  return rgb[kChannels * i] == 0.0F && rgb[kChannels * i + 1] == 0.0F && rgb[kChannels * i + 2] == 0.0F;
}

}  // namespace

SampleError sample_error(std::span<const float> a, std::span<const float> reference, std::span<const double> weights,
                         double dark) {
  std::array<double, kChannels> floors = floors_of(reference, weights);
  std::ranges::transform(floors, floors.begin(), [&](double floor) { return std::max(floor, dark); });
  SampleError result;
  std::vector<std::pair<double, double>> errors;  // with their weights
  std::vector<std::pair<double, double>> means;   // of each sample
  double total = 0.0;
  for (std::size_t i = 0; i < reference.size() / kChannels; ++i) {
    if (black(a, i) && black(reference, i)) {
      continue;
    }
    const double w = weight_of(weights, i);
    double of_sample = 0.0;
    for (std::size_t c = 0; c < kChannels; ++c) {
      const std::size_t k = kChannels * i + c;
      const double e = error_of(static_cast<double>(a[k]), static_cast<double>(reference[k]), floors[c]);
      errors.emplace_back(e, w);
      of_sample += e / static_cast<double>(kChannels);
    }
    means.emplace_back(of_sample, w);
    total += w;
  }
  const Mean mean = mean_of(means);
  result.mean = mean.value;
  result.spread = mean.spread;
  result.used = means.size();
  std::ranges::sort(errors);
  double below = 0.0;
  for (const auto& [e, w] : errors) {
    below += w / static_cast<double>(kChannels);
    result.p95 = e;
    if (below >= 0.95 * total) {
      break;
    }
  }
  return result;
}

double sample_noise(std::span<const float> reference, std::span<const float> sigma, std::span<const double> weights) {
  const std::array<double, kChannels> floors = floors_of(reference, weights);
  double sum = 0.0;
  double total = 0.0;
  for (std::size_t i = 0; i < reference.size() / kChannels; ++i) {
    if (black(reference, i)) {
      continue;
    }
    const double w = weight_of(weights, i);
    for (std::size_t c = 0; c < kChannels; ++c) {
      const std::size_t k = kChannels * i + c;
      const double below = std::max(std::abs(static_cast<double>(reference[k])), floors[c]);
      sum += below > 0.0 ? w * static_cast<double>(sigma[k]) / below : 0.0;
    }
    total += w * static_cast<double>(kChannels);
  }
  return total > 0.0 ? sum / total : 0.0;
}

NoisyError noisy_error(std::span<const float> a, std::span<const float> reference, std::span<const float> sigma,
                       std::span<const double> weights) {
  const std::array<double, kChannels> floors = floors_of(reference, weights);
  std::vector<std::pair<double, double>> noises;
  std::vector<std::pair<double, double>> excesses;
  for (std::size_t i = 0; i < reference.size() / kChannels; ++i) {
    if (black(a, i) && black(reference, i)) {
      continue;
    }
    double distance = 0.0;
    double noise = 0.0;
    for (std::size_t c = 0; c < kChannels; ++c) {
      const std::size_t k = kChannels * i + c;
      distance += error_of(static_cast<double>(a[k]), static_cast<double>(reference[k]), floors[c]);
      const double below = std::max(std::abs(static_cast<double>(reference[k])), floors[c]);
      noise += below > 0.0 ? kMeanOfNormal * static_cast<double>(sigma[k]) / below : 0.0;
    }
    const double w = weight_of(weights, i);
    noises.emplace_back(noise / kChannels, w);
    excesses.emplace_back((distance - noise) / kChannels, w);
  }
  const Mean excess = mean_of(excesses);
  return {mean_of(noises).value, excess.value, excess.spread, excesses.size()};
}

}  // namespace airlight::measure
