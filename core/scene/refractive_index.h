#pragma once
// The refractive index of a planet's air over altitude, in double. A header alone, since libraries without presets take
// it too.

#include <algorithm>

#include "core/physics/physics.h"
#include "core/scene/scene.h"

namespace airlight {

class RefractiveIndex {
 public:
  // The planet has refraction.
  explicit RefractiveIndex(const Planet& planet)
      : n_minus_1_(planet.refraction->n_minus_1), radius_(planet.ground_radius) {
    const Density& density = planet.refraction->density;
    physics::MediumData& m = formulas_.scene.media[0];
    m.scale_height = density.scale_height;
    m.center = density.center;
    m.half_width = density.half_width;
    m.below = density.below;
    m.layer_count = static_cast<physics::uint>(density.layers.size());
    for (std::size_t i = 0; i < density.layers.size(); ++i) {
      formulas_.scene.layers[i] = {density.layers[i].altitude, density.layers[i].density};
    }
    formulas_.media = 1;
    formulas_.density_profiles = static_cast<physics::uint>(density.profile);
    at_ground_ = density_at(0.0);
  }

  double at(double h) { return 1.0 + n_minus_1_ * density_at(h) / at_ground_; }

  // n (R + h) - n(0) R, km: the optical altitude (shaders/physics/refraction.glsl).
  double optical_altitude(double h) { return at(h) * (radius_ + h) - at(0.0) * radius_; }

  // Its derivative, k = n + (R + h) dn/dh, by the difference over a few metres. A level ray bends as the planet does
  // where k is 0.
  double curvature(double h) {
    constexpr double kApart = 2e-3;
    const double low = std::max(h - kApart, 0.0);
    const double high = h + kApart;
    return (optical_altitude(high) - optical_altitude(low)) / (high - low);
  }

 private:
  double density_at(double h) {
    return formulas_.profile_density(formulas_.density_profile(0), formulas_.medium(0), h);
  }

  physics::Physics formulas_;  // one medium
  double n_minus_1_;
  double radius_;
  double at_ground_ = 1.0;  // density
};

}  // namespace airlight
