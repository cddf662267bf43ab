// Pictures of things by `orders`: surfaces first, then the air up to them by tables, or by a march along each ray.

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "core/air/scene_block.h"
#include "core/base/error.h"
#include "core/luts/luts.h"
#include "core/methods/orders_parts.h"
#include "core/methods/spectral_sums.h"
#include "core/plan/bytes.h"
#include "core/things/thing_buffers.h"

namespace airlight::orders {
namespace {

bool by_tables(const Part& part, const View& view) {
  constexpr long long kEnough = 4096;  // pixels, about twice the volume's rays
  const std::string& choice = part.scene.render.get<std::string>("tabulate");
  const bool holds = (view.directions.empty() || view.as_picture) && inside_the_air(part.scene) &&
                     !far_mirror(part.scene) && stokes_of(part, view) == physics::kStokesNone &&
                     part.scene.render.get<std::string>("volumetric_shadows") != "march";
  const bool pays = part.scene.image.width * static_cast<long long>(part.scene.image.height) >= kEnough;
  return holds && (choice == "always" || (choice == "auto" && pays));
}

// Froxels hold for rays next to each other alone, hence not on maps that are cut, nor for listed rays.
bool has_cuts(const Part& part, const View& view) {
  const Projection projection = part.scene.camera.projection;
  return projection == Projection::cube || projection == Projection::octahedral || !view.directions.empty();
}

std::uint32_t shafts_of(const Part& part, const View& view) {
  const std::string& choice = part.scene.render.get<std::string>("volumetric_shadows");
  const bool cut = has_cuts(part, view);
  const std::uint32_t shadows = choice == "froxels" && !cut ? physics::kShaftsFroxels : physics::kShaftsExact;
  return choice == "false" ? physics::kShaftsNone : shadows;
}

constexpr std::uint32_t kFroxelSlices = 32;

ImageId add_shafts(Plan& plan, const Part& part, const View& view, const Volume& volume, const ThingInputs& things,
                   const FactorTable& table) {
  const Extent grid{froxels_over(part.scene.image.width), froxels_over(part.scene.image.height), kFroxelSlices};
  const ImageId shafts = plan.add_image(
      {.name = "thing_shafts", .extent = grid, .key = picture_table_key(view, "thing_shafts"), .half = true});
  std::vector<Binding> reads = volume.reads();
  reads.insert(reads.end(), things.reads.begin(), things.reads.end());
  std::vector<Specialization> constants = medium_specialization(part.air);
  add_volume_constants(constants, part.scene, table);
  constants.insert(constants.end(), things.constants.begin(), things.constants.end());
  constants.push_back({"kProjection", projection_code(part.scene.camera.projection)});
  plan.add_pass({.shader = "thing_shafts",
                 .reads = std::move(reads),
                 .writes = {{"shafts_out", shafts}},
                 .grid = {grid.width, grid.height, 1},
                 .specialization = std::move(constants),
                 .cost = 6.0 * kFroxelSlices});
  return shafts;
}

// How pixels learn what terrain leaves of the air's other light: froxels hold where those of shafts do.
std::uint32_t dimmed_of(const Part& part, const View& view) {
  if (!part.scene.terrain) {
    return physics::kDimmedNone;
  }
  return has_cuts(part, view) ? physics::kDimmedSteps : physics::kDimmedFroxels;
}

// Of a picture: in fog the share changes most from row to row, and with the distance.
constexpr std::uint32_t kDimmedColumnPixels = 16;
constexpr std::uint32_t kDimmedRowPixels = 8;
constexpr std::uint32_t kFewestDimmedColumns = 12;
constexpr std::uint32_t kFewestDimmedRows = 36;
constexpr std::uint32_t kMostDimmed = 96;  // each way
constexpr std::uint32_t kDimmedSlices = 48;

std::uint32_t dimmed_over(int pixels, std::uint32_t cell, std::uint32_t fewest) {
  return std::clamp((static_cast<std::uint32_t>(pixels) + cell - 1) / cell + 1, fewest, kMostDimmed);
}

ImageId add_dimmed(Plan& plan, const Part& part, const View& view, const Volume& volume, const ThingInputs& things,
                   const FactorTable& table, const ThingLight& among) {
  const ImageSize& image = part.scene.image;
  const Extent grid{dimmed_over(image.width, kDimmedColumnPixels, kFewestDimmedColumns),
                    dimmed_over(image.height, kDimmedRowPixels, kFewestDimmedRows), kDimmedSlices};
  const ImageId dimmed = plan.add_image(
      {.name = "thing_dimmed", .extent = grid, .key = picture_table_key(view, "thing_dimmed"), .half = true});
  std::vector<Binding> reads = volume.reads();
  reads.insert(reads.end(), things.reads.begin(), things.reads.end());
  reads.push_back({"shares_lut", among.shares});
  std::vector<Specialization> constants = medium_specialization(part.air);
  add_volume_constants(constants, part.scene, table);
  constants.insert(constants.end(), things.constants.begin(), things.constants.end());
  constants.push_back({"kProjection", projection_code(part.scene.camera.projection)});
  plan.add_pass({.shader = "thing_dimmed",
                 .reads = std::move(reads),
                 .writes = {{"dimmed_out", dimmed}},
                 .grid = {grid.width, grid.height, 1},
                 .specialization = std::move(constants),
                 .cost = 6.0 * kDimmedSlices});
  return dimmed;
}

// The pixels of a tile and those that its squares of blocks hold beside it (shaders/shared/thing_tile.glsl).
Extent grid_of_blocks(const Scene& scene, const View& view) {
  const Tile tile = tile_of(scene, view);
  const auto whole = [](int first, int count) {
    constexpr auto kSquare = static_cast<int>(physics::kThingSquare);
    return static_cast<std::uint32_t>((first % kSquare + count + kSquare - 1) / kSquare * kSquare);
  };
  return {whole(tile.x, tile.width), whole(tile.y, tile.height), 1};
}

std::vector<Specialization> block_constants(const Part& part, const ThingInputs& things) {
  std::vector<Specialization> constants = medium_specialization(part.air);
  constants.insert(constants.end(), things.constants.begin(), things.constants.end());
  constants.push_back({"kProjection", projection_code(part.scene.camera.projection)});
  constants.push_back({"kTiles", physics::kTilesAll});
  return constants;
}

// What the pixels' corners see; nothing where rays are listed.
BufferId add_corners(Plan& plan, const Part& part, const View& view, const ThingInputs& things) {
  if (!view.directions.empty()) {
    return plan.add_buffer(filled_buffer("thing_corners", bytes_of(std::vector<float>(2))));
  }
  const Extent pixels = grid_of_blocks(part.scene, view);
  const Extent grid{pixels.width + 1, pixels.height + 1, 1};
  const BufferId corners = plan.add_buffer(
      {.name = "thing_corners", .bytes = std::size_t{2} * sizeof(float) * grid.width * grid.height, .zeroed = false});
  plan.add_pass({.shader = "thing_corners",
                 .reads = things.reads,
                 .writes = {{"corners_out", corners}},
                 .grid = {(grid.width + 1) / 2, (grid.height + 1) / 2, 1},
                 .push_constants = {grid.width, grid.height},
                 .specialization = block_constants(part, things),
                 .cost = 50.0});
  return corners;
}

// What a pass over things reads, beside what it writes to.
struct ThingPass {
  std::vector<Binding> reads;
  std::vector<Specialization> constants;
  ThingInputs things;
  BufferId corners;
  std::uint32_t steps = 0;
  bool tables = false;
  ThingsUnderCloud air;  // by tables
};

std::uint32_t count_of_blocks(const Extent& pixels) {
  return pixels.width / physics::kThingBlock * (pixels.height / physics::kThingBlock);
}

// The list by which blocks of pixels are rendered (shaders/shared/thing_tiles.glsl).
BufferId add_list(Plan& plan, std::uint32_t count) {
  return plan.add_buffer(
      {.name = "thing_tiles", .bytes = sizeof(std::uint32_t) * (physics::kTileWords + std::size_t{2} * count)});
}

// What blocks of pixels show, the air up to that, and their list.
struct Blocks {
  BufferId shown;
  BufferId nodes;
  BufferId tiles;
};

// Over terrain.
Blocks add_known_air(Plan& plan, const Part& part, const View& view, const ThingPass& pass, const Light& light) {
  constexpr std::size_t kShown = 4 * sizeof(float);                    // ThingBlock
  constexpr std::size_t kNodes = std::size_t{12} * 6 * sizeof(float);  // AirNode
  constexpr std::uint32_t kThreads = 8;                                // a block
  constexpr std::uint32_t kAirThreads = 16;                            // a square
  const Extent pixels = grid_of_blocks(part.scene, view);
  const std::uint32_t count = count_of_blocks(pixels);
  const Blocks blocks{.shown = plan.add_buffer({.name = "thing_blocks", .bytes = kShown * count, .zeroed = false}),
                      .nodes = plan.add_buffer({.name = "thing_block_air", .bytes = kNodes * count, .zeroed = false}),
                      .tiles = add_list(plan, count)};
  std::vector<Binding> reads = pass.things.reads;
  reads.push_back({"corners", pass.corners});
  std::vector<Specialization> constants = block_constants(part, pass.things);
  constants.push_back({"kEdges", physics::kEdgesFound});
  plan.add_pass({.shader = "thing_blocks",
                 .reads = std::move(reads),
                 .writes = {{"blocks_out", blocks.shown}},
                 .grid = {kThreads * count, 1, 1},
                 .push_constants = {count},
                 .specialization = std::move(constants),
                 .cost = 25.0});
  reads = light.reads();
  reads.insert(reads.end(), pass.air.air.begin(), pass.air.air.end());
  reads.push_back({"blocks", blocks.shown});
  constants = light.constants;
  constants.insert(constants.end(), pass.air.constants.begin(), pass.air.constants.end());
  constants.push_back({"kProjection", projection_code(part.scene.camera.projection)});
  constants.push_back({"kEdges", physics::kEdgesLeftOut});
  constants.push_back({"kTiles", physics::kTilesAll});
  const BufferId squares =
      plan.add_buffer({.name = "thing_squares", .bytes = sizeof(std::uint32_t) * (std::size_t{4} + count / 4)});
  PassDesc air{.name = "thing_square_air",
               .shader = "thing_block_air",
               .reads = std::move(reads),
               .writes = {{"nodes_out", blocks.nodes}, {"tiles_out", blocks.tiles}, {"squares_out", squares}},
               .grid = {kAirThreads * count / 4, 1, 1},
               .push_constants = {count, 0},
               .specialization = std::move(constants),
               .cost = 40.0};
  plan.add_pass(air);
  air.name = "thing_block_air";
  air.push_constants[1] = 1;
  air.groups = GroupCount{squares, 0};
  plan.add_pass(std::move(air));
  return blocks;
}

// Without terrain, where rays ask for the air themselves.
Blocks add_bodies_aside(Plan& plan, const Part& part, const View& view, const ThingInputs& things, BufferId none) {
  const std::uint32_t count = count_of_blocks(grid_of_blocks(part.scene, view));
  const Blocks blocks{.shown = none, .nodes = none, .tiles = add_list(plan, count)};
  plan.add_pass({.shader = "thing_lists",
                 .reads = things.reads,
                 .writes = {{"tiles_out", blocks.tiles}},
                 .grid = {count, 1, 1},
                 .push_constants = {count},
                 .specialization = block_constants(part, things),
                 .cost = 1.0});
  return blocks;
}

bool has_mirrors(const Scene& scene) {
  return std::ranges::count(scene.spheres, SphereMaterial::mirror, &Sphere::material) > 0;
}

// The air among things by tables.
ThingsUnderCloud air_among(Plan& plan, const Part& part, const View& view, const Light& light,
                           const ThingInputs& things, const ThingLight& among) {
  ThingsUnderCloud air{.air = {}, .constants = {}, .table = unfolded_table(part)};
  // What a mirror shows may stand anywhere.
  const float half_angle = has_mirrors(part.scene) ? std::numbers::pi_v<float> : half_angle_of(part.scene, view);
  const Volume volume = add_volume(plan, part.scene, light, air.table, view, half_angle);
  const std::uint32_t shafts = shafts_of(part, view);
  const bool froxels = part.scene.terrain && shafts == physics::kShaftsFroxels;
  const ImageId share = froxels ? add_shafts(plan, part, view, volume, things, air.table) : volume.sources;
  const std::uint32_t dimmed = dimmed_of(part, view);
  air.air = volume.reads();
  air.air.push_back({"peaks_lut", volume.peaks});
  air.air.push_back({"shafts_lut", share});
  air.air.push_back({"dimmed_lut", dimmed == physics::kDimmedFroxels
                                       ? add_dimmed(plan, part, view, volume, things, air.table, among)
                                       : volume.sources});
  air.constants.push_back({"kDimmed", dimmed});
  add_volume_constants(air.constants, part.scene, air.table);
  air.constants.push_back({"kShafts", shafts});
  return air;
}

// The software device ends a shader's loops after 65535 turns of all of them together (nested.cpp): then rays of edges
// and mirrors that one thread takes lose their light.
void refuse_too_many_steps(const Scene& scene, bool mirrors) {
  const int most = mirrors ? 256 : 1024;
  const int steps = scene.render.get<int>("steps");
  if (steps > most) {
    throw InputError("render.steps: a march past " + std::string(mirrors ? "mirrors" : "terrain or spheres") +
                     " takes up to " + std::to_string(most) + ", not " + std::to_string(steps) + "; lower it");
  }
}

ThingPass pass_of(Plan& plan, const Part& part, const View& view, const Light& light, bool tables,
                  const std::vector<LitCloud>& clouds) {
  constexpr std::uint32_t kMirrorSegments = 6;
  ThingPass pass{.reads = light.reads(),
                 .constants = light.constants,
                 .things = add_things(plan, part.scene, part.things),
                 .corners = {},
                 .steps = steps_past_things(part, light),
                 .tables = tables,
                 .air = {}};
  const bool mirrors = has_mirrors(part.scene);
  pass.constants.push_back({"kEdges", physics::kEdgesFound});
  pass.constants.push_back({"kTiles", physics::kTilesAll});
  pass.constants.push_back({"kSegments", mirrors ? kMirrorSegments : 1U});
  pass.constants.push_back({"kDiscShows", part.scene.sun.disc.visible ? 1U : 0U});
  const ThingInputs& things = pass.things;
  pass.reads.insert(pass.reads.end(), things.reads.begin(), things.reads.end());
  pass.constants.insert(pass.constants.end(), things.constants.begin(), things.constants.end());
  const ThingLight among = add_thing_light(plan, part, light, things);
  const std::vector<Binding> shares = among.reads();
  pass.reads.insert(pass.reads.end(), shares.begin(), shares.end());
  pass.reads.push_back({"caps_lut", add_sky_caps(plan, part, light, things)});
  pass.corners = add_corners(plan, part, view, things);
  pass.reads.push_back({"corners", pass.corners});
  if (tables || !clouds.empty()) {
    pass.air = air_among(plan, part, view, light, things, among);
  }
  if (!clouds.empty()) {
    const LitCloud& highest = clouds.back();
    pass.reads.insert(pass.reads.end(), highest.shade.begin(), highest.shade.end());
    pass.reads.push_back(
        {"cloud_map", mirrors ? add_cloud_map(plan, part, view, light, clouds, pass.air) : pass.corners});
    pass.constants.insert(pass.constants.end(), highest.constants.begin(), highest.constants.end());
  }
  if (tables) {
    pass.reads.insert(pass.reads.end(), pass.air.air.begin(), pass.air.air.end());
    pass.constants.insert(pass.constants.end(), pass.air.constants.begin(), pass.air.constants.end());
  } else {
    refuse_too_many_steps(part.scene, mirrors);
    pass.constants.push_back({"kStokes", stokes_of(part, view)});
    pass.constants.push_back({"kShafts", march_shafts(part)});
  }
  pass.air.air.insert(pass.air.air.end(), things.reads.begin(), things.reads.end());
  pass.air.air.insert(pass.air.air.end(), shares.begin(), shares.end());
  pass.air.constants.insert(pass.air.constants.end(), things.constants.begin(), things.constants.end());
  return pass;
}

// The rays of a picture of things by blocks (shaders/shared/thing_list.glsl): blocks of the sky alone, then in two
// rounds those that are simple and all others.
class RaysByBlocks {
 public:
  // `pass`: over all pixels. `none`: a buffer of at least 8 words, bound where a pass reads none.
  RaysByBlocks(Plan& plan, PassDesc pass, const ThingPass& found, const Blocks& blocks, std::uint32_t count,
               bool terrain, bool clouds, BufferId none, const std::array<Rgb, 3>& colours)
      : plan_(plan),
        pass_(std::move(pass)),
        found_(found),
        blocks_(blocks),
        terrain_(terrain),
        under_(clouds ? "_clouds" : ""),
        none_(none),
        colours_(colours) {
    const std::size_t quads = std::size_t{16} * (clouds ? 5 : 4) * sizeof(float);  // QuadSeen, of a block
    constexpr std::size_t kUnits = std::size_t{4} * physics::kThingBlock * physics::kThingBlock;  // of a block at most
    quads_ = plan.add_buffer({.name = "thing_quads", .bytes = quads * count, .zeroed = false});
    units_ = plan.add_buffer({.name = "thing_units", .bytes = 8 * sizeof(std::uint32_t)});
    list_ = plan.add_buffer({.name = "thing_list", .bytes = sizeof(std::uint32_t) * kUnits * count, .zeroed = false});
  }

