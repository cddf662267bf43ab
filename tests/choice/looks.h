#pragma once
// Probes that return what a test wants, and scenes to choose for.

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <string>

#include "core/choice/choose.h"
#include "tests/choice/preset_scene.h"

namespace airlight::choice {

// Paths whose result is the truth, 1, with the noise of so few samples, at least 0.2 %.
inline Traced trace_of_one(const Probes& probes, const TraceOrder& order) {
  constexpr double kNoise = 0.512;  // of one sample
  const double wanted = order.target_error > 0.0 ? std::pow(kNoise / order.target_error, 2.0) : order.samples;
  Traced traced;
  traced.samples = std::clamp(16.0 * std::ceil(wanted / 16.0), 32.0, std::max(order.samples, 32.0));
  traced.batches = traced.samples / 16.0;
  const auto noise = static_cast<float>(kNoise / std::sqrt(traced.samples));
  std::mt19937 random(static_cast<unsigned int>(4 + order.seed));
  std::normal_distribution<float> normal(1.0F, noise);
  traced.radiance.resize(3 * probes.directions.size());
  std::ranges::generate(traced.radiance, [&] { return normal(random); });
  traced.standard_error.assign(traced.radiance.size(), noise);
  return traced;
}

// Radiance 1 in each direction, with the scene's `error`.
inline Looks wrong_by(const std::function<double(const Scene&)>& error, int* calls = nullptr) {
  const auto probe = [=](const Stage& stage, const Probes& probes) {
    const Scene& scene = stage.scene();
    if (calls != nullptr) {
      ++*calls;
    }
    return std::vector<float>(3 * probes.directions.size(), static_cast<float>(1.0 + error(scene)));
  };
  return {probe,
          [](const Stage&, const Probes& probes, const TraceOrder& order) { return trace_of_one(probes, order); }};
}

// An error of 4 % for 8 steps, in inverse proportion to the steps.
inline double by_steps(const Scene& scene) {
  const auto steps = scene.render.parameters.find("steps");
  const bool marches = steps != scene.render.parameters.end();
  return marches ? 0.32 / std::get<int>(steps->second) : 0.5;
}

// Molecules and a haze of optical depth 0.05, by the given JSON texts; the sun at 30 degrees.
inline Scene haze(const std::string& molecules, const std::string& phase, const std::string& more = "{}") {
  return resolve(parse_preset(R"({"airlight": 1, "media": [
      {"name": "molecules", "scattering_per_km": )" +
                                  molecules + R"(, "phase": {"function": "rayleigh"},
       "density": {"profile": "exponential", "scale_height_km": 8}},
      {"name": "haze", "scattering_per_km": 0.042, "phase": )" +
                                  phase + R"(,
       "density": {"profile": "exponential", "scale_height_km": 1.2}}],
    "sun": {"elevation_deg": 30}, "render": )" +
                                  more + "}",
                              "test", {}),
                 method_infos());
}

inline constexpr const char* kBlue = "[0.0058, 0.0136, 0.0331]";
inline constexpr const char* kForward = R"({"function": "henyey-greenstein", "g": 0.8})";

}  // namespace airlight::choice
