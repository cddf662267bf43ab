#pragma once
// A rendering method's parameters under `render.*`, as plain data: the preset's rules, `airlight methods`, the schema
// and the documentation all read this list.

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace airlight {

struct Scene;

// clamp(scale mu_sun + bias, 0, 1) on direct sunlight: the published lesson's fade around the local horizon.
struct SunFade {
  double scale = 0.0;
  double bias = 0.0;
  bool operator==(const SunFade&) const = default;
};

using TableSize = std::array<int, 2>;  // width, height in texels

// monostate: absent, for a parameter whose absence has a meaning (render.sun_fade).
using ParameterValue = std::variant<std::monostate, bool, int, double, std::string, TableSize, SunFade>;

enum class ParameterKind { boolean, integer, number, choice, table_size, sun_fade };

struct ParameterInfo {
  std::string_view key;  // without "render."
  ParameterKind kind = ParameterKind::number;
  double minimum = 0.0;  // for an integer, a number, each side of a table size
  double maximum = 0.0;  // infinity: no upper limit
  ParameterValue default_value;
  std::span<const std::string_view> choices = {};
  std::string_view meaning;
};

// What keeps a method from rendering a scene.
struct Misfit {
  std::string pointer;  // to the key that may change
  std::string message;  // why, and what to do
};

struct MethodInfo {
  std::string_view name;     // typed after --method
  std::string_view summary;  // one line for --help and the chart's legend
  std::span<const ParameterInfo> parameters;
  bool knows_terrain = false;
  bool knows_bodies = false;       // spheres
  bool knows_ground_maps = false;  // planet.albedo_map, planet.ocean
  bool knows_polarisers = false;   // camera.polariser
  bool knows_clouds = false;
  bool bends_light = false;  // planet.refraction
  // Of scenes whose things it knows; null: it renders them all.
  std::vector<Misfit> (*misfits)(const Scene&) = nullptr;
};

}  // namespace airlight