  void add(const std::vector<Specialization>& between) {
    // Costs together are predicted to be what one pass over all blocks costs.
    add_rays("sky", physics::kTilesOfSky, false, 0.1);
    add_rays("things", physics::kTilesOfThings, false, 0.2);
    add_rays("exact", physics::kTilesExact, false, 0.2);
    add_between("things_between", physics::kTilesOfThings, between);
    add_between("exact_between", physics::kTilesExact, between);
    add_rays("things_listed", physics::kTilesOfThings, true, 0.2);
    add_rays("exact_listed", physics::kTilesExact, true, 0.2);
  }

 private:
  void specialize(std::vector<Specialization>& constants, std::uint32_t tiles) const {
    for (Specialization& one : constants) {
      if (one.name == "kTiles") one.value = tiles;
      if (one.name == "kSegments" && tiles != physics::kTilesExact) one.value = 1;  // no mirror shows
      if (one.name == "kThings" && tiles != physics::kTilesExact && !terrain_) one.value |= physics::kBodiesAside;
      if (one.name == "kEdges" && tiles == physics::kTilesOfSky) one.value = physics::kEdgesLeftOut;
    }
  }

  // What the pass writes, its part of blocks of a kind.
  std::vector<Binding> own_writes(std::uint32_t tiles) const {
    std::vector<Binding> writes;
    std::ranges::transform(pass_.writes, std::back_inserter(writes),
                           [&](const Binding& write) { return own_part(write, tiles); });
    return writes;
  }

