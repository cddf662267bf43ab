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
  distance,  // along the ray, as panoramas of Cycles have it
  planar,    // along the camera's axis, as its perspective cameras have it
  inverse,   // 1 / planar, as Nuke has it
};

// "distance", "planar", "inverse".
std::optional<DepthKind> depth_kind(std::string_view name);

// Nothing is there.
inline constexpr float kSky = std::numeric_limits<float>::infinity();
// Values from here on, in the file's unit, mean that nothing is there: Cycles writes 1e10.
inline constexpr double kFarthest = 1e9;

struct DepthCounts {
  std::size_t sky = 0;
  std::size_t nan = 0;  // taken as sky
};

// km along the ray. `value` in units of `unit_km`; `cosine` between the ray and the camera's axis. kSky for values that
// are not above 0, that are not finite or not below kFarthest, and for planar depth beside or behind the camera.
float distance_of(double value, DepthKind kind, double unit_km, double cosine);

// Cosine between each pixel's ray and the camera's axis, rows from the top.
std::vector<float> axis_cosines(const Scene& scene);

// The distances of a whole picture or a deep one; `pixel_of[i]`: the pixel of sample i, empty: sample i is pixel i's.
std::vector<float> distances(std::span<const float> values, DepthKind kind, double unit_km,
                             std::span<const float> cosines, std::span<const std::uint32_t> pixel_of,
                             DepthCounts& counts);

}  // namespace airlight::composite
