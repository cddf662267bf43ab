#pragma once
// Shared by the parity tests: the calls on double, inputs, and comparison with a bound for each result.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "core/luts/luts.h"
#include "tests/gpu/gpu_fixture.h"
#include "tests/physics/scenes.h"

namespace airlight::physics {

#include "tests/gpu/parity_codes.h"

struct HostCalls : Physics {
#include "tests/gpu/parity_calls.glsl"
};

}  // namespace airlight::physics

namespace airlight::test {

using physics::HostCalls;
using Inputs = std::array<float, 6>;
using Values = std::array<double, 6>;

// Permitted difference of a result: the larger of the two.
struct Bound {
  double absolute = 0.0;
  double relative = 0.0;
  double allowed(double expected) const { return std::max(absolute, relative * std::abs(expected)); }
};
inline constexpr Bound kExact{};
using Bounds = std::array<Bound, 6>;

// Numbers that a float holds, so that host and device have the same inputs.
inline double as_float(double x) {
  return static_cast<double>(static_cast<float>(x));
}

inline Scene float_exact(Scene scene) {
  const auto spectrum = [](Spectrum& s) {
    for (double& x : s) {
      x = as_float(x);
    }
  };
  spectrum(scene.planet.ground_albedo);
  spectrum(scene.sun.irradiance);
  for (Medium& m : scene.media) {
    spectrum(m.scattering);
    spectrum(m.absorption);
    for (double* x :
         {&m.density.scale_height, &m.density.center, &m.density.half_width, &m.density.below, &m.phase_g}) {
      *x = as_float(*x);
    }
    for (DensityLayer& layer : m.density.layers) {
      layer = {as_float(layer.altitude), as_float(layer.density)};
    }
  }
  return scene;
}

// Seeded random numbers. The standard's distributions differ from library to library; its engines do not.
class Random {
 public:
  double uniform(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine_() >> 11U) * 0x1p-53);
  }
  double log_uniform(double low, double high) { return std::exp(uniform(std::log(low), std::log(high))); }
  // An altitude inside an atmosphere of 100 km: the ground, 0.1 m, 99.9 km, the top, and anything between.
  double altitude() {
    constexpr std::array<double, 8> kEdges{0.0, 1e-7, 1e-4, 1e-3, 1.0, 99.9, 99.999, 100.0};
    return uniform(0.0, 1.0) < 0.3 ? kEdges[engine_() % kEdges.size()] : log_uniform(1e-6, 100.0);
  }
  // A zenith cosine: any, near level, near the poles, and the edges themselves.
  double cosine() {
    const double kind = uniform(0.0, 1.0);
    const double sign = uniform(0.0, 1.0) < 0.5 ? -1.0 : 1.0;
    if (kind < 0.1) {
      constexpr std::array<double, 3> kEdges{-1.0, 0.0, 1.0};
      return kEdges[engine_() % kEdges.size()];
    }
    return kind < 0.5 ? uniform(-1.0, 1.0)
                      : sign * (kind < 0.8 ? log_uniform(1e-6, 1.0) : 1.0 - log_uniform(1e-6, 1.0));
  }

 private:
  std::mt19937_64 engine_{20250611};
};

// Three floats that are a direction's (mu, mu_sun, nu), derived from actual vectors.
struct Cosines {
  float mu;
  float mu_sun;
  float nu;
};
inline Cosines cosines(double mu, double mu_sun, double azimuth) {
  const double nu = mu * mu_sun + std::sqrt((1.0 - mu * mu) * (1.0 - mu_sun * mu_sun)) * std::cos(azimuth);
  return {static_cast<float>(mu), static_cast<float>(mu_sun), static_cast<float>(nu)};
}

}  // namespace airlight::test
