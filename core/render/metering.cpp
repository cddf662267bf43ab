#include "core/render/metering.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "core/base/error.h"
#include "core/methods/ready.h"

namespace airlight {
namespace {

constexpr double kMostPixels = 65536.0;
constexpr double kMostSampledPixels = 2304.0;  // of a method that samples, a few each
constexpr int kMeteringSamples = 32;

// A smaller size of the same shape. For a map that is cut it stays a multiple of its layout.
ImageSize metered_size(const Scene& scene, double most_pixels) {
  const ImageSize& image = scene.image;
  const double smaller =
      std::min(1.0, std::sqrt(most_pixels / (static_cast<double>(image.width) * static_cast<double>(image.height))));
  if (is_cut(scene.camera.projection)) {
    const int whole = std::gcd(image.width, image.height);
    const int part = std::max(1, static_cast<int>(whole * smaller));
    return {image.width / whole * part, image.height / whole * part};
  }
  return {std::max(1, static_cast<int>(image.width * smaller)), std::max(1, static_cast<int>(image.height * smaller))};
}

// The sampling method with few samples and without limits of its own, so that metering does not wait.
RenderSettings few_samples(RenderSettings settings) {
  settings.parameters["samples"] = kMeteringSamples;
  settings.parameters["time_limit_s"] = 0.0;
  settings.parameters["target_error"] = 0.0;
  return settings;
}

double four_digits(double value) {
  const double unit = std::pow(10.0, std::floor(std::log10(value)) - 3.0);
  return std::round(value / unit) * unit;
}

}  // namespace

Scene by_day(const Scene& scene) {
  Scene day = scene;
  day.sun.elevation = 0.25 * std::numbers::pi;
  day.sun.azimuth = scene.camera.azimuth + std::numbers::pi;
  return day;
}

Rendering metered_picture(const DeviceOnDemand& device, const Stage& stage) {
  const Scene& scene = stage.scene();
  Scene small = scene;
  small.image = metered_size(scene, samples(stage) ? kMostSampledPixels : kMostPixels);
  small.display = {};
  if (samples(stage)) {
    small.render = few_samples(scene.render);
  }
  Rendering rendering = render(device, ready(small, stage), {});
  if (const std::string fault = rendering.fault(); !fault.empty()) {
    throw RunError("the picture that the exposure is metered on: " + fault);
  }
  return rendering;
}

double metered_exposure(const DeviceOnDemand& device, const Stage& stage) {
  return four_digits(metered_picture(device, stage).exposure);
}

}  // namespace airlight
