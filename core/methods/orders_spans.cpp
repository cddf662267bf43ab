// The air before things by `orders`: a march to each, or an aerial volume (shaders/physics/aerial_volume.glsl).

#include <algorithm>
#include <bit>
#include <cassert>

#include "core/air/scene_block.h"
#include "core/luts/luts.h"
#include "core/methods/orders_parts.h"
#include "core/methods/sky_pass.h"

namespace airlight::orders {
namespace {

constexpr std::uint32_t kListColumns = 4096;  // a device takes 65535 workgroups a row at least

SpanInput add_span_input(Plan& plan, const Scene& scene, const Spans& spans) {
  const bool listed = spans.rows.empty();
  const auto bytes = listed ? std::as_bytes(spans.list) : std::as_bytes(spans.rows);
  const BufferId list =
      plan.add_buffer({.name = "spans", .bytes = bytes.size(), .contents = {bytes.begin(), bytes.end()}});
  return {list, listed ? kListColumns : static_cast<std::uint32_t>(scene.image.width),
          static_cast<std::uint32_t>(spans.size()), spans.first_row, !listed};
}

// The moments' copy in halves (moment_ratios.comp).
ImageId add_ratios(Plan& plan, ImageId moments) {
  const ImageDesc& table = plan.images()[moments.index];
  const Extent extent = table.extent;
  const ImageId ratios = plan.add_image({.name = "moment_ratios",
                                         .extent = extent,
                                         .key = table.key.empty() ? "" : table.key + " in halves",
                                         .half = true});
  plan.add_pass(
      {.shader = "moment_ratios", .reads = {{"moments", moments}}, .writes = {{"ratios_out", ratios}}, .grid = extent});
  return ratios;
}

// Panels of two nodes bring a ray to a thing within a tenth of a percent at half of the picture's steps. Shells and
// shadows ask for all of them.
std::uint32_t span_steps(const Part& part, const Light& light) {
  return light.by_shells || part.things.stand_in_the_air() ? light.steps : (light.steps + 1) / 2;
}

}  // namespace

FactorTable volume_table(Part part, bool apart) {
  auto& size = std::get<TableSize>(part.scene.render.parameters.find("sky_lut")->second);
  size = {std::max(2 * size[0] / 3, 8), std::max(2 * size[1] / 3, 8)};
  return apart ? unfolded_table(part) : factor_table(part, part.air.scattering_media(), false, physics::kStokesNone);
}

Volume add_volume(Plan& plan, const Scene& scene, const Light& light, const FactorTable& table, const View& view,
                  float half_angle) {
  const auto slices = static_cast<std::uint32_t>(scene.render.get<int>("aerial_slices"));
  const ImageId volume = plan.add_image({.name = "aerial_volume",
                                         .extent = {table.columns * table.blocks, table.rows(), slices},
                                         .key = picture_table_key(view, "aerial_volume"),
                                         .half = true});
  const ImageId extinction = plan.add_image({.name = "mean_extinction",
                                             .extent = {4 * slices, table.rows(), 1},
                                             .key = picture_table_key(view, "mean_extinction")});
  const ImageId peaks = plan.add_image(
      {.name = "mean_peaks", .extent = {4 * slices, table.rows(), 1}, .key = picture_table_key(view, "mean_peaks")});
  std::vector<Specialization> constants = light.constants;
  add_volume_constants(constants, scene, table);
  // Whole panels of two from slice to slice.
  const std::uint32_t steps = light.by_shells ? 1 : std::max(2u, light.steps / slices / 2 * 2);
  plan.add_pass({.name = "aerial_extinction",
                 .shader = "aerial_extinction",
                 .reads = light.reads(),
                 .writes = {{"extinction_out", extinction}, {"peaks_out", peaks}},
                 .grid = {table.rows(), 1, 1},
                 .specialization = constants,
                 .team = 64,
                 .cost = 4.0 * slices});
  plan.add_pass({.name = "aerial_volume",
                 .shader = "aerial_volume",
                 .reads = light.reads(),
                 .writes = {{"volume_out", volume}},
                 .grid = {table.rows(), table.columns, 1},
                 .push_constants = {steps, std::bit_cast<std::uint32_t>(half_angle)},
                 .specialization = std::move(constants),
                 .team = 16,
                 .cost = ray_cost(steps * slices)});
  return {volume, extinction, peaks};
}

void add_volume_constants(std::vector<Specialization>& constants, const Scene& scene, const FactorTable& table) {
  add_table_constants(constants, table);
  constants.push_back({"kSlices", static_cast<std::uint32_t>(scene.render.get<int>("aerial_slices"))});
}

SpanPasses add_spans(Plan& plan, const Part& part, const Spans& spans, const SpanWay& way) {
  refuse_around_clouds(part.scene, true);
  const Light light = add_light(plan, part);
  assert(!way.volume || part.scene.clouds.empty());
  const SpanInput input = add_span_input(plan, part.scene, spans);
  std::vector<Binding> reads = light.reads();
  std::vector<Specialization> constants = light.constants;
  std::vector<std::uint32_t> push{input.columns, input.count, input.first_row};
  if (way.volume) {
    const FactorTable table = volume_table(part, false);
    View view;
    view.kept_as = way.kept_as;
    reads = add_volume(plan, part.scene, light, table, view, half_angle_of(part.scene, view)).reads();
    constants = medium_specialization(part.air);
    add_volume_constants(constants, part.scene, table);
  } else {
    push.push_back(span_steps(part, light));
  }
  const char* shader = way.volume ? "air_from_volume" : "air_spans";
  if (part.things.stand_in_the_air()) {
    shader = "air_spans_things";
    add_things_to_march(plan, part, light, reads, constants);
  } else if (!way.volume) {
    reads.push_back({"moment_ratios_lut", add_ratios(plan, light.moments)});
  }
  reads.push_back({"spans", input.list});
  constants.push_back({"kWholeRows", input.whole_rows ? 1U : 0U});
  constants.push_back({"kProjection", projection_code(part.scene.camera.projection)});
  const BufferId found = plan.add_buffer({.name = "air",
                                          .bytes = input.count * std::size_t{way.volume ? 16U : 24U},
                                          .host_readable = true,
                                          .zeroed = false});
  plan.add_pass({.name = "air",
                 .shader = shader,
                 .reads = std::move(reads),
                 .writes = {{"air_out", found}},
                 .grid = input.grid(),
                 .push_constants = std::move(push),
                 .specialization = std::move(constants),
                 .cost = way.volume ? 3.0 : ray_cost(span_steps(part, light))});
  if (!part.scene.clouds.empty()) {
    View view;
    view.kept_as = way.kept_as;
    add_clouds_to_spans(plan, part, view, light, input, found);
  }
  return {found, way.volume};
}

}  // namespace airlight::orders
