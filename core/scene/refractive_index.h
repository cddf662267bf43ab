#pragma once
// The refractive index of a planet's air over altitude, in double. A header alone, since libraries without presets take
// it too.

#include <algorithm>

#include "core/scene/density_profiles.h"
#include "core/scene/scene.h"

namespace airlight {

class RefractiveIndex {
 public:
  // The planet has refraction.
  explicit RefractiveIndex(const Planet& planet)
      : n_minus_1_(planet.refraction->n_minus_1), radius_(planet.ground_radius) {
    put_density(formulas_, 0, planet.refraction->density);
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
