// The light in clouds for `orders`, by discrete ordinates, once a sun; and what clouds leave of the light around them.

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>
#include <vector>

#include "core/air/refraction.h"
#include "core/air/scene_block.h"
#include "core/base/text.h"
#include "core/clouds/cloud_grid.h"
#include "core/clouds/cloud_phase.h"
#include "core/gpu/kept_values.h"
#include "core/luts/cloud_light.h"
#include "core/luts/luts.h"
#include "core/methods/orders_cloud_tables.h"
#include "core/methods/orders_parts.h"
#include "core/plan/bytes.h"
#include "core/scene/cloud_file.h"

namespace airlight::orders {
namespace {

constexpr double kLeastSunHeight = 0.03;  // sine of the elevation: below it the sun's rays would cross many periods

// The sun where the clouds' light is found, in their frame there.
struct CloudSun {
  double elevation;  // rad
  double azimuth;
};

// Angle at the planet's centre, rad, from the point under the camera to the ground that the view's axis meets, or else
// to the axis's lowest point. Maps look down.
double way_round(const Scene& scene) {
  const Camera& camera = scene.camera;
  const double mu = std::sin(camera.pitch);
  if (is_map(camera.projection) || mu >= 0.0) {
    return 0.0;
  }
  const double r = scene.planet.ground_radius + camera.altitude;
  const double sigma = std::cos(camera.pitch);
  const double lowest = r * sigma;
  const double root =
      std::sqrt(std::max(scene.planet.ground_radius * scene.planet.ground_radius - lowest * lowest, 0.0));
  const double t = -r * mu - root;
  return std::atan2(t * sigma, r + t * mu);
}

// A camera inside the air sees clouds under the sun that it has itself. From space those in the middle of the picture
// have another one: the grid's frame stands there as if it had been moved along the ground.
CloudSun sun_over_clouds(const Scene& scene) {
  const Sun& sun = scene.sun;
  const double round = inside_the_air(scene) ? 0.0 : way_round(scene);
  if (round == 0.0) {
    return {sun.elevation, sun.azimuth};
  }
  const double turn = sun.azimuth - scene.camera.azimuth;
  const double across = std::cos(sun.elevation) * std::sin(turn);
  const double ahead = std::cos(sun.elevation) * std::cos(turn);
  const double up = std::sin(sun.elevation);
  const double there = ahead * std::cos(round) - up * std::sin(round);
  return {std::asin(std::clamp(up * std::cos(round) + ahead * std::sin(round), -1.0, 1.0)),
          scene.camera.azimuth + std::atan2(across, there)};
}

// Toward the sun that is seen from the cloud, in its frame (x east, y north, z up).
physics::vec3 cloud_sun(const Scene& scene, const CloudGrid& cloud) {
  const CloudSun sun = sun_over_clouds(scene);
  const double elevation = seen_elevation(scene.planet, 0.5 * (cloud.base + cloud.top), sun.elevation);
  const double up = std::max(std::sin(elevation), kLeastSunHeight);
  const double across = std::sqrt(1.0 - up * up);
  return {across * std::sin(sun.azimuth), across * std::cos(sun.azimuth), up};
}

// The cloud's matter, as an air of its own that is empty.
struct Matter {
  CloudDrops drops;
  std::vector<float> phase;  // cloud_phase_rows()
};

Matter matter_of(const Cloud& cloud, const Part& part) {
  const Spectrum channels = part.scene.media.empty() ? Spectrum{} : part.scene.media.front().phase_wavelengths;
  const Air air({cloud_medium(cloud, channels)}, part.scene.planet);
  physics::Physics p = air.formulas();
  Matter matter{.drops = {.single_scattering_albedo = cloud.single_scattering_albedo, .legendre = {}}, .phase = {}};
  for (const physics::vec3& moment : p.scene.media[0].legendre) {
    matter.drops.legendre.push_back((moment.x + moment.y + moment.z) / 3.0);
  }
  std::string key = "cloud phase " + std::to_string(static_cast<int>(cloud.phase));
  for (const double value :
       {cloud.phase_g, cloud.effective_radius, cloud.single_scattering_albedo, channels[0], channels[1], channels[2]}) {
    key += " " + shortest(value);
  }
  matter.phase = kept_floats(key, [&] {
    const std::vector<device::vec3> rows = cloud_phase_rows(p, cloud.single_scattering_albedo, kCloudDegree);
    std::vector<float> values(3 * rows.size());
    std::memcpy(values.data(), rows.data(), values.size() * sizeof(float));
    return values;
  });
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
  ImageId around = {};

  std::vector<Binding> reads() const {
    return {{"cloud_data", head}, {"cloud_density_lut", density}, {"cloud_shadow_lut", shadow}};
  }
};

// Whether a field is thin all over, and each cell of it: scaled by `scale`.
bool is_thin(const CloudGrid& grid, double scale) {
  constexpr double kThickest = 3.0;  // 1/km
  constexpr double kDeepest = 0.25;  // of a cell
  const double densest = static_cast<double>(*std::ranges::max_element(grid.extinction)) * scale;
  return densest <= kThickest && densest * std::max({grid.cell_x, grid.cell_y, grid.cell_z()}) <= kDeepest;
}

CloudCells coarse_cells(const CloudGrid& grid, TableSize most, const std::string& cloud) {
  CloudCells coarse = light_shape(grid, most);
  // A carved field's values are means already, since its water does not pass evenly from middle to middle.
  const CellValues values = grid.edge.tiles > 0.0 ? CellValues::means : CellValues::middles;
  coarse.extinction = kept_floats(key_on(key_on(cloud, shape_of(grid)) + " means", coarse), [&] {
    CloudCells fine = cells_of(grid);
    CloudCells means = coarsened(fine, coarse.nx, coarse.ny, coarse.nz, values);
    return with_lumps(std::move(means), std::move(fine), values).extinction;
  });
  return coarse;
}

device::CloudData head_of(const CloudGrid& grid, const CloudCells& coarse, const CloudDrops& drops,
                          physics::vec3 to_sun) {
  device::CloudData head{};
  head.fine_x = static_cast<device::uint>(grid.nx);
  head.fine_y = static_cast<device::uint>(grid.ny);
  head.fine_z = static_cast<device::uint>(grid.nz);
  head.coarse_x = coarse.nx;
  head.coarse_y = coarse.ny;
  head.coarse_z = coarse.nz;
  head.repeats = grid.repeats ? 1 : 0;
  head.thin = is_thin(grid, delta_scale(drops)) ? 1 : 0;
  head.west = narrowed(grid.west);
  head.south = narrowed(grid.south);
  head.width = narrowed(grid.nx * grid.cell_x);
  head.depth = narrowed(grid.ny * grid.cell_y);
  head.base = narrowed(grid.base);
  head.top = narrowed(grid.top);
  head.scale = narrowed(delta_scale(drops));
  head.turning = narrowed((1.0 - drops.single_scattering_albedo * drops.legendre.at(1)) / delta_scale(drops));
  head.albedo = narrowed(drops.single_scattering_albedo);
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

// The table of the depth toward the sun. Low suns need more slices: the rays cross more cells from one to the next.
ImageId add_shadow(Plan& plan, const CloudGrid& grid, const CloudInputs& inputs, const device::CloudData& head,
                   const std::string& cloud) {
  constexpr double kMostCells = 1.2;  // across, that a ray crosses from slice to slice
  constexpr double kManyCells = 6.0;  // likewise from level to level of the grid: so many that one ray does
  constexpr double kScales = 20.0;  // the scale is rounded, so that wavelengths whose drops differ little share a table
  const double scale = std::max(std::round(static_cast<double>(head.scale) * kScales), 1.0) / kScales;
  const double across =
      grid.cell_z() * std::max(std::abs(head.sunward_east) / grid.cell_x, std::abs(head.sunward_north) / grid.cell_y);
  const EdgeInputs edge = add_edge(plan, grid, inputs.density);
  const bool carved = edge.carved.value == 1;
  auto finer = carved ? static_cast<std::uint32_t>(std::clamp(std::ceil(across / kMostCells), 1.0, 3.0)) : 1U;
  while (finer > 1 && corners_of(grid, finer) > kMostCloudCells) {
    --finer;
  }
  const std::uint32_t rays = across > kManyCells ? 1 : 4;
  const auto parts = static_cast<std::uint32_t>(std::clamp(
      std::ceil((carved ? 2.0 * std::max(across, 1.0) : across) / finer), 1.0, carved && rays == 1 ? 4.0 : 8.0));
  const std::string key = cloud + " shadow " + shortest(static_cast<double>(head.sunward_east)) + " " +
                          shortest(static_cast<double>(head.sunward_north)) + " " + shortest(carved ? scale : 1.0) +
                          (head.thin == 1 ? " thin" : "");
  if (const auto made = plan.shared_image(key)) {
    return *made;
  }
  const Extent size{head.fine_x + 1, head.fine_y + 1, finer * head.fine_z + 1};
  const BufferId depths = plan.add_buffer({.name = "cloud_sun_depth",
                                           .bytes = sizeof(float) * corners_of(grid, finer),
                                           .zeroed = false,
                                           .stored = key,
                                           .slice = size.width * size.height});  // a level: rays pass through clear air
  plan.add_pass({.shader = "cloud_shadow",
                 .reads = {{"cloud_data", inputs.head},
                           {"cloud_density_lut", inputs.density},
                           {"cloud_gap_lut", inputs.gaps},
                           edge.noise},
                 .writes = {{"depths_out", depths}},
                 .grid = {size.width, size.height, 1},
                 .push_constants = {size.depth - 1, parts, push_constant(scale), rays},
                 .specialization = {edge.carved},
                 .cost = (carved ? 2.0 * rays : 1.0) * size.depth * parts});
  const ImageId shadow = plan.add_image({.name = "cloud_shadow",
                                         .extent = size,
                                         .key = key,
                                         .half = true,
                                         .components = head.thin == 1 ? 1U : 4U,
                                         .shared = true});
  plan.add_pass({.shader = "cloud_bends",
                 .reads = {{"depths", depths}},
                 .writes = {{"bends_out", shadow}},
                 .grid = size,
                 .specialization = {{"kBends", 1U - head.thin}}});
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

// The sun's light in cells that are named so.
BufferId add_beam(Plan& plan, const std::string& name, const CloudInputs& inputs, const LaidCells& laid,
                  const std::string& key) {
  const CloudCells& cells = laid.cells;
  const auto count = static_cast<std::uint32_t>(cells.count());
  const BufferId beam =
      plan.add_buffer({.name = name, .bytes = count * sizeof(float), .key = key + " " + name, .zeroed = false});
  std::vector<Binding> reads = inputs.reads();
  reads.push_back({"extinctions", laid.extinction});
  plan.add_pass({.name = name,
                 .shader = "cloud_beam",
                 .reads = std::move(reads),
                 .writes = {{"beam_out", beam}},
                 .grid = {count, 1, 1},
                 .push_constants = {cells.nx, cells.ny, cells.nz},
                 .cost = 10.0});
  return beam;
}

// The light in the cloud. That of sky and ground is smooth: cells of twice the size do.
struct Fields {
  LaidCells laid;
  LaidCells coarser;
  CloudTables tables;
  CloudField sun;
  CloudField sky;
  CloudField ground;
};

ImageId add_sources(Plan& plan, const Fields& fields, const std::string& key) {
  constexpr std::uint32_t kBlocks = 4;
  const CloudCells& cells = fields.laid.cells;
  const CloudCells& coarser = fields.coarser.cells;
  const Extent extent{(cells.nx + 1) * kBlocks, cells.ny + 1, cells.nz + 2};
  const ImageId sources =
      plan.add_image({.name = "cloud_source", .extent = extent, .key = key + " sources", .stored = true});
  plan.add_pass({.shader = "cloud_source",
                 .reads = {{"scattering", fields.tables.scattering},
                           {"sun", fields.sun.moments},
                           {"sky", fields.sky.moments},
                           {"ground", fields.ground.moments},
                           {"cells", fields.laid.extinction},
                           {"coarser_cells", fields.coarser.extinction}},
                 .writes = {{"source_out", sources}},
                 .grid = extent,
                 .push_constants = {cells.nx, cells.ny, cells.nz, coarser.nx, coarser.ny, coarser.nz}});
  return sources;
}

constexpr std::uint32_t kLevelsBelow = 3;  // as shaders/shared/cloud_around.glsl has them

ImageId add_around(Plan& plan, const CloudInputs& inputs, const Fields& fields, const std::string& key) {
  const CloudCells& cells = fields.coarser.cells;
  const Extent extent{cells.nx + 1, cells.ny + 1, kLevelsBelow + cells.nz + 1};
  const ImageId around =
      plan.add_image({.name = "cloud_around", .extent = extent, .key = key + " around", .stored = true});
  plan.add_pass({.shader = "cloud_around",
                 .reads = {{"cloud_data", inputs.head},
                           {"ordinates", fields.tables.ordinates},
                           {"sun_means", fields.sun.means},
                           {"sky_means", fields.sky.means},
                           {"ground_means", fields.ground.means},
                           {"sun_planes", fields.sun.planes},
                           {"sky_planes", fields.sky.planes},
                           {"ground_planes", fields.ground.planes}},
                 .writes = {{"around_out", around}},
                 .grid = extent,
                 .push_constants = {cells.nx, cells.ny, cells.nz},
                 .cost = 300.0});
  return around;
}

ImageId add_sums(Plan& plan, const CloudInputs& inputs, const Fields& fields, ImageId around, const std::string& key) {
  const CloudCells& cells = fields.coarser.cells;
  const Extent extent{4 + cells.nz, 2, 1};
  const ImageId sums = plan.add_image({.name = "cloud_sums", .extent = extent, .key = key + " sums", .stored = true});
  std::vector<Binding> reads = inputs.reads();
  reads.insert(reads.end(), {{"ordinates", fields.tables.ordinates},
                             {"sun_planes", fields.sun.planes},
                             {"sky_planes", fields.sky.planes},
                             {"ground_planes", fields.ground.planes},
                             {"cloud_around_lut", around}});
  plan.add_pass({.shader = "cloud_sums",
                 .reads = std::move(reads),
                 .writes = {{"sums_out", sums}},
                 .grid = {256, 1, 1},
                 .push_constants = {cells.nx, cells.ny, cells.nz},
                 .cost = 400.0});
  return sums;
}

void add_balance(Plan& plan, const Part& part, const Light& light, const CloudInputs& inputs, ImageId sums,
                 const std::vector<Specialization>& which, double open, BufferId balance) {
  std::vector<Specialization> constants = sunlight_specialization(plan, part.air, light.transmittance);
  add_moment_constants(constants, settings_of(part));
  constants.insert(constants.end(), which.begin(), which.end());
  std::vector<Binding> reads = inputs.reads();
  reads.insert(reads.end(), {{"cloud_mean_lut", inputs.mean},
                             {"cloud_sums_lut", sums},
                             {"transmittance_lut", light.transmittance},
                             {"moments_lut", light.moments}});
  plan.add_pass(
      {.shader = "cloud_balance",
       .reads = std::move(reads),
       .writes = {{"light_out", balance}},
       .grid = {1, 1, 1},
       .push_constants = {push_constant(std::sin(sun_over_clouds(part.scene).elevation)), push_constant(open)},
       .specialization = std::move(constants)});
}

// What the ground sends to the cells' base.
BufferId add_ground(Plan& plan, const CloudInputs& inputs, const CloudCells& cells, const CloudTables& tables,
                    const CloudField& sun, const std::string& key) {
  const std::size_t plane = std::size_t{cells.nx} * cells.ny;
  const BufferId ground = plan.add_buffer({.name = "cloud_ground",
                                           .bytes = (1 + physics::kCloudOrdinates) * plane * sizeof(float),
                                           .key = key + " ground"});
  std::vector<Binding> reads = inputs.reads();
  reads.insert(reads.end(), {{"ordinates", tables.ordinates}, {"sun_planes", sun.planes}});
  plan.add_pass({.shader = "cloud_ground",
                 .reads = std::move(reads),
                 .writes = {{"ground_out", ground}},
                 .grid = {256, 1, 1},
                 .push_constants = {cells.nx, cells.ny},
                 .cost = 400.0});
  return ground;
}

Fields add_fields(Plan& plan, const CloudCells& coarse, const CloudDrops& drops, const CloudInputs& inputs,
                  physics::vec3 to_sun, const std::string& key) {
  CloudCells coarser = coarsened(coarse, (coarse.nx + 1) / 2, (coarse.ny + 1) / 2, (coarse.nz + 1) / 2);
  Fields fields{.laid = add_cloud_cells(plan, "cloud_cells", coarse, drops),
                .coarser = add_cloud_cells(plan, "cloud_coarser_cells", std::move(coarser), drops),
                .tables = add_cloud_tables(plan, drops, -to_sun),
                .sun = {},
                .sky = {},
                .ground = {}};
  const auto add = [&](const LaidCells& on, const CloudIncident& incident, BufferId beam,
                       const SweepSettings& settings = {}) {
    return add_cloud_field(plan, on, drops, incident, settings, fields.tables, beam, key);
  };
  const BufferId beam = add_beam(plan, "cloud_beam", inputs, fields.laid, key);
  const BufferId coarser_beam = add_beam(plan, "cloud_beam_start", inputs, fields.coarser, key);
  const CloudField start = add(fields.coarser, {.name = "sun_start", .sun = true}, coarser_beam);
  fields.sun = add(fields.laid, {.name = "sun", .sun = true}, beam, {.start = {{start, fields.coarser}}});
  fields.sky = add(fields.coarser, {.name = "sky", .above = 1.0}, beam);
  const BufferId ground = add_ground(plan, inputs, fields.coarser.cells, fields.tables, start, key);
  fields.ground = add(fields.coarser, {.name = "ground", .below = 1.0, .ground = ground}, beam);
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

// What is computed for one field before the others count.
struct FieldStart {
  Matter matter;
  physics::vec3 to_sun;
  CloudCells coarse;
  LitCloud lit;
};

FieldStart start_of(const Part& part, const StandingCloud& cloud) {
  const TableSize cells = part.scene.render.get<TableSize>("cloud_lut");
  FieldStart start{
      .matter = matter_of(*cloud.cloud, part), .to_sun = cloud_sun(part.scene, *cloud.grid), .coarse = {}, .lit = {}};
  start.lit.grid = with_room(*cloud.cloud, cloud.grid, start.to_sun);
  start.lit.key = "cloud " + cloud_shape_key(*cloud.cloud);  // light stays with a cloud that moves
  start.coarse = coarse_cells(*start.lit.grid, cells, start.lit.key);
  start.lit.head = head_of(*start.lit.grid, start.coarse, start.matter.drops, start.to_sun);
  return start;
}

// The tables of one field and the light in it. Returns what its own passes read of them.
// `open`: km, the base of the field above it, or the air's top.
CloudInputs add_field(Plan& plan, const Part& part, const Light& light, FieldStart& start, double open,
                      BufferId balance) {
  LitCloud& lit = start.lit;
  const std::string sun_key =
      sun_key_of(lit.key, start.matter.drops, start.to_sun, part.scene.render.get<TableSize>("cloud_lut"));
  CloudInputs inputs = add_inputs(plan, lit.grid, lit.head, lit.key, sun_key);
  const Fields fields = add_fields(plan, start.coarse, start.matter.drops, inputs, start.to_sun, sun_key);
  lit.sources = add_sources(plan, fields, sun_key);
  inputs.around = add_around(plan, inputs, fields, sun_key);
  add_balance(plan, part, light, inputs, add_sums(plan, inputs, fields, inputs.around, sun_key), lit.constants, open,
              balance);
  lit.phase = add_phase(plan, start.matter);
  return inputs;
}

}  // namespace

std::vector<LitCloud> add_cloud_light(Plan& plan, const Part& part, const Light& light) {
  std::vector<FieldStart> starts;
  std::ranges::transform(standing_clouds(part), std::back_inserter(starts),
                         [&](const StandingCloud& cloud) { return start_of(part, cloud); });
  std::vector<device::CloudData> heads;
  std::ranges::transform(starts, std::back_inserter(heads), [](const FieldStart& start) { return start.lit.head; });
  const auto count = static_cast<std::uint32_t>(starts.size());
  const BufferId stack = plan.add_buffer(filled_buffer("cloud_stack", bytes_of(heads)));
  const BufferId balance = plan.add_buffer({.name = "cloud_balance", .bytes = count * sizeof(device::CloudLight)});
  std::vector<CloudInputs> inputs;
  for (std::uint32_t i = 0; i < count; ++i) {
    plan.tell_apart(i > 0 ? " " + std::to_string(i + 1) : "");
    starts[i].lit.name = i > 0 ? " " + std::to_string(i + 1) : "";
    starts[i].lit.constants = {{"kFields", count}, {"kField", i}};
    const double open = i + 1 < count ? starts[i + 1].lit.grid->base : part.scene.planet.atmosphere_height;
    inputs.push_back(add_field(plan, part, light, starts[i], open, balance));
  }
  plan.tell_apart("");
  std::vector<LitCloud> all;
  for (std::uint32_t i = 0; i < count; ++i) {
    LitCloud& lit = starts[i].lit;
    lit.shade = inputs[i].reads();
    lit.shade.insert(lit.shade.end(), {{"cloud_mean_lut", inputs[i].mean},
                                       {"cloud_around_lut", inputs[i].around},
                                       {"cloud_light", balance},
                                       {"cloud_fields", stack}});
    for (std::uint32_t j = 0; j < kMaxClouds; ++j) {  // as shaders/shared/cloud_stack.glsl has them
      const CloudInputs& of = inputs[std::min(j, count - 1)];
      const std::string name = "field_" + std::to_string(j);
      lit.shade.push_back({name + "_shadow_lut", of.shadow});
      lit.shade.push_back({name + "_mean_lut", of.mean});
    }
    all.push_back(std::move(lit));
  }
  return all;
}

}  // namespace airlight::orders
