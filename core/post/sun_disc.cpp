#include <bit>
#include <optional>
#include <vector>

#include "core/air/scene_block.h"
#include "core/clouds/cloud_depth.h"
#include "core/luts/luts.h"
#include "core/methods/spectral_sums.h"
#include "core/post/disc_parts.h"
#include "core/post/host_post.h"
#include "core/post/post.h"
#include "core/things/thing_buffers.h"

namespace airlight {
namespace {

constexpr TableSize kDiscTransmittance{256, 64};  // of a method without a table

Tile tile_of(const Picture& picture) {
  const auto count = [](std::uint32_t n) { return static_cast<int>(n); };
  return {count(picture.x), count(picture.y), count(picture.width), count(picture.height)};
}

}  // namespace

Picture picture_of(BufferId buffer, const Tile& tile) {
  const auto count = [](int n) { return static_cast<std::uint32_t>(n); };
  return {buffer, count(tile.width), count(tile.height), count(tile.x), count(tile.y)};
}

bool sun_disc_shows(const Scene& scene, const Picture& picture) {
  physics::Physics p = geometry_of(scene);
  return !disc_parts(p, scene, tile_of(picture)).empty();
}

ImageId add_disc_transmittance(Plan& plan, const Air& air) {
  return add_transmittance(plan, air, kDiscTransmittance);
}

bool add_sun_disc(Plan& plan, const Part& part, std::optional<ImageId> transmittance, const Picture& picture,
                  const std::array<Rgb, 3>& colours) {
  physics::Physics p = geometry_of(part.scene);
  const std::vector<DiscPart> parts = disc_parts(p, part.scene, tile_of(picture));
  if (parts.empty()) {
    return false;
  }
  const ImageId table = transmittance ? *transmittance : add_disc_transmittance(plan, part.air);
  std::vector<Specialization> constants = sunlight_specialization(plan, part.air, table);
  constants.push_back({"kProjection", projection_code(part.scene.camera.projection)});
  constants.push_back({"kLitDisc", part.scene.sun.disc.lit ? 1U : part.scene.sun.disc.cover ? 2U : 0U});
  PassDesc pass = behind_things(plan, part.scene, part.things,
                                {.name = "sun_disc",
                                 .shader = "sun_disc",
                                 .reads = {{"transmittance_lut", table}},
                                 .writes = {{"radiance_out", picture.buffer}},
                                 .specialization = std::move(constants)});
  for (const auto& [pixels, box] : parts) {
    pass.grid = {pixels.width, pixels.height, 1};
    pass.push_constants = {pixels.left,
                           pixels.top,
                           pixels.width,
                           pixels.height,
                           box.across,
                           box.down,
                           push_constant(box.low.x),
                           push_constant(box.low.y),
                           push_constant(box.high.x),
                           push_constant(box.high.y)};
    push_colours(pass.push_constants, colours);
    plan.add_pass(pass);
  }
  return true;
}

bool draw_sun_disc(RadianceImage& picture, const Part& part, const Tile& tile) {
  physics::Physics p = formulas_of(part.air, part.scene);
  p.sun_steps = physics::kTransmittanceSteps;
  part.things.put_into(p);
  const std::vector<DiscPart> parts = disc_parts(p, part.scene, tile);
  const physics::uint projection = projection_code(part.scene.camera.projection);
  for (const auto& [pixels, box] : parts) {
    for (std::uint32_t y = pixels.top; y < pixels.top + pixels.height; ++y) {
      for (std::uint32_t x = pixels.left; x < pixels.left + pixels.width; ++x) {
        physics::vec3 mean = p.disc_in_pixel(projection, x + 0.5, y + 0.5, box);
        if (!part.scene.clouds.empty()) {
          const auto ray = p.view_ray(p.scene.camera, projection, x + 0.5, y + 0.5);
          mean = mean * past_clouds(part.things.clouds(), part.scene, ray.direction);
        }
        const std::size_t column = x - static_cast<std::uint32_t>(tile.x);
        const std::size_t row = y - static_cast<std::uint32_t>(tile.y);
        float* pixel = &picture.rgba[4 * (row * static_cast<std::size_t>(tile.width) + column)];
        pixel[0] += static_cast<float>(mean.x);
        pixel[1] += static_cast<float>(mean.y);
        pixel[2] += static_cast<float>(mean.z);
      }
    }
  }
  return !parts.empty();
}

}  // namespace airlight
