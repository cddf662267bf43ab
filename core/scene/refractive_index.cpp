#include "core/scene/refractive_index.h"

#include <algorithm>

namespace airlight {

RefractiveIndex::RefractiveIndex(const Planet& planet, const std::vector<Medium>& media)
    : refraction_(*planet.refraction), radius_(planet.ground_radius) {
  Density density;
  density.scale_height = refraction_.scale_height;
  if (refraction_.medium) {
    density = media[*refraction_.medium].density;
  }
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
  at_ground_ = formulas_.profile_density(formulas_.density_profile(0), m, 0.0);
}

double RefractiveIndex::at(double h) {
  const double density = formulas_.profile_density(formulas_.density_profile(0), formulas_.medium(0), h);
  return 1.0 + refraction_.n_minus_1 * density / at_ground_;
}

double RefractiveIndex::optical_altitude(double h) {
  return at(h) * (radius_ + h) - at(0.0) * radius_;
}

// By the difference over a few metres.
double RefractiveIndex::curvature(double h) {
  constexpr double kApart = 2e-3;
  const double low = std::max(h - kApart, 0.0);
  const double high = h + kApart;
  return (optical_altitude(high) - optical_altitude(low)) / (high - low);
}

}  // namespace airlight
