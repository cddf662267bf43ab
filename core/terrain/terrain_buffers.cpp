#include "core/terrain/terrain_buffers.h"

#include <algorithm>
#include <cstring>
#include <iterator>

#include "core/physics/device_scene.h"

namespace airlight {
namespace {

float narrow(double x) {
  return static_cast<float>(x);
}

device::TerrainData narrow(const physics::TerrainData& t) {
  device::TerrainData out{};
  out.centre_east = narrow(t.centre_east);
  out.centre_north = narrow(t.centre_north);
  out.across_east = narrow(t.across_east);
  out.across_north = narrow(t.across_north);
  out.texel = narrow(t.texel);
  out.columns = t.columns;
  out.rows = t.rows;
  out.levels = t.levels;
  std::copy(std::begin(t.level_first), std::end(t.level_first), std::begin(out.level_first));
  out.colour_columns = t.colour_columns;
  out.colour_rows = t.colour_rows;
  out.sunward_east = narrow(t.sunward_east);
  out.sunward_north = narrow(t.sunward_north);
  out.shadow_along = narrow(t.shadow_along);
  out.shadow_aside = narrow(t.shadow_aside);
  out.shadow_texel = narrow(t.shadow_texel);
  out.shadow_columns = t.shadow_columns;
  out.shadow_rows = t.shadow_rows;
  return out;
}

BufferDesc buffer_of(const char* name, std::vector<std::byte> bytes) {
  const std::size_t size = bytes.size();
  return {.name = name, .bytes = size, .contents = std::move(bytes), .key = {}};
}

template <class T>
std::vector<std::byte> bytes_of(const std::vector<T>& values) {
  std::vector<std::byte> bytes(values.size() * sizeof(T));
  std::memcpy(bytes.data(), values.data(), bytes.size());
  return bytes;
}

}  // namespace

BufferId add_terrain_heights(Plan& plan, const char* name, const physics::HostTerrain& terrain) {
  const device::TerrainData shape = narrow(terrain.shape);
  std::vector<std::byte> bytes(sizeof shape);
  std::memcpy(bytes.data(), &shape, sizeof shape);
  const std::vector<std::byte> heights = bytes_of(*terrain.heights);
  bytes.insert(bytes.end(), heights.begin(), heights.end());
  return plan.add_shared_buffer(buffer_of(name, std::move(bytes)));
}

TerrainBuffers add_terrain(Plan& plan, const physics::HostTerrain& terrain) {
  std::vector<device::vec2> shadows;
  shadows.reserve(terrain.shadows->size());
  for (const physics::vec2& shadow : *terrain.shadows) {
    shadows.push_back({narrow(shadow.x), narrow(shadow.y)});
  }
  return {add_terrain_heights(plan, "terrain", terrain),
          plan.add_shared_buffer(buffer_of("terrain_shadows", bytes_of(shadows))),
          plan.add_buffer(buffer_of("terrain_colours", bytes_of(terrain.colours)))};
}

}  // namespace airlight
