#pragma once
// Scenes for the tests of physics, device and methods, made without a preset.

#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "core/scene/scene.h"
#include "tests/of_scene.h"

namespace airlight::test {

inline constexpr double kDegree = std::numbers::pi / 180.0;

inline Medium medium(std::string name, Spectrum scattering, Spectrum absorption, Density density,
                     PhaseFunction phase = PhaseFunction::isotropic, double g = 0.8) {
  return {std::move(name), SpectralValue(scattering), SpectralValue(absorption), std::move(density), phase, g};
}

// A medium's phase function by a table of Henyey-Greenstein's, at angles that crowd into the peak. Each channel has
// another g, at the wavelengths 600, 500 and 400 nm.
inline PhaseTable peaked_table(const std::vector<double>& asymmetries, int angles = 400) {
  PhaseTable table;
  physics::Physics formulas;
  for (int k = 0; k <= angles; ++k) {
    table.angles_deg.push_back(180.0 * (static_cast<double>(k) / angles) * (static_cast<double>(k) / angles));
  }
  for (const double g : asymmetries) {
    table.rows.emplace_back();
    for (const double angle : table.angles_deg) {
      table.rows.back().push_back(formulas.phase_henyey_greenstein(g, std::cos(angle * kDegree)));
    }
  }
  if (asymmetries.size() > 1) {
    table.wavelengths_nm = {400.0, 500.0, 600.0};
  }
  return table;
}

inline void take_table(Medium& medium, PhaseTable table) {
  medium.phase = PhaseFunction::table;
  medium.phase_table = std::move(table);
  medium.phase_wavelengths = {600.0, 500.0, 400.0};
}

inline Density exponential(double scale_height) {
  Density d;
  d.profile = DensityProfile::exponential;
  d.scale_height = scale_height;
  return d;
}

inline Density tent(double center, double half_width) {
  Density d;
  d.profile = DensityProfile::tent;
  d.center = center;
  d.half_width = half_width;
  return d;
}

inline Density lorentzian(double scale_height, double center, double half_width) {
  Density d = tent(center, half_width);
  d.profile = DensityProfile::lorentzian;
  d.scale_height = scale_height;
  return d;
}

inline Density constant(double below) {
  Density d;
  d.profile = DensityProfile::constant;
  d.below = below;
  return d;
}

inline Density height_fog(double base, double scale_height) {
  Density d = exponential(scale_height);
  d.profile = DensityProfile::height_fog;
  d.below = base;
  return d;
}

inline Density layers(std::vector<DensityLayer> list) {
  Density d;
  d.profile = DensityProfile::layers;
  d.layers = std::move(list);
  return d;
}

// A planet of Earth's size without air; the sun at 30 degrees in the north, with the presets' disc.
inline Scene vacuum() {
  Scene scene;
  scene.sun.elevation = 30.0 * kDegree;
  scene.sun.disc.angular_radius = 0.2666 * kDegree;
  scene.camera.vertical_fov = 60.0 * kDegree;
  return scene;
}

// The clear air of Hillaire 2020, Table 1, over black ground.
inline Scene earth() {
  Scene scene = vacuum();
  scene.media = {medium("rayleigh", {5.802e-3, 13.558e-3, 33.1e-3}, {}, exponential(8.0), PhaseFunction::rayleigh),
                 medium("aerosol", {3.996e-3, 3.996e-3, 3.996e-3}, {0.444e-3, 0.444e-3, 0.444e-3}, exponential(1.2),
                        PhaseFunction::henyey_greenstein, 0.8),
                 medium("ozone", {}, {0.650e-3, 1.881e-3, 0.085e-3}, tent(25.0, 15.0))};
  return scene;
}

// One medium of every density profile, one of every phase function, over bright ground.
inline Scene every_kind() {
  Scene scene = vacuum();
  scene.planet.ground_albedo = {0.3, 0.5, 0.8};
  scene.media = {
      medium("exponential", {5e-3, 1e-2, 3e-2}, {1e-4, 0.0, 0.0}, exponential(8.0), PhaseFunction::rayleigh),
      medium("tent", {1e-4, 2e-4, 3e-4}, {6e-4, 2e-3, 1e-4}, tent(25.0, 15.0), PhaseFunction::isotropic),
      medium("lorentzian", {2e-3, 1e-3, 5e-4}, {}, lorentzian(20.0, 12.0, 4.0), PhaseFunction::henyey_greenstein, 0.7),
      medium("constant", {1e-2, 1e-2, 1e-2}, {1e-3, 1e-3, 1e-3}, constant(1.5), PhaseFunction::cornette_shanks, 0.6),
      medium("layers", {3e-3, 3e-3, 3e-3}, {}, layers({{0.0, 1.0}, {2.0, 0.3}, {7.0, 0.0}, {9.0, 0.4}, {11.0, 0.0}}),
             PhaseFunction::schlick, -0.4),
      medium("fog", {4e-3, 5e-3, 6e-3}, {1e-4, 0.0, 0.0}, height_fog(0.8, 0.5), PhaseFunction::henyey_greenstein, 0.5)};
  return scene;
}

// Every length times k, every coefficient over k: the same picture in other units.
inline Scene rescaled(Scene scene, double k) {
  scene.planet.ground_radius *= k;
  scene.planet.atmosphere_height *= k;
  scene.camera.altitude *= k;
  for (Medium& m : scene.media) {
    for (std::size_t c = 0; c < 3; ++c) {
      m.scattering[c] /= k;
      m.absorption[c] /= k;
    }
    m.density.scale_height *= k;
    m.density.center *= k;
    m.density.half_width *= k;
    m.density.below *= k;
    for (DensityLayer& layer : m.density.layers) {
      layer.altitude *= k;
    }
  }
  return scene;
}

}  // namespace airlight::test
