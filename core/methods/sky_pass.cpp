#include "core/methods/sky_pass.h"

#include <cmath>
#include <cstring>

#include "core/physics/scene_data.h"

namespace airlight {
namespace {

std::vector<std::byte> direction_bytes(const View& view) {
  std::vector<float> xyz0;
  for (const Direction& d : view.directions) {
    const double c = std::cos(d.elevation);
    xyz0.push_back(static_cast<float>(std::sin(d.azimuth) * c));
    xyz0.push_back(static_cast<float>(std::sin(d.elevation)));
    xyz0.push_back(static_cast<float>(-std::cos(d.azimuth) * c));
    xyz0.push_back(0.0f);
  }
  if (xyz0.empty()) {
    xyz0.assign(4, 0.0f);  // the shader declares the buffer whatever the projection
  }
  std::vector<std::byte> bytes(xyz0.size() * sizeof(float));
  std::memcpy(bytes.data(), xyz0.data(), bytes.size());
  return bytes;
}

}  // namespace

SkyTarget add_sky_target(Plan& plan, const Scene& scene, const View& view) {
  const bool listed = !view.directions.empty();
  const auto count = static_cast<std::uint32_t>(view.directions.size());
  SkyTarget target;
  target.grid =
      listed ? Extent{count, 1, 1}
             : Extent{static_cast<std::uint32_t>(scene.image.width), static_cast<std::uint32_t>(scene.image.height), 1};
  target.projection = listed ? physics::kProjectionListed : projection_code(scene.camera.projection);
  const std::size_t vectors =
      static_cast<std::size_t>(target.grid.width) * static_cast<std::size_t>(target.grid.height) * (listed ? 2 : 1);
  target.radiance = plan.add_buffer({.name = "radiance",
                                     .bytes = vectors * 4 * sizeof(float),
                                     .host_readable = true,
                                     .contents = {},
                                     .key = std::string(kRadianceKey),
                                     .carried = true,
                                     .zeroed = false});
  std::vector<std::byte> directions = direction_bytes(view);
  const std::size_t direction_size = directions.size();
  target.directions = plan.add_buffer({.name = "directions",
                                       .bytes = direction_size,
                                       .host_readable = false,
                                       .contents = std::move(directions),
                                       .key = {}});
  return target;
}

}  // namespace airlight
