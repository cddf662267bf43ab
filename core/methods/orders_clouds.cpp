// Clouds in pictures by `orders`: the light in the cloud by discrete ordinates, once a sun, then a march through it for
// each pixel over the picture of the clear sky.

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <numeric>

#include "core/air/refraction.h"
#include "core/air/scene_block.h"
#include "core/clouds/cloud_grid.h"
#include "core/clouds/cloud_phase.h"
#include "core/error.h"
#include "core/luts/cloud_light.h"
#include "core/luts/luts.h"
#include "core/methods/orders_parts.h"
#include "core/methods/sky_pass.h"
#include "core/plan/bytes.h"
#include "core/text.h"

namespace airlight::orders {
namespace {

constexpr double kLeastSunHeight = 0.03;  // sine of the elevation: below it the sun's rays would cross many periods

// Toward the sun that is seen from the cloud, in its frame (x east, y north, z up).
physics::vec3 cloud_sun(const Scene& scene, const CloudGrid& cloud) {
  const double elevation = seen_elevation(scene.planet, 0.5 * (cloud.base + cloud.top), scene.sun.elevation);
  const double up = std::max(std::sin(elevation), kLeastSunHeight);
  const double across = std::sqrt(1.0 - up * up);
  return {across * std::sin(scene.sun.azimuth), across * std::cos(scene.sun.azimuth), up};
}

// A cloud that stands alone, in empty air all around, so that its shadow does not fall on its own repetition.
CloudGrid with_room(const CloudGrid& grid, physics::vec3 to_sun) {
  if (grid.repeats) {
    return grid;
  }
  const double reach = (grid.top - grid.base) * std::sqrt(1.0 - to_sun.z * to_sun.z) / to_sun.z;
  const double wide = std::min(reach, grid.nx * grid.cell_x);
  const double deep = std::min(reach, grid.ny * grid.cell_y);
  const int x = static_cast<int>(std::ceil(0.5 * wide / grid.cell_x)) + 1;
  const int y = static_cast<int>(std::ceil(0.5 * deep / grid.cell_y)) + 1;
  CloudGrid out = grid;
  out.nx = grid.nx + 2 * x;
  out.ny = grid.ny + 2 * y;
  out.west = grid.west - x * grid.cell_x;
  out.south = grid.south - y * grid.cell_y;
  out.extinction.assign(out.index(0, 0, out.nz), 0.0F);
  for (int k = 0; k < grid.nz; ++k) {
    for (int j = 0; j < grid.ny; ++j) {
      std::copy_n(&grid.extinction[grid.index(0, j, k)], grid.nx, &out.extinction[out.index(x, j + y, k)]);
    }
  }
  return out;
}

CloudCells cells_of(const CloudGrid& grid) {
  return {.nx = static_cast<std::uint32_t>(grid.nx),
          .ny = static_cast<std::uint32_t>(grid.ny),
          .nz = static_cast<std::uint32_t>(grid.nz),
          .cell_x = grid.cell_x,
          .cell_y = grid.cell_y,
          .cell_z = grid.cell_z(),
          .extinction = grid.extinction};
}

// The cloud's matter, as an air of its own that is empty.
struct Matter {
  CloudDrops drops;
  std::vector<device::vec3> phase;  // cloud_phase_rows()
};

Matter matter_of(const Cloud& cloud, const Part& part) {
  const Air air(
      {cloud_medium(cloud, part.scene.media.empty() ? Spectrum{} : part.scene.media.front().phase_wavelengths)},
      part.scene.planet);
  physics::Physics p = air.formulas();
  Matter matter{.drops = {.single_scattering_albedo = cloud.single_scattering_albedo, .legendre = {}}, .phase = {}};
  for (const physics::vec3& moment : p.scene.media[0].legendre) {
    matter.drops.legendre.push_back((moment.x + moment.y + moment.z) / 3.0);
  }
  matter.phase = cloud_phase_rows(p, cloud.single_scattering_albedo, kCloudDegree);
  return matter;
}

ImageId add_phase(Plan& plan, const Matter& matter) {
  constexpr Extent kExtent{physics::kPhaseSamples, physics::kCloudPeakRows, 1};
  const BufferId values = plan.add_buffer(filled_buffer("cloud_phase_values", bytes_of(matter.phase)));
  const ImageId image = plan.add_image({.name = "cloud_phase", .extent = kExtent});
  plan.add_pass({.shader = "cloud_phase",
                 .reads = {{"phase", values}},
                 .writes = {{"phase_out", image}},
                 .grid = kExtent,
                 .push_constants = {kExtent.width, kExtent.height}});
  return image;
}

// What the passes over a cloud read.
struct CloudInputs {
  BufferId head;
  ImageId density;
  ImageId gaps;
  ImageId shadow;
  ImageId mean = {};

