#include "core/choice/leave_out.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <utility>

#include "core/physics/scene_data.h"

namespace airlight::choice {
namespace {

using physics::Physics;
using physics::vec3;

constexpr unsigned int kSteps = 256;
constexpr std::size_t kAltitudes = 200;

double largest(vec3 v) {
  return std::max({v.x, v.y, v.z});
}

double largest(const Spectrum& s) {
  return std::max({s[0], s[1], s[2]});
}

Scene only(const Scene& scene, std::size_t medium) {
  Scene alone = scene;
  alone.media = {scene.media[medium]};
  return alone;
}

// Through the air at a tangent to the ground, from space to space.
double longest_depth(const Scene& scene) {
  Physics p = make_physics(scene);
  return 2.0 * largest(p.optical_depth_to_top(p.scene.planet, 0.0, 0.0, kSteps));
}

// Largest value of the phase function over that of isotropic scattering, its mean.
double phase_peak(Physics& p, unsigned int medium) {
  constexpr int kAngles = 2000;
  double peak = 0.0;
  for (int k = 0; k <= kAngles; ++k) {
    const double nu = std::cos(std::numbers::pi * k / kAngles);
    peak = std::max(peak, static_cast<double>(p.medium_phase(medium, nu)));
  }
  return 4.0 * std::numbers::pi * peak;
}

// Scattering of each medium by altitude, each channel.
std::vector<std::array<Spectrum, kAltitudes>> scattering_profiles(const Scene& scene) {
  Physics p = make_physics(scene);
  std::vector<std::array<Spectrum, kAltitudes>> profiles(scene.media.size());
  for (std::size_t i = 0; i < scene.media.size(); ++i) {
    const auto index = static_cast<unsigned int>(i);
    for (std::size_t k = 0; k < kAltitudes; ++k) {
      const double s = (static_cast<double>(k) + 0.5) / kAltitudes;
      const double h = scene.planet.atmosphere_height * s * s;
      const double density = p.density(p.density_profile(index), p.scene.media[i], h);
      for (std::size_t c = 0; c < 3; ++c) {
        profiles[i][k][c] = density * scene.media[i].scattering[c];
      }
    }
  }
  return profiles;
}

// The medium's largest share in the scattering of a channel, where the channel scatters a thousandth of its most.
double scattering_share(const std::vector<std::array<Spectrum, kAltitudes>>& profiles, std::size_t medium) {
  constexpr double kMatters = 1e-3;
  double share = 0.0;
  for (std::size_t c = 0; c < 3; ++c) {
    std::array<double, kAltitudes> total{};
    for (const auto& profile : profiles) {
      for (std::size_t k = 0; k < kAltitudes; ++k) {
        total[k] += profile[k][c];
      }
    }
    const double most = *std::ranges::max_element(total);
    for (std::size_t k = 0; k < kAltitudes; ++k) {
      if (total[k] > kMatters * most) {
        share = std::max(share, profiles[medium][k][c] / total[k]);
      }
    }
  }
  return share;
}

}  // namespace

Lighter leave_out_media(const Scene& scene, double allowed) {
  Physics all = make_physics(scene);
  const auto profiles = scattering_profiles(scene);
  std::vector<std::pair<double, std::size_t>> effects;
  for (std::size_t i = 0; i < scene.media.size(); ++i) {
    double effect = 2.0 * longest_depth(only(scene, i));
    if (largest(scene.media[i].scattering) > 0.0) {
      effect += phase_peak(all, static_cast<unsigned int>(i)) * scattering_share(profiles, i);
    }
    effects.emplace_back(effect, i);
  }
  std::ranges::sort(effects);
  Lighter lighter{scene, {}, 0.0};
  std::vector<std::size_t> gone;
  for (const auto& [effect, i] : effects) {
    if (lighter.error + effect > allowed || gone.size() + 1 == scene.media.size()) {
      break;
    }
    lighter.error += effect;
    gone.push_back(i);
    char text[64];
    std::snprintf(text, sizeof text, "it changes no radiance by more than %.2g %%", 100.0 * effect);
    lighter.reasons.push_back("medium " + scene.media[i].name + ": " + text);
  }
  std::ranges::sort(gone, std::greater<>());
  for (const std::size_t i : gone) {
    lighter.scene.media.erase(lighter.scene.media.begin() + static_cast<std::ptrdiff_t>(i));
  }
  return lighter;
}

OpticalDepths vertical_depths(const Scene& scene) {
  OpticalDepths depths;
  Physics p = make_physics(scene);
  depths.extinction = largest(p.optical_depth_to_top(p.scene.planet, 0.0, 1.0, kSteps));
  constexpr double kPeaked = 0.3;  // mean cosine, either way
  Scene scattering = scene;
  Scene peaked = scene;
  Scene abrupt = scene;
  for (std::size_t i = 0; i < scene.media.size(); ++i) {
    scattering.media[i].absorption = {};
    peaked.media[i].absorption = {};
    abrupt.media[i].absorption = {};
    if (std::abs(p.scene.media[i].legendre1) < kPeaked) {
      peaked.media[i].scattering = {};
    }
    if (scene.media[i].density.profile != DensityProfile::constant) {
      abrupt.media[i].scattering = {};
    }
  }
  const auto depth_of = [](const Scene& part) {
    Physics physics = make_physics(part);
    return largest(physics.optical_depth_to_top(physics.scene.planet, 0.0, 1.0, kSteps));
  };
  depths.scattering = depth_of(scattering);
  depths.peaked = depth_of(peaked);
  depths.abrupt = depth_of(abrupt);
  return depths;
}

}  // namespace airlight::choice
