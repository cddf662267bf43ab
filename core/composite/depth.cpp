#include "core/composite/depth.h"

#include <array>
#include <cmath>

#include "core/air/scene_block.h"
#include "core/base/text.h"

namespace airlight::composite {

std::optional<DepthKind> depth_kind(std::string_view name) {
  return named<DepthKind>(std::array<std::string_view, 3>{"distance", "planar", "inverse"}, name);
}

float distance_of(double value, DepthKind kind, double unit_km, double cosine) {
  const double depth = kind == DepthKind::inverse ? 1.0 / value : value;
  if (!(value > 0.0) || !std::isfinite(value) || !(depth < kFarthest)) {
    return kSky;
  }
  const double along = kind == DepthKind::distance ? 1.0 : cosine;
  return along > 0.0 ? static_cast<float>(depth * unit_km / along) : kSky;
}

std::vector<float> axis_cosines(const Scene& scene) {
  physics::Physics p = geometry_of(scene);
  const physics::uint projection = projection_code(scene.camera.projection);
  std::vector<float> cosines;
  cosines.reserve(static_cast<std::size_t>(scene.image.width) * static_cast<std::size_t>(scene.image.height));
  for (int y = 0; y < scene.image.height; ++y) {
    for (int x = 0; x < scene.image.width; ++x) {
      const auto ray = p.view_ray(p.scene.camera, projection, x + 0.5, y + 0.5);
      cosines.push_back(static_cast<float>(physics::dot(ray.direction, p.scene.camera.forward)));
    }
  }
  return cosines;
}

std::vector<float> distances(std::span<const float> values, DepthKind kind, double unit_km,
                             std::span<const float> cosines, std::span<const std::uint32_t> pixel_of,
                             DepthCounts& counts) {
  std::vector<float> out;
  out.reserve(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    const float cosine = cosines[pixel_of.empty() ? i : pixel_of[i]];
    out.push_back(distance_of(static_cast<double>(values[i]), kind, unit_km, static_cast<double>(cosine)));
    counts.sky += out.back() == kSky ? 1U : 0U;
    counts.nan += std::isnan(values[i]) ? 1U : 0U;
  }
  return out;
}

}  // namespace airlight::composite
