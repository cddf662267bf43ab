#pragma once
// All that is said of the density profiles beside their values (shaders/physics/medium.glsl): a row for each. A header
// alone, since libraries without presets take it too.

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

#include "core/physics/physics.h"
#include "core/scene/scene.h"

namespace airlight {

// Gives medium i this density. Its layers stand from `first_layer` on; those for which a scene has no room, which its
// reader refuses, are left out.
inline void put_density(physics::Physics& p, physics::uint i, const Density& density, physics::uint first_layer = 0) {
  physics::MediumData& m = p.scene.media[i];
  m.scale_height = density.scale_height;
  m.center = density.center;
  m.half_width = density.half_width;
  m.below = density.below;
  m.first_layer = first_layer;
  m.layer_count = std::min(static_cast<physics::uint>(density.layers.size()), physics::kMaxDensityLayers - first_layer);
  for (physics::uint k = 0; k < m.layer_count; ++k) {
    p.scene.layers[first_layer + k] = {density.layers[k].altitude, density.layers[k].density};
  }
  p.density_profiles |= static_cast<physics::uint>(density.profile) << (physics::kBitsPerMedium * i);
}

// How the density goes over a range of altitudes, by which quadrature takes it.
enum class DensityShape { none, constant, linear, falling, smooth };  // falling: exponentially

struct ProfileRow {
  DensityProfile profile;
  physics::uint code;  // of medium.glsl
  bool ends_abruptly;
  bool column_is_bound;  // from above
  // The density's integral along the vertical from the ground to `top`, km, in closed form.
  double (*column)(const physics::Physics& p, const physics::MediumData& m, double top);
  // Rising altitudes where the density jumps or bends; of a smooth profile, between which it bends most.
  std::vector<double> (*marks)(const physics::Physics& p, const physics::MediumData& m);
  // Its shape under the first mark, between marks and above the last.
  DensityShape under, between, above;
  // Rising altitudes from 0 to `top` between which a quadrature of 12 nodes holds it. Null: 0, the marks and `top`.
  std::vector<double> (*panels)(const physics::MediumData& m, double top) = nullptr;

  // Whether the density has neither an edge nor a kink.
  constexpr bool is_smooth() const { return under == between && between == above; }
};

namespace profiles {

using physics::MediumData;
using physics::Physics;

inline double exponential_column(const Physics& /*p*/, const MediumData& m, double top) {
  return -m.scale_height * std::expm1(-top / m.scale_height);
}

inline double tent_column(const Physics& /*p*/, const MediumData& m, double top) {
  // Up to altitude h, of a tent that rises from center - half_width.
  const auto up_to = [&m](double h) {
    const double x = std::clamp((h - m.center) / m.half_width, -1.0, 1.0);
    const double part = x < 0.0 ? 0.5 * (1.0 + x) * (1.0 + x) : 1.0 - 0.5 * (1.0 - x) * (1.0 - x);
    return part * m.half_width;
  };
  return up_to(top) - up_to(0.0);
}

inline double lorentzian_column(const Physics& p, const MediumData& m, double top) {
  const double peak = m.half_width * (std::atan((top - m.center) / m.half_width) + std::atan(m.center / m.half_width));
  return std::min(peak, exponential_column(p, m, top));
}

inline double constant_column(const Physics& /*p*/, const MediumData& m, double top) {
  return std::min(m.below, top);
}

inline double layers_column(const Physics& p, const MediumData& m, double top) {
  if (m.layer_count == 0) {
    return 0.0;
  }
  physics::vec2 low = p.density_layer(m.first_layer);
  double column = low.y * std::min(low.x, top);
  for (physics::uint k = 1; k < m.layer_count; ++k) {
    const physics::vec2 high = p.density_layer(m.first_layer + k);
    const double end = std::min(high.x, top);
    if (end > low.x) {
      const double at_end = low.y + (high.y - low.y) * (end - low.x) / (high.x - low.x);
      column += 0.5 * (low.y + at_end) * (end - low.x);
    }
    low = high;
  }
  return column + low.y * std::max(top - low.x, 0.0);
}

inline double fog_column(const Physics& p, const MediumData& m, double top) {
  return std::min(m.below, top) + exponential_column(p, m, std::max(top - m.below, 0.0));
}

inline std::vector<double> no_marks(const Physics& /*p*/, const MediumData& /*m*/) {
  return {};
}

inline std::vector<double> below(const Physics& /*p*/, const MediumData& m) {
  return {m.below};
}

inline std::vector<double> center_and_sides(const Physics& /*p*/, const MediumData& m) {
  return {m.center - m.half_width, m.center, m.center + m.half_width};
}

inline std::vector<double> altitudes(const Physics& p, const MediumData& m) {
  std::vector<double> list(m.layer_count);
  for (physics::uint k = 0; k < m.layer_count; ++k) {
    list[k] = p.density_layer(m.first_layer + k).x;
  }
  return list;
}

// Narrow around the peak, whose poles lie at half_width above and below the real axis, and nowhere longer than two
// scale heights. They end where nothing is left: exp(-80) of the largest coefficient over the longest path is a depth
// of 1e-22.
inline std::vector<double> lorentzian_panels(const MediumData& m, double top) {
  constexpr double kGone = 80.0;
  top = std::min(top, kGone * m.scale_height);
  std::vector<double> edges{0.0};
  for (double low = 0.0; low < top; low = edges.back()) {
    const double off = std::abs(low - m.center);
    const double nearest = low < m.center ? std::max(0.5 * off, m.half_width) : m.half_width + 0.5 * off;
    edges.push_back(low + std::min({nearest, 2.0 * m.scale_height, top}));
  }
  return edges;
}

using enum DensityShape;

// Profile, code, ends abruptly, column is a bound, column, marks, shape under, between and above these, panels.
inline constexpr ProfileRow kProfileRows[] = {
    {DensityProfile::exponential, Physics::kDensityExponential, false, false, exponential_column, no_marks, falling,
     falling, falling},
    {DensityProfile::tent, Physics::kDensityTent, false, false, tent_column, center_and_sides, none, linear, none},
    {DensityProfile::lorentzian, Physics::kDensityLorentzian, false, true, lorentzian_column, center_and_sides, smooth,
     smooth, smooth, lorentzian_panels},
    {DensityProfile::constant, Physics::kDensityConstant, true, false, constant_column, below, constant, none, none},
    {DensityProfile::layers, Physics::kDensityLayers, false, false, layers_column, altitudes, constant, linear,
     constant},
    {DensityProfile::height_fog, Physics::kDensityHeightFog, false, false, fog_column, below, constant, none, falling},
};

constexpr bool stand_in_order() {
  for (physics::uint k = 0; k < std::size(kProfileRows); ++k) {
    const bool smooth_on_device = (Physics::kSmoothProfiles >> k & 1U) != 0;
    if (kProfileRows[k].code != k || kProfileRows[k].profile != static_cast<DensityProfile>(k) ||
        kProfileRows[k].is_smooth() != smooth_on_device) {
      return false;
    }
  }
  return true;
}
static_assert(stand_in_order(), "a row's place is its code; medium.glsl knows the smooth profiles");

}  // namespace profiles

inline const ProfileRow& profile_row(physics::uint code) {
  return profiles::kProfileRows[code];
}

inline const ProfileRow& profile_row(DensityProfile profile) {
  return profiles::kProfileRows[static_cast<std::size_t>(profile)];
}

}  // namespace airlight
