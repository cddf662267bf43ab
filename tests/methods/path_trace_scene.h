#pragma once
// Scenes for the path tracer's tests, and short ways to trace them.

#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <string_view>
#include <vector>

#include "core/methods/method.h"
#include "core/physics/gauss.h"
#include "core/scene/scene.h"
#include "tests/of_scene.h"

namespace airlight {

inline double radians(double degrees) {
  return degrees * std::numbers::pi / 180.0;
}

inline void set_path_trace(Scene& scene) {
  scene.render.method = "path-trace";
  scene.render.parameters.clear();
  for (const ParameterInfo& parameter : find_method("path-trace")->info.parameters) {
    scene.render.parameters.emplace(parameter.key, parameter.default_value);
  }
}

inline void set(Scene& scene, std::string_view key, ParameterValue value) {
  scene.render.parameters.find(key)->second = std::move(value);
}

inline Medium medium(PhaseFunction phase, double g, Spectrum scattering, Spectrum absorption, Density density) {
  Medium m;
  m.phase = phase;
  m.phase_g = g;
  m.scattering = scattering;
  m.absorption = absorption;
  m.density = std::move(density);
  return m;
}

inline Density exponential(double scale_height) {
  Density density;
  density.scale_height = scale_height;
  return density;
}

inline Density constant(double below) {
  Density density;
  density.profile = DensityProfile::constant;
  density.below = below;
  return density;
}

// [H20] Table 1.
inline Scene earth(double sun_elevation_deg, double altitude_km, double albedo = 0.0) {
  Scene scene;
  set_path_trace(scene);
  scene.planet.ground_albedo = {albedo, albedo, albedo};
  scene.sun.elevation = radians(sun_elevation_deg);
  scene.camera.altitude = altitude_km;
  scene.camera.projection = Projection::equirectangular;
  scene.image = {16, 8};
  scene.media.push_back(
      medium(PhaseFunction::rayleigh, 0.0, {5.802e-3, 13.558e-3, 33.1e-3}, {0, 0, 0}, exponential(8.0)));
  scene.media.push_back(medium(PhaseFunction::henyey_greenstein, 0.8, {3.996e-3, 3.996e-3, 3.996e-3},
                               {0.444e-3, 0.444e-3, 0.444e-3}, exponential(1.2)));
  Density ozone;
  ozone.profile = DensityProfile::tent;
  ozone.center = 25.0;
  ozone.half_width = 15.0;
  scene.media.push_back(medium(PhaseFunction::isotropic, 0.0, {0, 0, 0}, {0.65e-3, 1.881e-3, 0.085e-3}, ozone));
  return scene;
}

// A level slab: one medium of constant density, 10 km high, on a planet of a million km. In scalar light, as its judge.
inline Scene slab(double optical_depth, double single_scattering_albedo, PhaseFunction phase, double g) {
  Scene scene;
  set_path_trace(scene);
  scene.render.polarisation = false;
  scene.planet.ground_radius = 1e6;
  scene.planet.atmosphere_height = 10.0;
  const double s = optical_depth / 10.0 * single_scattering_albedo;
  const double a = optical_depth / 10.0 - s;
  scene.media.push_back(medium(phase, g, {s, s, s}, {a, a, a}, constant(10.0)));
  return scene;
}

inline HostPicture trace(const Scene& scene, const View& view = {}, const HostOptions& options = {}) {
  return airlight::traced(scene, view, options);
}

inline HostPicture trace(const Scene& scene, const std::vector<Direction>& directions) {
  return trace(scene, View{directions}, {});
}

// Integral by halving until nothing changes, so that corners of the integrand fall between ever smaller panels.
inline double integrate(const std::function<double(double)>& f, double a, double b, int levels = 40) {
  static const GaussRule rule = gauss_legendre(10);
  const auto panel = [&](double from, double to) {
    double sum = 0.0;
    for (std::size_t k = 0; k < rule.nodes.size(); ++k) {
      sum += rule.weights[k] * f(from + (to - from) * rule.nodes[k]);
    }
    return sum * (to - from);
  };
  const double middle = 0.5 * (a + b);
  const double both = panel(a, middle) + panel(middle, b);
  if (levels == 0 || std::abs(both - panel(a, b)) <= 1e-10 * (1.0 + std::abs(both))) {
    return both;
  }
  return integrate(f, a, middle, levels - 1) + integrate(f, middle, b, levels - 1);
}

}  // namespace airlight
