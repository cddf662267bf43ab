#include "core/post/night_sky.h"

#include <utility>

#include "core/air/scene_block.h"
#include "core/luts/luts.h"
#include "core/plan/bytes.h"
#include "core/post/stars.h"
#include "core/things/thing_buffers.h"

namespace airlight {
namespace {

ImageId add_table(Plan& plan, const Stage& stage) {
  const auto bytes = [stage] {
    std::vector<float> values;
    for (const physics::vec3& v : stage.night()->table().texels) {
      values.insert(values.end(), {narrowed(v.x), narrowed(v.y), narrowed(v.z), 0.0F});
    }
    return bytes_of(values);
  };
  return plan.add_image(
      {.name = "night_sky", .extent = {physics::kNightSide, physics::kNightSide + 1, 1}, .contents_when_run = bytes});
}

}  // namespace

void add_night_sky(Plan& plan, const Stage& stage, ImageId through, const Picture& picture) {
  const Part& part = stage.whole();
  std::vector<Specialization> constants = sunlight_specialization(plan, part.air, through);
  constants.push_back({"kProjection", projection_code(part.scene.camera.projection)});
  std::vector<Binding> reads{{"transmittance_lut", through}, {"night_sky", add_table(plan, stage)}};
  plan.add_pass(behind_things(plan, part.scene, part.things,
                              {.name = "night_sky",
                               .shader = "night_sky",
                               .reads = std::move(reads),
                               .writes = {{"radiance_out", picture.buffer}},
                               .grid = {picture.width, picture.height, 1},
                               .push_constants = {picture.width, picture.height},
                               .specialization = std::move(constants),
                               .cost = 2.0}));
}

physics::Physics night_formulas(const Stage& stage) {
  physics::Physics p = formulas_of(stage.whole().air, stage.scene());
  p.sun_steps = physics::kTransmittanceSteps;
  p.night_sky = stage.night()->table();
  return p;
}

void draw_night_sky(RadianceImage& picture, const Stage& stage, const Tile& tile) {
  physics::Physics p = night_formulas(stage);
  if (stage.scene().stars) {
    draw_stars(picture, p, stage, tile);
  }
  if (!stage.scene().night_sky) {
    return;
  }
  const physics::uint projection = projection_code(stage.scene().camera.projection);
  std::size_t i = 0;
  for (int y = tile.y; y < tile.y + tile.height; ++y) {
    for (int x = tile.x; x < tile.x + tile.width; ++x, i += 4) {
      const auto ray = p.view_ray(p.scene.camera, projection, x + 0.5, y + 0.5);
      const physics::vec3 light = ray.inside ? night_sky_along(p, ray.direction) : physics::vec3(0.0);
      picture.rgba[i] += narrowed(light.x);
      picture.rgba[i + 1] += narrowed(light.y);
      picture.rgba[i + 2] += narrowed(light.z);
    }
  }
}

physics::vec3 night_sky_along(physics::Physics& p, const physics::vec3& direction) {
  return p.night_along(p.scene.planet, p.scene.camera.altitude, direction);
}

}  // namespace airlight