  // What blocks of a kind have of it: no block is of two.
  static Binding own_part(Binding whole, std::uint32_t tiles) {
    whole.parts = 1U << tiles;
    return whole;
  }

  GroupCount groups_of_blocks(std::uint32_t tiles) const { return {blocks_.tiles, 16U * (tiles - 1)}; }

  void add_rays(const char* name, std::uint32_t tiles, bool listed, double cost) {
    PassDesc one = pass_;
    one.name = name;
    one.shader = "thing_rays" + under_;
    one.groups = listed ? GroupCount{units_, 16U * (tiles - physics::kTilesOfThings)} : groups_of_blocks(tiles);
    one.reads.push_back(own_part({"rays_list", listed ? list_ : none_}, tiles));
    one.reads.push_back(own_part({"units", listed ? units_ : none_}, tiles));
    one.writes = own_writes(tiles);
    one.writes.push_back(own_part({"quads_out", quads_}, tiles));
    one.push_constants.push_back(listed ? 1 : 0);
    push_colours(one.push_constants, colours_);
    specialize(one.specialization, tiles);
    one.cost *= cost;
    plan_.add_pass(std::move(one));
  }

  void add_between(const char* name, std::uint32_t tiles, std::vector<Specialization> constants) {
    std::vector<Binding> reads = found_.things.reads;
    reads.insert(reads.end(), {{"corners", found_.corners}, {"tiles", blocks_.tiles}});
    reads.push_back(own_part({"quads", quads_}, tiles));
    reads.push_back(*std::ranges::find(pass_.reads, "directions", &Binding::name));
    specialize(constants, tiles);
    std::vector<std::uint32_t> push{pass_.push_constants[0], pass_.push_constants[1]};
    push_colours(push, colours_);
    std::vector<Binding> writes = own_writes(tiles);
    writes.push_back(own_part({"units_out", units_}, tiles));
    writes.push_back(own_part({"rays_list_out", list_}, tiles));
    plan_.add_pass({.name = name,
                    .shader = "thing_between" + under_,
                    .reads = std::move(reads),
                    .writes = std::move(writes),
                    .grid = pass_.grid,
                    .push_constants = std::move(push),
                    .specialization = std::move(constants),
                    .cost = 3.0,
                    .groups = groups_of_blocks(tiles)});
  }

