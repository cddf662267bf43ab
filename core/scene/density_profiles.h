#pragma once
// All that is said of the density profiles beside their values (shaders/physics/medium.glsl): a row for each. A header
// alone, since libraries without presets take it too.

#include <algorithm>
#include <cmath>
#include <iterator>
#include <ranges>
#include <vector>

#include "core/base/member.h"
#include "core/physics/device_scene.h"
#include "core/physics/physics.h"
#include "core/scene/scene.h"

namespace airlight {

// A number of a density: its key in files, and where formulas and device have it.
struct DensityNumber {
  const char* key;
  MemberOf<Density, double> value;
  MemberOf<physics::MediumData, double> formula;
  MemberOf<device::MediumData, float> device;
};

inline constexpr DensityNumber kDensityNumbers[] = {
    {"scale_height_km", &Density::scale_height, &physics::MediumData::scale_height, &device::MediumData::scale_height},
    {"center_km", &Density::center, &physics::MediumData::center, &device::MediumData::center},
    {"half_width_km", &Density::half_width, &physics::MediumData::half_width, &device::MediumData::half_width},
    {"below_km", &Density::below, &physics::MediumData::below, &device::MediumData::below},
};
static_assert(sizeof(Density) == sizeof(double) * (1 + std::size(kDensityNumbers)) + sizeof(std::vector<DensityLayer>),
              "each number of a density has a row");

// Gives medium i this density. Its layers stand from `first_layer` on; those for which a scene has no room, which its
// reader refuses, are left out.
inline void put_density(physics::Physics& p, physics::uint i, const Density& density, physics::uint first_layer = 0) {
  physics::MediumData& m = p.scene.media[i];
  for (const DensityNumber& number : kDensityNumbers) {
    m.*number.formula = density.*number.value;
  }
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
  // Integral of the density from the ground up to `top`, km, in closed form; with panels an upper bound.
  double (*column)(const physics::Physics& p, const physics::MediumData& m, double top);
  // Rising altitudes where the density jumps or bends; of a smooth profile, between which it bends most.
  std::vector<double> (*marks)(const physics::Physics& p, const physics::MediumData& m);
  // Its shape under the first mark, between marks and above the last.
  DensityShape under, between, above;
  // Rising altitudes from 0 to `top` between which a quadrature of 12 nodes holds it. Null: 0, the marks and `top`.
  std::vector<double> (*panels)(const physics::MediumData& m, double top) = nullptr;

  // Whether the density has neither an edge nor a kink.
  bool is_smooth() const { return (physics::Physics::kSmoothProfiles >> code & 1U) != 0; }
};

namespace profiles {

using physics::MediumData;
using physics::Physics;

// Columns: formulas, medium, top.
inline constexpr auto constant_column = [](auto&, auto& m, double top) { return std::min(m.below, top); };

inline constexpr auto exponential_column = [](auto&, auto& m, double top) {
  return -m.scale_height * std::expm1(-top / m.scale_height);
};

inline constexpr auto fog_column = [](auto& p, auto& m, double top) {
  return std::min(m.below, top) + exponential_column(p, m, std::max(top - m.below, 0.0));
};

inline constexpr auto tent_column = [](auto&, auto& m, double top) {
  // Up to altitude h, of a tent that rises from center - half_width.
  const auto up_to = [&m](double h) {
    const double x = std::clamp((h - m.center) / m.half_width, -1.0, 1.0);
    const double part = x < 0.0 ? 0.5 * (1.0 + x) * (1.0 + x) : 1.0 - 0.5 * (1.0 - x) * (1.0 - x);
    return part * m.half_width;
  };
  return up_to(top) - up_to(0.0);
};

inline constexpr auto lorentzian_column = [](auto& p, auto& m, double top) {
  const double peak = m.half_width * (std::atan((top - m.center) / m.half_width) + std::atan(m.center / m.half_width));
  return std::min(peak, exponential_column(p, m, top));
};

inline double layers_column(const Physics& p, const MediumData& m, double top) {
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

// Marks: formulas, medium.
using Marks = std::vector<double>;
inline constexpr auto no_marks = [](auto&, auto&) { return Marks{}; };
inline constexpr auto base = [](auto&, auto& m) { return Marks{m.below}; };
inline constexpr auto center_and_sides = [](auto&, auto& m) {
  return Marks{m.center - m.half_width, m.center, m.center + m.half_width};
};
inline constexpr auto altitudes = [](auto& p, auto& m) {
  Marks marks(m.layer_count);
  for (physics::uint k = 0; k < m.layer_count; ++k) {
    marks[k] = p.density_layer(m.first_layer + k).x;
  }
  return marks;
};

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

// Profile, code, ends abruptly, column, marks, shapes under, between and above these, panels.
inline constexpr ProfileRow kProfileRows[] = {
    {DensityProfile::exponential, Physics::kDensityExponential, false, exponential_column, no_marks, falling, falling,
     falling},
    {DensityProfile::tent, Physics::kDensityTent, false, tent_column, center_and_sides, none, linear, none},
    {DensityProfile::lorentzian, Physics::kDensityLorentzian, false, lorentzian_column, center_and_sides, smooth,
     smooth, smooth, lorentzian_panels},
    {DensityProfile::constant, Physics::kDensityConstant, true, constant_column, base, constant, none, none},
    {DensityProfile::layers, Physics::kDensityLayers, false, layers_column, altitudes, constant, linear, constant},
    {DensityProfile::height_fog, Physics::kDensityHeightFog, false, fog_column, base, constant, none, falling},
};
static_assert(std::size(kProfileRows) == kProfileNames.size(), "a row for each name");
static_assert(std::ranges::equal(kProfileRows, std::views::iota(0U, std::size(kProfileRows)), {}, &ProfileRow::code));
static_assert(std::ranges::all_of(kProfileRows, [](const ProfileRow& row) {
  return row.profile == static_cast<DensityProfile>(row.code);
}));

}  // namespace profiles

// Of a DensityProfile or a code.
inline const ProfileRow& profile_row(auto profile) {
  return profiles::kProfileRows[static_cast<std::size_t>(profile)];
}

}  // namespace airlight
