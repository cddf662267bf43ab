#include "core/things/terrain_buffers.h"

#include <algorithm>
#include <iterator>

#include "core/air/scene_block.h"
#include "core/physics/device_scene.h"
#include "core/plan/bytes.h"

namespace airlight {
namespace {

device::TerrainData narrowed_shape(const physics::TerrainData& t) {
  device::TerrainData out{};
  out.centre_east = narrowed(t.centre_east);
  out.centre_north = narrowed(t.centre_north);
  out.across_east = narrowed(t.across_east);
  out.across_north = narrowed(t.across_north);
  out.texel = narrowed(t.texel);
  out.columns = t.columns;
  out.rows = t.rows;
  out.levels = t.levels;
  std::ranges::copy(t.level_first, std::begin(out.level_first));
  out.colour_columns = t.colour_columns;
  out.colour_rows = t.colour_rows;
  out.sunward_east = narrowed(t.sunward_east);
  out.sunward_north = narrowed(t.sunward_north);
  out.shadow_along = narrowed(t.shadow_along);
  out.shadow_aside = narrowed(t.shadow_aside);
  out.shadow_texel = narrowed(t.shadow_texel);
  out.shadow_columns = t.shadow_columns;
  out.shadow_rows = t.shadow_rows;
  return out;
}

}  // namespace

BufferId add_terrain_heights(Plan& plan, const char* name, const physics::HostTerrain& terrain) {
  std::vector<std::byte> bytes = bytes_of_one(narrowed_shape(terrain.shape));
  const std::vector<std::byte> heights = bytes_of(*terrain.heights);
  bytes.insert(bytes.end(), heights.begin(), heights.end());
  return plan.add_shared_buffer(filled_buffer(name, std::move(bytes)));
}

TerrainBuffers add_terrain(Plan& plan, const physics::HostTerrain& terrain) {
  std::vector<device::vec2> shadows;
  shadows.reserve(terrain.shadows->size());
  for (const physics::vec2& shadow : *terrain.shadows) {
    shadows.push_back({narrowed(shadow.x), narrowed(shadow.y)});
  }
  return {add_terrain_heights(plan, "terrain", terrain),
          plan.add_shared_buffer(filled_buffer("terrain_shadows", bytes_of(shadows))),
          plan.add_buffer(filled_buffer("terrain_colours", bytes_of(terrain.colours)))};
}

}  // namespace airlight