  Plan& plan_;
  PassDesc pass_;
  const ThingPass& found_;
  Blocks blocks_;
  bool terrain_;
  std::string under_;  // what shaders' names end with
  BufferId none_;
  std::array<Rgb, 3> colours_;
  BufferId quads_;
  BufferId units_;
  BufferId list_;
};

}  // namespace

std::optional<std::size_t> far_mirror(const Scene& scene) {
  constexpr double kFarthest = 2.0;  // km
  constexpr double kHighest = 0.02;  // km over the camera or below it
  const auto found = std::ranges::find_if(scene.spheres, [](const Sphere& s) {
    const double aside = std::abs(s.distance * std::sin(s.elevation)) + s.radius;
    return s.material == SphereMaterial::mirror && !(s.distance < kFarthest && aside < kHighest);
  });
  if (found == scene.spheres.end()) return std::nullopt;
  return static_cast<std::size_t>(found - scene.spheres.begin());
}

bool lists_blocks(const Part& part, const View& view) {
  return by_tables(part, view) && (part.scene.terrain ? !has_cuts(part, view) : view.directions.empty());
}

ThingsUnderCloud add_things_sky(Plan& plan, const Part& part, const View& view, const SkyTarget& target,
                                const Light& light, const ThingsShown& shown) {
  constexpr std::size_t kSeen = 5 * sizeof(float);  // ThingsSeen
  const bool clouds = !shown.under.empty();
  const bool tables = clouds ? stokes_of(part, view) == physics::kStokesNone : by_tables(part, view);
  ThingPass found = pass_of(plan, part, view, light, tables, shown.under);
  found.reads.push_back({"directions", target.directions});
  found.constants.push_back({"kProjection", target.projection});
  PassDesc pass{.name = "sky",
                .shader = tables   ? "sky_things_tables"
                          : clouds ? "sky_things_march"
                                   : "sky_things",
                .reads = found.reads,
                .writes = {{"radiance_out", target.radiance}},
                .grid = target.grid,
                .push_constants = {target.grid.width, target.grid.height, found.steps},
                .specialization = found.constants,
                .cost = tables ? 40.0 : 3.0 * ray_cost(found.steps)};
  if (clouds) {
    pass.shader += "_clouds";
    found.air.seen = plan.add_buffer(
        {.name = "things_seen", .bytes = kSeen * target.grid.width * target.grid.height, .zeroed = false});
    pass.writes.push_back({"seen_out", found.air.seen});
  }
  if (!lists_blocks(part, view)) {
    assert(shown.colours == kAsTheyAre);
    plan.add_pass(std::move(pass));
    return found.air;
  }
  const bool terrain = part.scene.terrain.has_value();
  // Without terrain the air is cheaper to look up than to find between a block's corners.
  const BufferId none = plan.add_buffer(filled_buffer("no_blocks", bytes_of(std::vector<float>(8))));
  const Blocks blocks =
      terrain ? add_known_air(plan, part, view, found, light) : add_bodies_aside(plan, part, view, found.things, none);
  pass.reads.insert(pass.reads.end(), {{"tiles", blocks.tiles}, {"blocks", blocks.shown}, {"nodes", blocks.nodes}});
  std::vector<Specialization> between = block_constants(part, found.things);
  between.push_back({"kEdges", physics::kEdgesFound});
  const std::uint32_t count = count_of_blocks(grid_of_blocks(part.scene, view));
  RaysByBlocks(plan, std::move(pass), found, blocks, count, terrain, clouds, none, shown.colours).add(between);
  return found.air;
}

BufferId add_things_layers(Plan& plan, const Part& part, const View& view, const Light& light) {
  ThingPass found = pass_of(plan, part, view, light, by_tables(part, view), {});
  found.constants.push_back({"kProjection", projection_code(part.scene.camera.projection)});
  if (!found.tables) {
    found.constants.push_back({"kScatteringMedia", part.air.scattering_media()});
  }
  const Extent grid = picture_grid(part.scene, view);
  const BufferId planes = add_layer_planes(plan, part, view);
  plan.add_pass({.name = "layers",
                 .shader = found.tables ? "layers_things_tables" : "layers_things",
                 .reads = std::move(found.reads),
                 .writes = {{"layers_out", planes}},
                 .grid = grid,
                 .push_constants = {grid.width, grid.height, found.steps},
                 .specialization = std::move(found.constants)});
  return planes;
}

}  // namespace airlight::orders
