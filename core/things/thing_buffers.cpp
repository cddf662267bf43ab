#include "core/things/thing_buffers.h"

#include <algorithm>
#include <iterator>
#include <memory>
#include <utility>

#include "core/air/scene_block.h"
#include "core/plan/bytes.h"
#include "core/things/bodies.h"
#include "core/things/ground.h"

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
  out.shadow_reach = narrowed(t.shadow_reach);
  out.shadow_low = narrowed(t.shadow_low);
  out.shadow_step = narrowed(t.shadow_step);
  out.shadow_soft = narrowed(t.shadow_soft);
  return out;
}

device::GroundData narrowed_ground(const physics::GroundData& g) {
  device::GroundData out{};
  out.shape.pole = narrowed(g.shape.pole);
  out.shape.greenwich = narrowed(g.shape.greenwich);
  out.shape.east = narrowed(g.shape.east);
  out.shape.albedo_rows = g.shape.albedo_rows;
  out.shape.albedo_levels = g.shape.albedo_levels;
  out.shape.water_rows = g.shape.water_rows;
  out.shape.water_levels = g.shape.water_levels;
  out.shape.slope_variance = narrowed(g.shape.slope_variance);
  std::ranges::copy(g.albedo_first, std::begin(out.albedo_first));
  std::ranges::copy(g.water_first, std::begin(out.water_first));
  std::ranges::transform(g.glint_share, std::begin(out.glint_share), [](double x) { return narrowed(x); });
  return out;
}

// The bytes of a structure, and of values behind it.
template <class Head, class Values>
std::vector<std::byte> bytes_with(const Head& head, const Values& values) {
  std::vector<std::byte> bytes = bytes_of_one(head);
  const std::vector<std::byte> more = bytes_of(values);
  bytes.insert(bytes.end(), more.begin(), more.end());
  return bytes;
}

// A terrain whose maps are a texel each.
std::shared_ptr<const physics::HostTerrain> no_terrain() {
  return std::make_shared<const physics::HostTerrain>(
      physics::HostTerrain{physics::TerrainData{}, std::make_shared<const std::vector<float>>(1, 0.0F),
                           std::vector<physics::uint>(1), std::make_shared<const std::vector<physics::uint>>(1)});
}

std::shared_ptr<const physics::HostGround> no_ground_maps() {
  const auto texel = std::make_shared<const std::vector<physics::uint>>(1);
  return std::make_shared<const physics::HostGround>(physics::HostGround{physics::GroundData{}, texel, texel});
}

// The texts of large buffers are made when they are needed.
std::vector<Binding> add_terrain(Plan& plan, std::shared_ptr<const physics::HostTerrain> terrain) {
  terrain = terrain == nullptr ? no_terrain() : std::move(terrain);
  const auto heights = [terrain] { return bytes_with(narrowed_shape(terrain->shape), *terrain->heights); };
  const auto shadows = [terrain] { return bytes_of(*terrain->shadows); };
  return {{"terrain",
           plan.add_shared_buffer({.name = "terrain",
                                   .bytes = sizeof(device::TerrainData) + terrain->heights->size() * sizeof(float),
                                   .contents_when_run = heights})},
          {"terrain_shadows", plan.add_shared_buffer({.name = "terrain_shadows",
                                                      .bytes = terrain->shadows->size() * sizeof(physics::uint),
                                                      .contents_when_run = shadows})},
          {"terrain_colours", plan.add_buffer_once(filled_buffer("terrain_colours", bytes_of(terrain->colours)))}};
}

template <class Data>
Binding add_bodies(Plan& plan, const char* name, const std::vector<Data>& bodies) {
  std::vector<decltype(narrowed(bodies.front()))> all;
  for (const Data& body : bodies) {
    all.push_back(narrowed(body));
  }
  const auto count = static_cast<device::uint>(all.size());
  return {name, plan.add_buffer_once(filled_buffer(name, bytes_with(count, all)))};
}

void append(std::vector<Binding>& all, std::vector<Binding> more) {
  std::ranges::move(more, std::back_inserter(all));
}

}  // namespace

std::vector<Binding> add_ground_maps(Plan& plan, const Scene& scene, const Things& things) {
  const auto maps = things.ground();
  const auto ground = maps == nullptr ? no_ground_maps() : maps;
  const std::string key = maps == nullptr ? "no ground maps" : ground_key(scene);
  const auto add = [&](const char* name, std::vector<std::byte> contents, const std::string& buffer_key) {
    return Binding{name, plan.add_buffer_once(filled_buffer(name, std::move(contents), buffer_key))};
  };
  return {add("ground_head", bytes_of_one(narrowed_ground(ground->head)), {}),
          add("ground_albedo", bytes_of(*ground->albedo), key + " albedo"),
          add("ground_water", bytes_of(*ground->water), key + " water")};
}

ThingInputs add_things(Plan& plan, const Scene& scene, const Things& things) {
  ThingInputs inputs;
  inputs.reads = add_terrain(plan, things.shadowed_terrain());
  append(inputs.reads, add_ground_maps(plan, scene, things));
  physics::uint bits = (scene.terrain ? physics::kHasTerrain : 0U) | (scene.ground ? physics::kHasGroundMaps : 0U);
#define BODY_KIND(Data, one, all, bit, place)                          \
  inputs.reads.push_back(add_bodies(plan, #all, things.bodies().all)); \
  bits |= things.bodies().all.empty() ? 0U : physics::bit;
  BODY_KINDS(BODY_KIND)
#undef BODY_KIND
  inputs.constants.push_back({"kThings", bits});
  return inputs;
}

PassDesc behind_things(Plan& plan, const Scene& scene, const Things& things, PassDesc pass) {
  if (things.stand_in_the_air()) {
    pass.shader += "_things";
    const ThingInputs inputs = add_things(plan, scene, things);
    pass.reads.insert(pass.reads.end(), inputs.reads.begin(), inputs.reads.end());
    pass.specialization.insert(pass.specialization.end(), inputs.constants.begin(), inputs.constants.end());
  }
  return pass;
}

}  // namespace airlight
