// The air before things by `orders`: a march to each, or an aerial volume (shaders/physics/aerial_volume.glsl).

#include <algorithm>
#include <cstring>

#include "core/air/scene_block.h"
#include "core/luts/luts.h"
#include "core/methods/orders_parts.h"
#include "core/methods/scene_air.h"
#include "core/methods/sky_pass.h"
#include "core/terrain/terrain_buffers.h"

namespace airlight::orders {
namespace {

struct SpanBuffers {
  BufferId list;
  BufferId air;
  std::uint32_t count;
};

SpanBuffers add_span_buffers(Plan& plan, std::span<const Span> spans) {
  constexpr std::size_t kVector = 4 * sizeof(float);
  std::vector<std::byte> bytes(spans.size() * kVector);
  for (std::size_t i = 0; i < spans.size(); ++i) {
    std::memcpy(bytes.data() + i * kVector, &spans[i], sizeof(Span));
  }
  const BufferId list =
      plan.add_buffer({.name = "spans", .bytes = spans.size() * kVector, .contents = std::move(bytes)});
  const BufferId air =
      plan.add_buffer({.name = "air", .bytes = 2 * spans.size() * kVector, .host_readable = true, .zeroed = false});
  return {list, air, static_cast<std::uint32_t>(spans.size())};
}

// Two thirds of the picture's table each way. What it leaves out shows far less: light before things is gathered over
// less air, and divided by what the transmittance takes.
FactorTable volume_table(Scene scene, const Air& air) {
  auto& size = std::get<TableSize>(scene.render.parameters.find("sky_lut")->second);
  size = {std::max(2 * size[0] / 3, 8), std::max(2 * size[1] / 3, 8)};
  return factor_table(scene, air, air.scattering_media(), false);
}

// The aerial volume and the mean extinction beside it (shaders/physics/aerial_volume.glsl).
std::vector<Binding> add_volume(Plan& plan, const Scene& scene, const Light& light, const FactorTable& table,
                                const std::string& kept_as) {
  const auto slices = static_cast<std::uint32_t>(scene.render.get<int>("aerial_slices"));
  View view;
  view.kept_as = kept_as;
  const ImageId volume = plan.add_image({.name = "aerial_volume",
                                         .extent = {table.columns * table.blocks, table.rows(), slices},
                                         .key = picture_table_key(view, "aerial_volume")});
  const ImageId extinction = plan.add_image({.name = "mean_extinction",
                                             .extent = {4 * slices, table.rows(), 1},
                                             .key = picture_table_key(view, "mean_extinction")});
  std::vector<Specialization> constants = light.constants;
  add_table_constants(constants, table);
  constants.push_back({"kSlices", slices});
  // Two steps from slice to slice at least: one may fall to each side of the shadow's edge.
  const std::uint32_t steps = light.by_shells ? 1 : std::max(2u, light.steps / slices);
  plan.add_pass({.name = "aerial_extinction",
                 .shader = "aerial_extinction",
                 .reads = light.reads(),
                 .writes = {{"extinction_out", extinction}},
                 .grid = {table.rows(), 1, 1},
                 .specialization = constants,
                 .team = 64,
                 .cost = 4.0 * slices});
  plan.add_pass({.name = "aerial_volume",
                 .shader = "aerial_volume",
                 .reads = light.reads(),
                 .writes = {{"volume_out", volume}},
                 .grid = {table.columns, table.rows(), 1},
                 .push_constants = {steps},
                 .specialization = std::move(constants),
                 .team = 8,
                 .cost = ray_cost(steps * slices)});
  return {{"volume_lut", volume}, {"extinction_lut", extinction}};
}

}  // namespace

SpanPasses add_spans(Plan& plan, const Scene& scene, const Air& air, std::span<const Span> spans, const SpanWay& way) {
  const Light light = add_light(plan, scene, air);
  const SpanBuffers buffers = add_span_buffers(plan, spans);
  std::vector<Binding> reads = light.reads();
  std::vector<Specialization> constants = light.constants;
  std::vector<std::uint32_t> push{buffers.count, light.steps};
  if (way.volume) {
    const FactorTable table = volume_table(scene, air);
    reads = add_volume(plan, scene, light, table, way.kept_as);
    constants = medium_specialization(air);
    add_table_constants(constants, table);
    constants.push_back({"kSlices", static_cast<std::uint32_t>(scene.render.get<int>("aerial_slices"))});
    push.pop_back();
  }
  const char* shader = way.volume ? "air_from_volume" : "air_spans";
  if (scene.terrain) {
    shader = "air_spans_terrain";
    push.push_back(add_shadowed_terrain(plan, scene, reads, constants));
  }
  reads.push_back({"spans", buffers.list});
  constants.push_back({"kProjection", projection_code(scene.camera.projection)});
  plan.add_pass({.name = "air",
                 .shader = shader,
                 .reads = std::move(reads),
                 .writes = {{"air_out", buffers.air}},
                 .grid = {buffers.count, 1, 1},
                 .push_constants = std::move(push),
                 .specialization = std::move(constants),
                 .cost = way.volume ? 3.0 : ray_cost(light.steps)});
  return {buffers.air};
}

}  // namespace airlight::orders
