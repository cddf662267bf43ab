// Clouds in pictures by `orders`: a march through each cloud for each pixel over the picture of the clear sky, or over
// that of the clouds behind it.

#include <algorithm>
#include <bit>
#include <cmath>
#include <iterator>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "core/air/scene_block.h"
#include "core/clouds/cloud_grid.h"
#include "core/luts/luts.h"
#include "core/methods/orders_cloud_tables.h"
#include "core/methods/orders_parts.h"
#include "core/methods/sky_pass.h"

namespace airlight::orders {
namespace {

// Whether rays next to each other in the picture's grid see much the same air. Froxels are lit by the balance of the
// highest field. Seen from above the lowest one, that one brightens the air, and each field's rays take their own:
// cumulus below cirrus would be 0.9 % too dark by froxels.
bool by_froxels(const Part& part, const View& view, const std::vector<LitCloud>& clouds) {
  const Projection projection = part.scene.camera.projection;
  return inside_the_air(part.scene) && view.directions.empty() && projection != Projection::cube &&
         projection != Projection::octahedral &&
         (clouds.size() == 1 || part.scene.camera.altitude < clouds.front().grid->top);
}

// Froxels over the picture. The share changes less from column to column than from row to row, of which each sees other
// heights and distances; a picture all around has few columns a degree. A small picture sees as much as a large one: it
// has as many froxels as a few hundred pixels have, or one a pixel.
Extent shaft_grid(const Scene& scene, std::uint32_t slices) {
  constexpr int kWider = 3;  // times the width of other froxels
  const auto fewest = [](int pixels) { return std::min(static_cast<std::uint32_t>(pixels) + 1, 64U); };
  const ImageSize& image = scene.image;
  const int across = scene.camera.projection == Projection::perspective ? image.width / kWider : image.width;
  return {std::max(froxels_over(across), fewest(image.width)),
          std::max(froxels_over(image.height), fewest(image.height)), slices};
}

// The share of the air's light that the cloud leaves, over the picture and distances.
ImageId add_air_shade(Plan& plan, const Part& part, const View& view, const Light& light, std::vector<Binding> reads,
                      const FactorTable& table, const LitCloud& highest) {
  constexpr std::uint32_t kSlices = 40;
  constexpr std::uint32_t kParts = 2;  // of a slice
  const Extent grid = shaft_grid(part.scene, kSlices);
  const ImageId shafts = plan.add_image(
      {.name = "cloud_shafts", .extent = grid, .key = picture_table_key(view, "cloud_shafts"), .half = true});
  std::vector<Specialization> constants = sunlight_specialization(plan, part.air, light.transmittance);
  add_moment_constants(constants, settings_of(part));
  add_volume_constants(constants, part.scene, table);
  constants.insert(constants.end(), highest.constants.begin(), highest.constants.end());
  constants.push_back({"kProjection", projection_code(part.scene.camera.projection)});
  plan.add_pass({.shader = "cloud_shafts",
                 .reads = std::move(reads),
                 .writes = {{"shafts_out", shafts}},
                 .grid = {grid.width, grid.height, 1},
                 .push_constants = {kParts},
                 .specialization = std::move(constants),
                 .cost = 4.0 * kSlices * kParts});
  return shafts;
}

// Of a picture of pixels, where not all rays through the clouds are marched.
struct Lattice {
  std::string shader;                     // cloud_lattice, or cloud_lattice_things
  Binding things;                         // things_seen, or any buffer
  std::vector<Specialization> constants;  // of cloud_fill
  BufferId rays = {};                     // LatticeRay of each
  BufferId list = {};                     // of pixels to march (shaders/shared/cloud_list.glsl)
};

// What the passes over a picture's clouds, its layers or the air before things have in common.
struct CloudPicture {
  std::string name = "clouds";
  std::string shader = {};
  std::optional<Lattice> lattice = {};
  std::vector<Binding> reads;
  std::vector<Binding> output = {};
  std::vector<Specialization> constants;
  Extent grid = {};
  std::vector<std::uint32_t> push = {};  // before what all push
  // Of the pass over pixels beside that of the lattice:
  std::vector<Binding> inputs = {};
  std::vector<Binding> more_output = {};
  std::vector<Specialization> more_constants = {};
};

// Whether pixels may stand between rays of a lattice: pixels next to each other are so in the sky.
bool has_lattice(const Scene& scene, const SkyTarget& target) {
  return scene.render.get<std::string>("cloud_resolution") == "half" &&
         target.projection != physics::kProjectionListed && target.projection != physics::kProjectionCube &&
         target.projection != physics::kProjectionOctahedral;
}

bool is_of_volume(const Binding& read) {
  return read.name == "volume_lut" || read.name == "extinction_lut";
}

// Texels of the map of clouds that mirrors show, each way: as many as the largest ball has pixels across. In the middle
// of a ball two of them are a pixel; with half as many, edges of clouds would be stairs near the horizon.
std::uint32_t map_side(const Scene& scene, const View& view) {
  constexpr double kListed = 256.0;
  constexpr double kFewest = 64.0;
  constexpr double kMost = 512.0;
  const Camera& camera = scene.camera;
  const double pixels = camera.projection == Projection::perspective
                            ? scene.image.height / (2.0 * std::tan(0.5 * camera.vertical_fov))
                            : scene.image.width / (2.0 * std::numbers::pi);  // a radian
  double widest = 0.0;
  for (const Sphere& sphere : scene.spheres) {
    const bool mirror = sphere.material == SphereMaterial::mirror;
    widest = std::max(widest, mirror ? 2.0 * std::asin(std::min(sphere.radius / sphere.distance, 1.0)) : 0.0);
  }
  const double side = view.directions.empty() ? widest * pixels : kListed;
  return static_cast<std::uint32_t>(std::clamp(side, kFewest, kMost));
}

// Without the output, which the caller adds. `projection`: kProjection.
CloudPicture picture_of_clouds(Plan& plan, const Part& part, const View& view, std::uint32_t projection,
                               const Light& light, const std::vector<LitCloud>& clouds,
                               const ThingsUnderCloud* things) {
  const LitCloud& highest = clouds.back();
  const FactorTable table = things != nullptr ? things->table : volume_table(part, true);
  CloudPicture picture{.reads = {{"transmittance_lut", light.transmittance}},
                       .constants = sunlight_specialization(plan, part.air, light.transmittance)};
  add_moment_constants(picture.constants, settings_of(part));
  std::vector<Binding> air;
  if (things != nullptr) {
    air = things->air;
    picture.constants.insert(picture.constants.end(), things->constants.begin(), things->constants.end());
  } else {
    air = add_volume(plan, part.scene, light, table, view, half_angle_of(part.scene, view)).reads();
    add_volume_constants(picture.constants, part.scene, table);
  }
  std::vector<Binding> clear = highest.shade;
  clear.push_back(picture.reads.front());
  std::ranges::copy_if(air, std::back_inserter(clear), is_of_volume);
  clear.push_back({"moments_lut", light.moments});
  const bool froxels = by_froxels(part, view, clouds);
  picture.reads.insert(picture.reads.end(), air.begin(), air.end());
  picture.reads.push_back(
      {"cloud_shafts_lut", froxels ? add_air_shade(plan, part, view, light, clear, table, highest) : highest.sources});
  picture.reads.push_back({"moments_lut", light.moments});
  picture.constants.push_back({"kProjection", projection});
  picture.constants.push_back({"kAirByRay", froxels ? 0U : 1U});
  return picture;
}

// What all clouds leave of a beam, over the picture's grid; `read`: whether the host reads it.
Binding add_through(Plan& plan, Extent grid, bool read) {
  return {"through_out", plan.add_buffer({.name = std::string(kCloudTransmittance),
                                          .bytes = std::size_t{grid.width} * grid.height * sizeof(float),
                                          .host_readable = read,
                                          .zeroed = false})};
}

// A pass over the picture: a cloud, and which of its two stretches along a ray (kStretches).
struct CloudTurn {
  std::size_t cloud;
  std::uint32_t stretches;
};

// From far to near, along every ray of a camera at altitude h. A ray that dips crosses clouds below the camera on its
// way down, and once more on its way up: one that stands between the camera and a lower cloud is both behind and before
// the lower one.
std::vector<CloudTurn> turns_of(const std::vector<LitCloud>& clouds, double h) {
  constexpr std::uint32_t kBoth = 0;
  constexpr std::uint32_t kNearer = 1;
  constexpr std::uint32_t kFarther = 2;
  std::vector<CloudTurn> turns;
  for (std::size_t i = clouds.size() - 1; i > 0; --i) {
    turns.push_back({i, clouds[i].grid->base < h ? kFarther : kBoth});
  }
  turns.push_back({0, kBoth});
  for (std::size_t i = 1; i < clouds.size() && clouds[i].grid->base < h; ++i) {
    turns.push_back({i, kNearer});
  }
  return turns;
}

// What the passes over one cloud read beside its light.
struct CloudSearch {
  ImageId gaps;
  EdgeInputs edge;
};

constexpr double kRayCost = 60.0;  // of a march

template <typename T>
std::vector<T> joined(std::vector<T> some, const std::vector<T>& more) {
  some.insert(some.end(), more.begin(), more.end());
  return some;
}

Extent lattice_of(Extent picture) {
  return {picture.width / 2 + 2, picture.height / 2 + 2, 1};
}

// `projection`: kProjection. One cloud of a picture after the other is put in by the same buffers.
Lattice add_lattice(Plan& plan, const Part& part, std::uint32_t projection, Extent picture, Binding any,
                    const ThingsUnderCloud* things) {
  const bool among_things = things != nullptr;
  Lattice lattice{.shader = among_things ? "cloud_lattice_things" : "cloud_lattice",
                  .things = {"seen", among_things ? ResourceId(things->seen) : any.resource},
                  .constants = joined(medium_specialization(part.air),
                                      {{"kProjection", projection}, {"kAmongThings", among_things ? 1U : 0U}})};
  constexpr std::size_t kRayBytes = 11 * sizeof(float);
  const Extent grid = lattice_of(picture);
  lattice.rays =
      plan.add_buffer({.name = "cloud_lattice", .bytes = kRayBytes * grid.width * grid.height, .zeroed = false});
  lattice.list = plan.add_buffer({.name = "cloud_list",
                                  .bytes = sizeof(std::uint32_t) * (4 + std::size_t{picture.width} * picture.height),
                                  .zeroed = false});
  return lattice;
}

// Rays of the lattice, and the pixels between them; the others are listed.
void add_lattice_passes(Plan& plan, const CloudPicture& picture, const LitCloud& cloud, bool further) {
  constexpr double kContrast = 0.15;
  const Lattice& lattice = *picture.lattice;
  plan.add_pass({.name = "cloud_lattice",
                 .shader = lattice.shader,
                 .reads = picture.reads,
                 .writes = {{"cloud_lattice", lattice.rays}, {"cloud_list", lattice.list}},
                 .grid = lattice_of(picture.grid),
                 .push_constants = picture.push,
                 .specialization = picture.constants,
                 .cost = kRayCost});
  plan.add_pass({.name = "cloud_fill",
                 .shader = "cloud_fill",
                 .reads = {{"cloud_lattice", lattice.rays}, lattice.things},
                 .writes = joined(picture.output, {{"cloud_list", lattice.list}}),
                 .grid = picture.grid,
                 .push_constants = {picture.grid.width, picture.grid.height, push_constant(kContrast),
                                    push_constant(static_cast<double>(cloud.head.scale))},
                 .specialization = joined(lattice.constants, {{"kFurther", further ? 1U : 0U}})});
}

void add_cloud_pass(Plan& plan, CloudPicture picture, const LitCloud& cloud, const CloudSearch& search,
                    std::uint32_t stretches, bool further) {
  std::vector<Binding>& reads = picture.reads;
  reads.insert(reads.end(), cloud.shade.begin(), cloud.shade.end());
  reads.insert(reads.end(), {{"cloud_source_lut", cloud.sources},
                             {"cloud_gap_lut", search.gaps},
                             {"cloud_phase_lut", cloud.phase},
                             search.edge.noise});
  std::vector<Specialization>& constants = picture.constants;
  constants.insert(constants.end(), cloud.constants.begin(), cloud.constants.end());
  constants.push_back(search.edge.carved);
  constants.push_back({"kStretches", stretches});
  constants.push_back({"kFurther", further ? 1U : 0U});
  constexpr double kStep = 1.5;  // in cells
  // Far away steps grow, and shorten again where the cloud is thick. One that is thin all over would never shorten
  // them, and steps of several cells make moire of its texture.
  constexpr double kRise = 0.01;
  constexpr double kThinRise = 0.002;
  const CloudGrid& grid = *cloud.grid;
  picture.push.push_back(push_constant(kStep * std::min({grid.cell_x, grid.cell_y, 2.0 * grid.cell_z()})));
  picture.push.push_back(push_constant(cloud.head.thin == 1 ? kThinRise : kRise));
  std::optional<GroupCount> groups;
  if (picture.lattice) {
    add_lattice_passes(plan, picture, cloud, further);
    reads.push_back({"cloud_list", picture.lattice->list});
    groups = {picture.lattice->list, 0};
  }
  plan.add_pass({.name = std::move(picture.name),
                 .shader = std::move(picture.shader),
                 .reads = joined(std::move(reads), picture.inputs),
                 .writes = joined(std::move(picture.output), picture.more_output),
                 .grid = picture.grid,
                 .push_constants = std::move(picture.push),
                 .specialization = joined(std::move(constants), picture.more_constants),
                 .cost = kRayCost,
                 .groups = groups});
}

void add_cloud_passes(Plan& plan, const Part& part, const CloudPicture& picture, const std::vector<LitCloud>& clouds) {
  std::vector<CloudSearch> searches;
  for (const LitCloud& cloud : clouds) {
    plan.tell_apart(cloud.name);
    searches.push_back({add_gaps(plan, cloud.grid, cloud.key), add_edge(plan, *cloud.grid, cloud.sources)});
    plan.tell_apart("");
  }
  bool further = false;
  for (const CloudTurn& turn : turns_of(clouds, part.scene.camera.altitude)) {
    const LitCloud& cloud = clouds[turn.cloud];
    plan.tell_apart(cloud.name);
    add_cloud_pass(plan, picture, cloud, searches[turn.cloud], turn.stretches, further);
    plan.tell_apart("");
    further = true;
  }
}

}  // namespace

std::vector<StandingCloud> standing_clouds(const Part& part) {
  const std::vector<std::shared_ptr<const CloudGrid>> grids = part.things.clouds();
  std::vector<StandingCloud> all;
  for (std::size_t i = 0; i < grids.size(); ++i) {
    all.push_back({&part.scene.clouds[i], grids[i]});
  }
  std::ranges::stable_sort(all, {}, [](const StandingCloud& cloud) { return cloud.grid->base; });
  const auto empty = [](const StandingCloud& cloud) {
    return std::ranges::none_of(cloud.grid->extinction, [](float x) { return x > 0.0F; });
  };
  while (all.size() > 1) {
    const auto found = std::ranges::find_if(all, empty);
    if (found == all.end()) {
      break;
    }
    all.erase(found);
  }
  return all;
}

void add_clouds(Plan& plan, const Part& part, const View& view, const SkyTarget& target, const Light& light,
                const std::vector<LitCloud>& clouds, const ThingsUnderCloud* things) {
  CloudPicture picture = picture_of_clouds(plan, part, view, target.projection, light, clouds, things);
  picture.shader = things != nullptr ? "cloud_pixels_things" : "cloud_pixels";
  picture.output = {{"radiance_out", target.radiance}, add_through(plan, target.grid, false)};
  picture.inputs = {{"directions", target.directions}};
  if (things != nullptr) {
    picture.more_output = {{"seen", things->seen}};
  }
  if (has_lattice(part.scene, target)) {
    picture.lattice =
        add_lattice(plan, part, target.projection, target.grid, {"directions", target.directions}, things);
  } else {
    picture.inputs.push_back({"cloud_list", target.directions});
  }
  picture.more_constants = {{"kFromList", picture.lattice ? 1U : 0U}};
  picture.grid = target.grid;
  picture.push = {target.grid.width, target.grid.height, target.vectors};
  add_cloud_passes(plan, part, picture, clouds);
}

BufferId add_cloud_map(Plan& plan, const Part& part, const View& view, const Light& light,
                       const std::vector<LitCloud>& clouds, const ThingsUnderCloud& air) {
  constexpr std::size_t kRayBytes = 8 * sizeof(float);  // CloudMapRay
  const std::uint32_t side = map_side(part.scene, view);
  const BufferId map = plan.add_buffer({.name = "cloud_map", .bytes = kRayBytes * side * side, .zeroed = false});
  CloudPicture picture{.name = "cloud_map",
                       .shader = "cloud_map",
                       .reads = {{"transmittance_lut", light.transmittance},
                                 {"cloud_shafts_lut", clouds.back().sources},
                                 {"moments_lut", light.moments}},
                       .output = {{"cloud_map", map}},
                       .constants = sunlight_specialization(plan, part.air, light.transmittance),
                       .grid = {side, side, 1},
                       .push = {side, side, 1}};
  std::ranges::copy_if(air.air, std::back_inserter(picture.reads), is_of_volume);
  add_moment_constants(picture.constants, settings_of(part));
  add_volume_constants(picture.constants, part.scene, air.table);
  picture.constants.push_back({"kProjection", projection_code(part.scene.camera.projection)});
  picture.constants.push_back({"kAirByRay", 1});
  add_cloud_passes(plan, part, picture, clouds);
  return map;
}

void add_clouds_to_layers(Plan& plan, const Part& part, const View& view, const Light& light, BufferId planes) {
  const std::vector<LitCloud> clouds = add_cloud_light(plan, part, light);
  const std::uint32_t projection = projection_code(part.scene.camera.projection);
  CloudPicture picture = picture_of_clouds(plan, part, view, projection, light, clouds, nullptr);
  const auto media = static_cast<std::uint32_t>(std::popcount(part.air.scattering_media()));
  picture.shader = "cloud_layers";
  picture.grid = picture_grid(part.scene, view);
  picture.output = {{"layers_out", planes}, add_through(plan, picture.grid, true)};
  picture.constants.push_back({"kAirLayers", media + 1});
  picture.constants.push_back({"kStokesLayers", view.stokes ? 2U : 0U});
  picture.push = {picture.grid.width, picture.grid.height};
  add_cloud_passes(plan, part, picture, clouds);
}

void add_clouds_to_spans(Plan& plan, const Part& part, const View& view, const Light& light, const SpanInput& spans,
                         BufferId air) {
  const std::vector<LitCloud> clouds = add_cloud_light(plan, part, light);
  const std::uint32_t projection = projection_code(part.scene.camera.projection);
  CloudPicture picture = picture_of_clouds(plan, part, view, projection, light, clouds, nullptr);
  picture.shader = "cloud_spans";
  picture.grid = spans.grid();
  picture.reads.push_back({"spans", spans.list});
  picture.output = {{"air_out", air}};
  picture.constants.push_back({"kWholeRows", spans.whole_rows ? 1U : 0U});
  picture.push = {spans.columns, spans.count, spans.first_row};
  add_cloud_passes(plan, part, picture, clouds);
}

}  // namespace airlight::orders
