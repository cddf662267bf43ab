#pragma once
// The refractive index of a planet's air over altitude, in double.

#include <vector>

#include "core/physics/physics.h"
#include "core/scene/scene.h"

namespace airlight {

class RefractiveIndex {
 public:
  // The planet has refraction; `media` are the scene's.
  RefractiveIndex(const Planet& planet, const std::vector<Medium>& media);

  double at(double h);

  // n (R + h) - n(0) R, km: the optical altitude (shaders/physics/refraction.glsl).
  double optical_altitude(double h);

  // Its derivative, k = n + (R + h) dn/dh. A level ray bends as the planet does where k is 0.
  double curvature(double h);

 private:
  physics::Physics formulas_;  // one medium
  Refraction refraction_;
  double radius_;
  double at_ground_ = 1.0;  // density
};

}  // namespace airlight
