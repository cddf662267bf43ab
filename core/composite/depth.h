#pragma once
// Depth channels of other programs as distances along the camera's rays.

#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/scene/scene.h"

namespace airlight::composite {

enum class DepthKind {
  distance,  // along the ray, as in panoramas of Cycles
  planar,    // along the camera's axis, as in Cycles' perspective cameras
  inverse,   // 1 / planar, as in Nuke
};

// "distance", "planar", "inverse".
std::optional<DepthKind> depth_kind(std::string_view name);

// The distance where there is nothing.
inline constexpr float kSky = std::numeric_limits<float>::infinity();
// Values from here on, in the file's unit, mean that there is nothing: Cycles writes 1e10.
inline constexpr double kFarthest = 1e9;

struct DepthCounts {
  std::size_t sky = 0;
  std::size_t nan = 0;  // taken as sky
};

// Distance along the ray, km. `value` in units of `unit_km`; `cosine` between the ray and the camera's axis. It is kSky
// for values that are not above 0, not finite or not below kFarthest, and for planar depth beside or behind the camera.
float distance_of(double value, DepthKind kind, double unit_km, double cosine);

// Cosine between each pixel's ray and the camera's axis, rows from the top.
std::vector<float> axis_cosines(const Scene& scene);

// The distances of a picture, flat or deep. `pixel_of[i]`: the pixel of sample i; empty where sample i is pixel i's.
std::vector<float> distances(std::span<const float> values, DepthKind kind, double unit_km,
                             std::span<const float> cosines, std::span<const std::uint32_t> pixel_of,
                             DepthCounts& counts);

}  // namespace airlight::composite
