#pragma once
// The tables baked on the host in double, texel by texel as in shaders/passes.

#include "core/physics/physics.h"

namespace airlight::test {

inline physics::HostTable empty_table(int width, int height) {
  physics::HostTable table;
  table.width = width;
  table.height = height;
  table.texels.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  return table;
}

// texel(x, y): both run over the texel centres from 0 to 1.
template <class F>
physics::HostTable filled_table(int width, int height, const F& texel) {
  physics::HostTable table = empty_table(width, height);
  for (int j = 0; j < height; ++j) {
    for (int i = 0; i < width; ++i) {
      const double x = width > 1 ? static_cast<double>(i) / (width - 1) : 0.0;
      const double y = height > 1 ? static_cast<double>(j) / (height - 1) : 0.0;
      table.texels[static_cast<std::size_t>(j) * static_cast<std::size_t>(width) + static_cast<std::size_t>(i)] =
          texel(x, y);
    }
  }
  return table;
}

inline physics::HostTable transmittance_table(physics::Physics& p, int width, int height,
                                              unsigned int steps = physics::kTransmittanceSteps) {
  const physics::PlanetData& planet = p.scene.planet;
  return filled_table(width, height, [&](double x, double y) {
    const auto state = p.transmittance_state(planet, x, y);
    return physics::exp(-p.optical_depth_to_top(planet, state.h, state.mu, steps));
  });
}

// Mean of a point's gather over the 64 directions.
inline physics::Physics::ScatteringGather mean_gather(physics::Physics& p, double h, double mu_sun) {
  physics::Physics::ScatteringGather mean{};
  for (unsigned int k = 0; k < physics::kMultipleScatteringDirections; ++k) {
    const auto ray = p.gather_ray(p.scene.planet, h, mu_sun, k);
    const auto gather = p.gather_scattering(p.scene.planet, p.scene.sun, ray, physics::kMultipleScatteringSteps);
    mean.second_order = mean.second_order + gather.second_order / physics::kMultipleScatteringDirections;
    mean.transfer = mean.transfer + gather.transfer / physics::kMultipleScatteringDirections;
  }
  return mean;
}

// Needs the transmittance table.
inline physics::HostTable multiple_scattering_table(physics::Physics& p, int width, int height) {
  return filled_table(width, height, [&](double x, double y) {
    const auto state = p.scattering_state(p.scene.planet, x, y);
    const auto mean = mean_gather(p, state.h, state.mu_sun);
    return p.sum_of_orders(mean.second_order, mean.transfer);
  });
}

// Needs both other tables.
inline physics::HostTable ground_irradiance_table(const physics::Physics& lit, int size) {
  physics::Physics p = lit;
  p.ground_irradiance_lut = {};  // rays that leave the ground never end on it
  p.scene.sun.irradiance = physics::vec3(1.0);
  return filled_table(size, 1, [&](double x, double) {
    physics::vec3 sum;
    for (unsigned int k = 0; k < physics::kGroundIrradianceDirections; ++k) {
      const auto ray = p.irradiance_ray(p.scene.planet, 2.0 * x - 1.0, k);
      sum = sum + p.march(p.scene.planet, p.scene.sun, ray, physics::kMultipleScatteringSteps, physics::kStepsQuadratic,
                          p.scene.multiple_scattering_scale)
                      .radiance;
    }
    return sum * p.irradiance_weight();
  });
}

struct HostTableSizes {
  int transmittance_width = 256;
  int transmittance_height = 64;
  int scattering = 32;
  int ground = physics::kGroundIrradianceSize;
};

inline void bake(physics::Physics& p, const HostTableSizes& sizes = {}) {
  p.transmittance_lut = transmittance_table(p, sizes.transmittance_width, sizes.transmittance_height);
  p.multiple_scattering_lut = multiple_scattering_table(p, sizes.scattering, sizes.scattering);
  const physics::vec3 albedo = p.scene.planet.ground_albedo;
  if (albedo.x > 0.0 || albedo.y > 0.0 || albedo.z > 0.0) {
    p.ground_irradiance_lut = ground_irradiance_table(p, sizes.ground);
  }
}

}  // namespace airlight::test
