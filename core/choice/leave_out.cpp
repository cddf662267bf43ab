#include "core/choice/leave_out.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <numbers>
#include <utility>
#include <vector>

#include "core/methods/ready.h"

namespace airlight::choice {
namespace {

using physics::Physics;
using physics::vec3;

constexpr unsigned int kSteps = 256;

double largest(vec3 v) {
  return std::max({v.x, v.y, v.z});
}

// Through the air of one medium at a tangent to the ground, from space to space.
double longest_depth(const Air& air, unsigned int medium) {
  Physics p = air.formulas();
  for (unsigned int i = 0; i < p.medium_count(); ++i) {
    if (i != medium) {
      p.scene.media[i].scattering = vec3(0.0);
      p.scene.media[i].absorption = vec3(0.0);
    }
  }
  return 2.0 * largest(p.optical_depth_to_top(p.scene.planet, 0.0, 0.0, kSteps));
}

// Largest value of the phase function over that of isotropic scattering, its mean.
double phase_peak(const Air& air, unsigned int medium) {
  Physics p = air.formulas();
  constexpr int kAngles = 2000;
  double peak = 0.0;
  for (int k = 0; k <= kAngles; ++k) {
    const double nu = std::cos(std::numbers::pi * k / kAngles);
    peak = std::max(peak, largest(p.medium_phase(medium, nu)));
  }
  return 4.0 * std::numbers::pi * peak;
}

// The medium's largest share in the scattering of a channel, where the channel scatters a thousandth of its most.
double scattering_share(const Air& air, std::size_t medium) {
  constexpr double kMatters = 1e-3;
  double share = 0.0;
  for (std::size_t c = 0; c < Spectrum{}.size(); ++c) {
    std::vector<double> total;
    for (const Column::PerMedium& density : air.column().density) {
      double sum = 0.0;
      for (std::size_t i = 0; i < air.media().size(); ++i) {
        sum += density[i] * air.media()[i].scattering[c];
      }
      total.push_back(sum);
    }
    const double most = *std::ranges::max_element(total);
    for (std::size_t k = 0; k < total.size(); ++k) {
      if (total[k] > kMatters * most) {
        share = std::max(share, air.column().density[k][medium] * air.media()[medium].scattering[c] / total[k]);
      }
    }
  }
  return share;
}

}  // namespace

Lighter leave_out_media(const Stage& stage, double allowed) {
  const Scene& scene = stage.scene();
  if (scene.spectra) {
    return {stage, {}, 0.0};  // three channels do not tell what a medium is to the other wavelengths
  }
  const Air& air = stage.whole().air;
  const std::uint32_t scattering = air.scattering_media();
  std::vector<std::pair<double, std::size_t>> effects;
  for (std::size_t i = 0; i < scene.media.size(); ++i) {
    if (scene.planet.refraction && scene.planet.refraction->medium == scene.media[i].name) {
      continue;  // light is bent by it
    }
    const auto medium = static_cast<unsigned int>(i);
    double effect = 2.0 * longest_depth(air, medium);
    if ((scattering >> medium & 1U) != 0) {
      effect += phase_peak(air, medium) * scattering_share(air, i);
    }
    effects.emplace_back(effect, i);
  }
  std::ranges::sort(effects);
  Lighter lighter{stage, {}, 0.0};
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
  if (!gone.empty()) {
    Scene without = scene;
    for (const std::size_t i : gone) {
      without.media.erase(without.media.begin() + static_cast<std::ptrdiff_t>(i));
    }
    lighter.stage = ready(without, stage);
  }
  return lighter;
}

}  // namespace airlight::choice