  std::vector<Binding> reads() const {
    return {{"cloud_data", head}, {"cloud_density_lut", density}, {"cloud_shadow_lut", shadow}};
  }
};

CloudCells coarse_cells(const CloudGrid& grid, TableSize most) {
  const auto across = static_cast<std::uint32_t>(most[0]);
  return coarsened(means_between(cells_of(grid)), across, across, static_cast<std::uint32_t>(most[1]));
}

device::CloudData head_of(const CloudGrid& grid, const CloudCells& coarse, const Cloud& cloud, double scale,
                          physics::vec3 to_sun) {
  device::CloudData head{};
  head.fine_x = static_cast<device::uint>(grid.nx);
  head.fine_y = static_cast<device::uint>(grid.ny);
  head.fine_z = static_cast<device::uint>(grid.nz);
  head.coarse_x = coarse.nx;
  head.coarse_y = coarse.ny;
  head.coarse_z = coarse.nz;
  head.repeats = grid.repeats ? 1 : 0;
  head.west = narrowed(grid.west);
  head.south = narrowed(grid.south);
  head.width = narrowed(grid.nx * grid.cell_x);
  head.depth = narrowed(grid.ny * grid.cell_y);
  head.base = narrowed(grid.base);
  head.top = narrowed(grid.top);
  head.scale = narrowed(scale);
  head.albedo = narrowed(cloud.single_scattering_albedo);
  head.sunward_east = narrowed(to_sun.x / to_sun.z);
  head.sunward_north = narrowed(to_sun.y / to_sun.z);
  head.edge = {.tiles = narrowed(grid.edge.tiles),
               .tile_levels = narrowed(grid.edge.tile_levels),
               .carving = narrowed(grid.edge.carving),
               .soft = narrowed(grid.edge.soft),
               .low = narrowed(grid.edge.low),
               .high = narrowed(grid.edge.high)};
  return head;
}

BufferId add_values(Plan& plan, const std::string& name, Extent cells, std::function<std::vector<std::byte>()> values) {
  return plan.add_buffer({.name = name,
                          .bytes = std::size_t{cells.width} * cells.height * cells.depth * sizeof(float),
                          .contents_when_run = std::move(values)});
}

// Values of cells as an image that repeats itself in x and y, its second component of other values; `key` names it.
ImageId add_cells(Plan& plan, const std::string& name, Extent cells, BufferId values, BufferId second,
                  const std::string& key) {
  const Extent extent{cells.width + 1, cells.height + 1, cells.depth};
  const ImageId image = plan.add_image({.name = name,
                                        .extent = extent,
                                        .key = key,
                                        .half = true,
                                        .components = values == second ? 1U : 2U,
                                        .shared = true});
  plan.add_pass({.name = name,
                 .shader = "cloud_density",
                 .reads = {{"extinction", values}, {"inside", second}},
                 .writes = {{"density_out", image}},
                 .grid = extent,
                 .push_constants = {cells.width, cells.height, cells.depth}});
  return image;
}

ImageId add_density(Plan& plan, const std::shared_ptr<const CloudGrid>& grid, const std::string& cloud) {
  const std::string key = cloud + " density";
  if (const auto made = plan.shared_image(key)) {
    return *made;
  }
  const Extent cells{static_cast<std::uint32_t>(grid->nx), static_cast<std::uint32_t>(grid->ny),
                     static_cast<std::uint32_t>(grid->nz)};
  const BufferId means = add_values(plan, "cloud_density_values", cells, [grid] { return bytes_of(grid->extinction); });
  const BufferId inside =
      grid->inside.empty() ? means : add_values(plan, "cloud_inside", cells, [grid] { return bytes_of(grid->inside); });
  return add_cells(plan, "cloud_density", cells, means, inside, key);
}

// The noise that carves the edge; its first level is the last once more, as columns and rows are.
ImageId add_noise(Plan& plan, const std::shared_ptr<const CarvingNoise>& noise) {
  const std::string key = "cloud noise";
  if (const auto made = plan.shared_image(key)) {
    return *made;
  }
  constexpr std::uint32_t kSide = CarvingNoise::kSide;
  constexpr Extent kCells{kSide, kSide, kSide + 1};
  const BufferId values = add_values(plan, "cloud_noise_values", kCells, [noise] {
    std::vector<float> texels(noise->values.end() - kSide * kSide, noise->values.end());
    texels.insert(texels.end(), noise->values.begin(), noise->values.end());
    return bytes_of(texels);
  });
  return add_cells(plan, "cloud_noise", kCells, values, values, key);
}

// Where a ray need not look for water, on cells of twice the grid's.
ImageId add_gaps(Plan& plan, const std::shared_ptr<const CloudGrid>& grid, const std::string& cloud) {
  const std::string key = cloud + " gaps";
  if (const auto made = plan.shared_image(key)) {
    return *made;
  }
  const auto half = [](int count) { return static_cast<std::uint32_t>(count + 1) / 2; };
  const Extent cells{half(grid->nx), half(grid->ny), std::max(half(grid->nz), 2U)};
  const BufferId gaps = add_values(plan, "cloud_gap_values", cells, [grid, cells] {
    CloudCells fine = cells_of(*grid);
    for (std::size_t at = 0; at < grid->inside.size(); ++at) {
      fine.extinction[at] += std::max(grid->inside[at], 0.0F);
    }
    return bytes_of(gaps_of(coarsened(fine, cells.width, cells.height, cells.depth)));
  });
  return add_cells(plan, "cloud_gap", cells, gaps, gaps, key);
}

// What reads the edge of a cloud's water (shaders/shared/cloud_carved.glsl).
struct EdgeInputs {
  Binding noise;
  Specialization carved;
};

// `any`: an image to bind where the edge is not carved.
EdgeInputs add_edge(Plan& plan, const CloudGrid& grid, ImageId any) {
  const bool carved = grid.edge.tiles > 0.0;
  return {{"cloud_noise_lut", carved ? add_noise(plan, grid.noise) : any}, {"kCarved", carved ? 1U : 0U}};
}

// The table of the depth toward the sun. Low suns need more slices: the rays cross more cells from one to the next.
ImageId add_shadow(Plan& plan, const CloudGrid& grid, const CloudInputs& inputs, const device::CloudData& head,
                   const std::string& cloud) {
  constexpr double kMostCells = 1.2;  // across, that a ray crosses from slice to slice
  constexpr double kScales = 20.0;  // the scale is rounded, so that wavelengths whose drops differ little share a table
  const double scale = std::max(std::round(static_cast<double>(head.scale) * kScales), 1.0) / kScales;
  const double across =
      grid.cell_z() * std::max(std::abs(head.sunward_east) / grid.cell_x, std::abs(head.sunward_north) / grid.cell_y);
  const EdgeInputs edge = add_edge(plan, grid, inputs.density);
  const bool carved = edge.carved.value == 1;
  const auto finer = carved ? static_cast<std::uint32_t>(std::clamp(std::ceil(across / kMostCells), 1.0, 3.0)) : 1U;
  const auto parts = static_cast<std::uint32_t>(
      std::clamp(std::ceil((carved ? 2.0 * std::max(across, 1.0) : across) / finer), 1.0, 8.0));
  const std::string key = cloud + " shadow " + shortest(static_cast<double>(head.sunward_east)) + " " +
                          shortest(static_cast<double>(head.sunward_north)) + " " + shortest(carved ? scale : 1.0);
  if (const auto made = plan.shared_image(key)) {
    return *made;
  }
  const Extent size{head.fine_x + 1, head.fine_y + 1, finer * head.fine_z + 1};
  const ImageId depths = plan.add_image({.name = "cloud_sun_depth", .extent = size});
  plan.add_pass({.shader = "cloud_shadow",
                 .reads = {{"cloud_data", inputs.head},
                           {"cloud_density_lut", inputs.density},
                           {"cloud_gap_lut", inputs.gaps},
                           edge.noise},
                 .writes = {{"shadow_out", depths}},
                 .grid = {size.width, size.height, 1},
                 .push_constants = {parts, push_constant(scale)},
                 .specialization = {edge.carved},
                 .cost = (carved ? 8.0 : 1.0) * size.depth * parts});
  const ImageId shadow =
      plan.add_image({.name = "cloud_shadow", .extent = size, .key = key, .half = true, .shared = true});
  plan.add_pass(
      {.shader = "cloud_bends", .reads = {{"depths_lut", depths}}, .writes = {{"bends_out", shadow}}, .grid = size});
  return shadow;
}

CloudInputs add_inputs(Plan& plan, const std::shared_ptr<const CloudGrid>& grid, const device::CloudData& head,
                       const std::string& key, const std::string& sun_key) {
  CloudInputs inputs{};
  inputs.head = plan.add_buffer(filled_buffer("cloud", bytes_of_one(head)));
  inputs.density = add_density(plan, grid, key);
  inputs.gaps = add_gaps(plan, grid, key);
  inputs.shadow = add_shadow(plan, *grid, inputs, head, key);
  constexpr Extent kSlopes{physics::kCloudMeanRows, 1, 1};
  inputs.mean = plan.add_image({.name = "cloud_mean", .extent = kSlopes, .key = sun_key + " mean", .stored = true});
  plan.add_pass({.shader = "cloud_mean",
                 .reads = {{"cloud_data", inputs.head}, {"cloud_density_lut", inputs.density}},
                 .writes = {{"mean_out", inputs.mean}},
                 .grid = {64 * kSlopes.width, 1, 1},
                 .cost = 1000.0});
  return inputs;
}

BufferId add_beam(Plan& plan, const CloudInputs& inputs, const CloudCells& coarse, const std::string& key) {
  const auto count = static_cast<std::uint32_t>(coarse.count());
  const BufferId beam =
      plan.add_buffer({.name = "cloud_beam", .bytes = count * sizeof(float), .key = key + " beam", .zeroed = false});
  plan.add_pass({.shader = "cloud_beam",
                 .reads = inputs.reads(),
                 .writes = {{"beam_out", beam}},
                 .grid = {count, 1, 1},
                 .cost = 10.0});
  return beam;
}

// The light in the cloud. That of sky and ground is smooth: cells of twice the size do.
struct Fields {
  CloudCells cells;
  CloudCells coarser;
  CloudTables tables;
  CloudField sun;
  CloudField sky;
  CloudField ground;
};

ImageId add_sources(Plan& plan, const Fields& fields, const std::string& key) {
  constexpr std::uint32_t kBlocks = 4;
  const CloudCells& cells = fields.cells;
  const Extent extent{(cells.nx + 1) * kBlocks, cells.ny + 1, cells.nz};
  const ImageId sources =
      plan.add_image({.name = "cloud_source", .extent = extent, .key = key + " sources", .stored = true});
  plan.add_pass(
      {.shader = "cloud_source",
       .reads = {{"scattering", fields.tables.scattering},
                 {"cells", fields.sun.cells},
                 {"sun", fields.sun.moments},
                 {"sky", fields.sky.moments},
                 {"ground", fields.ground.moments}},
       .writes = {{"source_out", sources}},
       .grid = extent,
       .push_constants = {cells.nx, cells.ny, cells.nz, fields.coarser.nx, fields.coarser.ny, fields.coarser.nz}});
  return sources;
}

ImageId add_sums(Plan& plan, const CloudInputs& inputs, const Fields& fields, const std::string& key) {
  const ImageId sums =
      plan.add_image({.name = "cloud_sums", .extent = {4, 1, 1}, .key = key + " sums", .stored = true});
  std::vector<Binding> reads = inputs.reads();
  reads.insert(reads.end(), {{"ordinates", fields.tables.ordinates},
                             {"sun_planes", fields.sun.planes},
                             {"sky_planes", fields.sky.planes},
                             {"ground_planes", fields.ground.planes}});
  plan.add_pass({.shader = "cloud_sums",
                 .reads = std::move(reads),
                 .writes = {{"sums_out", sums}},
                 .grid = {256, 1, 1},
                 .push_constants = {fields.coarser.nx, fields.coarser.ny, fields.coarser.nz},
                 .cost = 400.0});
  return sums;
}

BufferId add_balance(Plan& plan, const Part& part, const Light& light, const CloudInputs& inputs, ImageId sums) {
  const BufferId balance = plan.add_buffer({.name = "cloud_balance", .bytes = sizeof(device::CloudLight)});
  std::vector<Specialization> constants = sunlight_specialization(plan, part.air, light.transmittance);
  add_moment_constants(constants, settings_of(part));
  std::vector<Binding> reads = inputs.reads();
  reads.insert(reads.end(), {{"cloud_mean_lut", inputs.mean},
                             {"cloud_sums_lut", sums},
                             {"transmittance_lut", light.transmittance},
                             {"moments_lut", light.moments}});
  plan.add_pass({.shader = "cloud_balance",
                 .reads = std::move(reads),
                 .writes = {{"light_out", balance}},
                 .grid = {1, 1, 1},
                 .specialization = std::move(constants)});
  return balance;
}

Fields add_fields(Plan& plan, const CloudCells& coarse, const CloudDrops& drops, const CloudInputs& inputs,
                  physics::vec3 to_sun, const std::string& key) {
  Fields fields{.cells = coarse, .coarser = {}, .tables = {}, .sun = {}, .sky = {}, .ground = {}};
  const CloudCells& cells = fields.cells;
  fields.coarser = coarsened(cells, (cells.nx + 1) / 2, (cells.ny + 1) / 2, (cells.nz + 1) / 2);
  fields.tables = add_cloud_tables(plan, drops, -to_sun);
  const BufferId beam = add_beam(plan, inputs, cells, key);
  const auto add = [&](const CloudCells& on, const CloudIncident& incident) {
    return add_cloud_field(plan, on, drops, incident, {}, fields.tables, beam, key);
  };
  fields.sun = add(cells, {.name = "sun", .sun = true});
  fields.sky = add(fields.coarser, {.name = "sky", .above = 1.0});
  fields.ground = add(fields.coarser, {.name = "ground", .below = 1.0});
  return fields;
}

// Of the light in a cloud: what its matter makes of it, the sun, the cells.
std::string sun_key_of(const std::string& cloud, const CloudDrops& drops, physics::vec3 to_sun, TableSize cells) {
  std::string key = cloud + " albedo " + shortest(drops.single_scattering_albedo) + " moments";
  for (std::size_t l = 1; l <= kCloudDegree + 1; ++l) {
    key += " " + shortest(drops.legendre.at(l));
  }
  return key + " sun " + shortest(to_sun.x) + " " + shortest(to_sun.y) + " cells " + std::to_string(cells[0]) + "x" +
         std::to_string(cells[1]);
}

// Whether rays next to each other in the picture's grid see much the same air. Seen from above the cloud, one that just
// misses it passes through air in the sun, and its neighbour through the shade in the cloud.
bool by_froxels(const Part& part, const View& view, double top) {
  const Projection projection = part.scene.camera.projection;
  return part.scene.camera.altitude < top && view.directions.empty() && projection != Projection::cube &&
         projection != Projection::octahedral;
}

// The share of the air's light that the cloud leaves, over the picture and distances.
ImageId add_air_shade(Plan& plan, const Part& part, const View& view, const Light& light, std::vector<Binding> reads,
                      const FactorTable& table) {
  constexpr std::uint32_t kSlices = 40;
  constexpr std::uint32_t kParts = 3;  // of a slice
  const Extent grid{froxels_over(part.scene.image.width), froxels_over(part.scene.image.height), kSlices};
  const ImageId shafts = plan.add_image(
      {.name = "cloud_shafts", .extent = grid, .key = picture_table_key(view, "cloud_shafts"), .half = true});
  std::vector<Specialization> constants = sunlight_specialization(plan, part.air, light.transmittance);
  add_volume_constants(constants, part.scene, table);
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

}  // namespace

void refuse_around_clouds(const Part& part, bool no_picture) {
  const Scene& scene = part.scene;
  if (scene.clouds.empty()) {
    return;
  }
  const auto refuse = [](bool holds, const std::string& what) {
    if (holds) {
      throw InputError("clouds: the method \"orders\" " + what +
                       ", or choose path-trace with render.method or --method");
    }
  };
  refuse(scene.clouds.size() > 1,
         "renders one cloud, and there are " + std::to_string(scene.clouds.size()) + "; remove all but one");
  refuse(!inside_the_air(scene),
         "renders clouds for a camera in the air, below planet.atmosphere_height_km; lower "
         "camera.altitude_km");
  refuse(std::ranges::count(scene.spheres, SphereMaterial::mirror, &Sphere::material) > 0,
         "renders no clouds in mirrors; remove the spheres of the material mirror or the clouds");
  refuse(scene.camera.polariser.has_value(), "renders no clouds through a polarising filter; remove it or the clouds");
  if (no_picture) {
    throw InputError(
        "clouds: the method \"orders\" renders them in pictures and irradiance, not yet in layers and composites; "
        "remove them");
  }
}

LitCloud add_cloud_light(Plan& plan, const Part& part, const Light& light) {
  const Cloud& cloud = part.scene.clouds.front();
  const physics::vec3 to_sun = cloud_sun(part.scene, *part.things.clouds().front());
  const auto grid = std::make_shared<const CloudGrid>(with_room(*part.things.clouds().front(), to_sun));
  const Matter matter = matter_of(cloud, part);
  const std::string key = "cloud " + cloud_key(cloud);
  const std::string sun_key = sun_key_of(key, matter.drops, to_sun, part.scene.render.get<TableSize>("cloud_lut"));
  const CloudCells coarse = coarse_cells(*grid, part.scene.render.get<TableSize>("cloud_lut"));
  LitCloud lit{.grid = grid,
               .key = key,
               .head = head_of(*grid, coarse, cloud, delta_scale(matter.drops), to_sun),
               .shade = {},
               .sources = {},
               .phase = {}};
  const CloudInputs inputs = add_inputs(plan, grid, lit.head, key, sun_key);
  const Fields fields = add_fields(plan, coarse, matter.drops, inputs, to_sun, sun_key);
  lit.sources = add_sources(plan, fields, sun_key);
  const BufferId balance = add_balance(plan, part, light, inputs, add_sums(plan, inputs, fields, sun_key));
  lit.phase = add_phase(plan, matter);
  lit.shade = inputs.reads();
  lit.shade.push_back({"cloud_mean_lut", inputs.mean});
  lit.shade.push_back({"cloud_light", balance});
  return lit;
}

void add_cloud(Plan& plan, const Part& part, const View& view, const SkyTarget& target, const Light& light,
               const LitCloud& cloud, const ThingsUnderCloud* things) {
  const FactorTable table = things != nullptr ? things->table : volume_table(part, true);
  std::vector<Binding> reads = cloud.shade;
  reads.push_back({"transmittance_lut", light.transmittance});
  std::vector<Specialization> constants = sunlight_specialization(plan, part.air, light.transmittance);
  add_moment_constants(constants, settings_of(part));
  std::vector<Binding> air;
  if (things != nullptr) {
    air = things->air;
    constants.insert(constants.end(), things->constants.begin(), things->constants.end());
  } else {
    air = add_volume(plan, part.scene, light, table, view).reads();
    add_volume_constants(constants, part.scene, table);
  }
  std::vector<Binding> clear = reads;
  std::ranges::copy_if(air, std::back_inserter(clear),
                       [](const Binding& read) { return read.name == "volume_lut" || read.name == "extinction_lut"; });
  const bool froxels = by_froxels(part, view, cloud.grid->top);
  reads.insert(reads.end(), air.begin(), air.end());
  reads.push_back({"cloud_shafts_lut", froxels ? add_air_shade(plan, part, view, light, clear, table) : cloud.sources});
  reads.push_back({"moments_lut", light.moments});
  reads.push_back({"cloud_source_lut", cloud.sources});
  reads.push_back({"cloud_gap_lut", add_gaps(plan, cloud.grid, cloud.key)});
  reads.push_back({"cloud_phase_lut", cloud.phase});
  const EdgeInputs edge = add_edge(plan, *cloud.grid, cloud.sources);
  reads.push_back(edge.noise);
  constants.push_back(edge.carved);
  reads.push_back({"directions", target.directions});
  constants.push_back({"kProjection", target.projection});
  constants.push_back({"kAirByRay", froxels ? 0U : 1U});
  const BufferId through =
      plan.add_buffer({.name = "cloud_transmittance",
                       .bytes = std::size_t{target.grid.width} * target.grid.height * sizeof(float),
                       .zeroed = false});
  constexpr double kStep = 1.5;  // in cells
  // Far away steps grow, and shorten again where the cloud is thick; one that is thin all over would never shorten
  // them, and steps of several cells make moire of its texture.
  constexpr double kThickest = 3.0;  // 1/km, scaled
  const CloudGrid& grid = *cloud.grid;
  const double densest =
      static_cast<double>(*std::ranges::max_element(grid.extinction)) * static_cast<double>(cloud.head.scale);
  const double rise = densest > kThickest ? 0.01 : 0.002;
  const double step = kStep * std::min({grid.cell_x, grid.cell_y, 2.0 * grid.cell_z()});
  plan.add_pass({.name = "clouds",
                 .shader = things != nullptr ? "cloud_pixels_things" : "cloud_pixels",
                 .reads = std::move(reads),
                 .writes = {{"radiance_out", target.radiance}, {"through_out", through}},
                 .grid = target.grid,
                 .push_constants = {target.grid.width, target.grid.height, target.vectors, push_constant(step),
                                    push_constant(rise)},
                 .specialization = std::move(constants),
                 .cost = 60.0});
}

}  // namespace airlight::orders
