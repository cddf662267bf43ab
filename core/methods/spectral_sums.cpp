#include "core/methods/spectral_sums.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace airlight {
namespace {

enum class Way : std::uint32_t { adds, first, in_place };  // spectral_sum.comp

void add_sum(Plan& plan, BufferId part, BufferId picture, const std::array<Rgb, 3>& colours, const std::string& suffix,
             Way way) {
  constexpr std::uint32_t kRow = 65536;  // of the shader: a device takes 65535 workgroups a row at least
  const auto count = static_cast<std::uint32_t>(plan.buffers()[picture.index].bytes / (4 * sizeof(float)));
  std::vector<std::uint32_t> push{count, static_cast<std::uint32_t>(way)};
  push_colours(push, colours);
  plan.add_pass({.name = "spectral_sum" + suffix,
                 .shader = "spectral_sum",
                 .reads = {{"part", part}},
                 .writes = {{"picture", picture}},
                 .grid = {std::min(count, kRow), (count + kRow - 1) / kRow, 1},
                 .push_constants = std::move(push)});
}

}  // namespace

void push_colours(std::vector<std::uint32_t>& push, const std::array<Rgb, 3>& colours) {
  for (const Rgb& colour : colours) {
    for (const double channel : colour) {
      push.push_back(push_constant(channel));
    }
  }
}

void begin_part(Plan& plan, const Part& part, const Tile& tile) {
  std::vector<std::byte> scene = device_scene_bytes(part.air, part.scene, tile);
  if (part.suffix.empty()) {
    plan.put_scene(std::move(scene));
  } else {
    plan.begin_scene(std::move(scene), part.suffix, part.channels);
  }
}

ImageId add_colour_table(Plan& plan, const std::string& name, const std::string& key,
                         const std::vector<ImageId>& tables, const std::vector<std::array<Rgb, 3>>& colours,
                         const std::function<TableText()>& text) {
  assert(!tables.empty() && tables.size() == colours.size());
  const Extent extent = plan.images()[tables.front().index].extent;
  ImageId sum = tables.front();
  for (std::size_t i = 0; i < tables.size(); i += 2) {
    const bool two = i + 1 < tables.size();
    const bool last = i + 2 >= tables.size();
    const std::string step = name + (last ? "" : " of groups up to " + std::to_string(i + 1));
    const ImageId out =
        plan.add_image({.name = step, .extent = extent, .key = last ? key : std::string(), .text = text});
    std::vector<std::uint32_t> push{extent.width, extent.height, i == 0 ? 1U : 0U};
    push_colours(push, colours[i]);
    push_colours(push, two ? colours[i + 1] : std::array<Rgb, 3>{});
    plan.add_pass({.name = step,
                   .shader = "spectral_table",
                   .reads = {{"before", sum}, {"part_a", tables[i]}, {"part_b", tables[two ? i + 1 : i]}},
                   .writes = {{"sum_out", out}},
                   .grid = extent,
                   .push_constants = std::move(push)});
    sum = out;
  }
  return sum;
}

void add_colours(Plan& plan, BufferId buffer, BufferId picture, const std::array<Rgb, 3>& colours,
                 const std::string& suffix, bool first) {
  add_sum(plan, buffer, picture, colours, suffix, first ? Way::first : Way::adds);
}

void turn_into_colours(Plan& plan, BufferId picture, const std::array<Rgb, 3>& colours, const std::string& suffix) {
  const BufferId none = plan.add_buffer_once(filled_buffer("no part", std::vector<std::byte>(4 * sizeof(float))));
  add_sum(plan, none, picture, colours, suffix, Way::in_place);
}

}  // namespace airlight
