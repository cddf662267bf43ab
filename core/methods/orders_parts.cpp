#include "core/methods/orders_parts.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <numbers>

#include "core/air/phase_functions.h"
#include "core/luts/luts.h"
#include "core/methods/sky_pass.h"
#include "core/things/thing_buffers.h"

namespace airlight::orders {
namespace {

template <class Such>
std::uint32_t media_with(const Air& air, std::uint32_t scattering, Such such) {
  std::uint32_t bits = 0;
  for (std::size_t i = 0; i < air.media().size(); ++i) {
    bits |= such(air.media()[i].phase) ? 1u << i : 0u;
  }
  return bits & scattering;
}

// Whose phase function, a column away from its peak, is still above a fifth of it: both forward and backward.
std::uint32_t media_wider_than_a_column(const Air& air, int columns, std::uint32_t scattering) {
  physics::Physics p = air.formulas();
  const double chord = 1.0 / (columns - 1);
  const double nu = 1.0 - 2.0 * chord * chord;
  std::uint32_t bits = 0;
  for (std::uint32_t i = 0; i < p.medium_count(); ++i) {
    const auto far = [&](double at, double peak) {
      const physics::vec3 rest = p.medium_phase(i, at) - p.medium_phase(i, peak) * 0.2;
      return rest.x > 0.0 && rest.y > 0.0 && rest.z > 0.0;
    };
    const bool wide = far(nu, 1.0) && far(-nu, -1.0);
    bits |= wide ? 1u << i : 0u;
  }
  return bits & scattering;
}

}  // namespace

bool inside_the_air(const Scene& scene) {
  return scene.camera.altitude <= scene.planet.atmosphere_height;
}

bool looks_from_space(const Part& part) {
  constexpr double kLeftAbove = 1e-3;  // of what scatters
  if (!inside_the_air(part.scene)) {
    return true;
  }
  const Column& column = part.air.column();
  double above = 0.0;
  double all = 0.0;
  for (std::size_t k = 0; k < column.cells(); ++k) {
    double here = 0.0;
    for (std::size_t i = 0; i < part.air.media().size(); ++i) {
      here += column.density[k][i] * std::ranges::max(part.air.media()[i].scattering) * column.width(k);
    }
    all += here;
    above += column.middle(k) > part.scene.camera.altitude ? here : 0.0;
  }
  return above < kLeftAbove * all;
}

MomentSettings settings_of(const Part& part) {
  MomentRequest request{.size = part.scene.render.get<TableSize>("moments_lut"),
                        .polarised = part.scene.render.polarisation};
  if (const std::string& degree = part.scene.render.get<std::string>("degree"); degree != "auto") {
    request.degree = degree.front() - '0';
    request.hazy = request.degree > kMostClearDegree;
  }
  if (const int orders = part.scene.render.get<int>("orders"); orders > 0) {
    request.orders = orders;
  }
  return moment_settings(part.air, request);
}

std::uint32_t steps_of(const Scene& scene, const MomentSettings& settings) {
  const int steps = scene.render.get<int>("steps");
  const int shells = settings.size[1] - 1;
  return static_cast<std::uint32_t>(settings.shells ? std::max((steps + shells / 2) / shells, 1) : steps);
}

Light add_light(Plan& plan, const Part& part) {
  Light light;
  light.transmittance = add_transmittance(plan, part.air, part.scene.render.get<TableSize>("transmittance_lut"));
  const MomentSettings settings = settings_of(part);
  light.sunlight = settings.shells ? add_sun_table(plan, part.air, settings) : light.transmittance;
  light.moments = add_moments(plan, part.air, light.sunlight, settings);
  light.constants = sunlight_specialization(plan, part.air, light.sunlight);
  add_moment_constants(light.constants, settings);
  light.steps = steps_of(part.scene, settings);
  light.by_shells = settings.shells;
  return light;
}

double ray_cost(std::uint32_t steps) {
  return 10.0 + 2.5 * steps;
}

std::uint32_t stokes_of(const Part& part, const View& view) {
  if (view.stokes) {
    return physics::kStokesKept;
  }
  return part.scene.camera.polariser ? physics::kStokesFiltered : physics::kStokesNone;
}

float half_angle_of(const Scene& scene, const View& view) {
  const Camera& camera = scene.camera;
  if (!view.directions.empty() || scene.render.get<std::string>("tabulate") == "always") {
    return std::numbers::pi_v<float>;
  }
  switch (camera.projection) {
    case Projection::perspective: {
      const double corner = std::hypot(scene.image.width, scene.image.height) / scene.image.height;
      return static_cast<float>(std::atan(corner * std::tan(0.5 * camera.vertical_fov)));
    }
    case Projection::fisheye: {
      const double corner =
          std::hypot(scene.image.width, scene.image.height) / std::min(scene.image.width, scene.image.height);
      return static_cast<float>(0.5 * corner * camera.vertical_fov);
    }
    case Projection::equirectangular:
    case Projection::cube:
    case Projection::octahedral:
      break;
  }
  return std::numbers::pi_v<float>;
}

namespace {

// Rays between the true horizon and level see the air from the camera's altitude down: a low camera's are nearly alike.
// In fog of 20 m so few rows move the error there by 0.013 % of the light at most, with the camera at 2, 10 and 30 m.
std::uint32_t limb_rows_of(double altitude, std::uint32_t most) {
  constexpr double kAll = 0.05;  // km, from where on all rows are taken
  const double share = std::sqrt(std::min(std::max(altitude, 0.0) / kAll, 1.0));
  return std::clamp(static_cast<std::uint32_t>(std::ceil(share * most)), std::min(8u, most), most);
}

}  // namespace

FactorTable factor_table(const Part& part, std::uint32_t media, bool layers, std::uint32_t stokes) {
  const TableSize size = part.scene.render.get<TableSize>("sky_lut");
  const auto columns = static_cast<std::uint32_t>(size[0]);
  const auto sky = static_cast<std::uint32_t>(size[1]);
  const bool from_space = looks_from_space(part);
  const std::uint32_t rayleigh = media_with(part.air, media, [](auto of) { return of == PhaseFunction::rayleigh; });
  const std::uint32_t smooth = media_with(part.air, media, [](auto of) { return phase_row(of).is_smooth; });
  const bool all = part.scene.render.get<std::string>("fold") == "all";
  std::uint32_t folded = all ? media_wider_than_a_column(part.air, size[0], media) : smooth;
  folded &= stokes != physics::kStokesNone && !layers ? ~rayleigh : ~0u;
  const std::uint32_t apart = layers ? media : media & ~folded;
  return {.columns = from_space ? 4 * columns : columns,
          .ground_rows = from_space ? 6 * sky : sky / 2,
          .limb_rows = from_space ? 2 * sky : limb_rows_of(part.scene.camera.altitude, 3 * sky / 4),
          .sky_rows = inside_the_air(part.scene) ? sky : 0,
          .apart = apart,
          .folded = folded,
          .rayleigh = (folded & rayleigh) != 0,
          .stokes = stokes,
          .blocks = static_cast<std::uint32_t>(std::popcount(apart)) + (stokes != physics::kStokesNone ? 3 : 1)};
}

FactorTable unfolded_table(const Part& part) {
  FactorTable table = factor_table(part, part.air.scattering_media(), true, physics::kStokesNone);
  table.folded = 0;
  table.rayleigh = false;
  return table;
}

std::uint32_t froxels_over(int pixels) {
  constexpr std::uint32_t kPixels = 4;
  constexpr std::uint32_t kMost = 320;
  return std::clamp((static_cast<std::uint32_t>(pixels) + kPixels - 1) / kPixels + 1, 2U, kMost);
}

void add_table_constants(std::vector<Specialization>& constants, const FactorTable& table) {
  constants.push_back({"kSkyColumns", table.columns});
  constants.push_back({"kGroundRows", table.ground_rows});
  constants.push_back({"kLimbRows", table.limb_rows});
  constants.push_back({"kSkyRows", table.sky_rows});
  constants.push_back({"kScatteringMedia", table.apart});
  constants.push_back({"kFoldedMedia", table.folded});
  constants.push_back({"kRayleighCarrier", table.rayleigh ? 1u : 0u});
}

FactorLayout layout_of(const Scene& scene, const FactorTable& table, bool in_colours) {
  std::vector<std::string> apart;
  for (std::size_t i = 0; i < scene.media.size(); ++i) {
    if ((table.apart >> i & 1u) != 0) {
      apart.push_back(scene.media[i].name);
    }
  }
  return {.planet = scene.planet,
          .camera_altitude = scene.camera.altitude,
          .sun_mu = std::sin(scene.sun.elevation),
          .apart = std::move(apart),
          .columns = table.columns,
          .ground_rows = table.ground_rows,
          .limb_rows = table.limb_rows,
          .sky_rows = table.sky_rows,
          .rayleigh = table.rayleigh,
          .stokes = table.stokes != physics::kStokesNone,
          .in_colours = in_colours};
}

ImageId add_factors(Plan& plan, const std::string& shader, const Scene& scene, const FactorTable& table,
                    const View& view, const Light& light) {
  const bool layers = shader == "layers_factors";
  const std::uint32_t blocks = table.blocks + (layers ? 1 : 0);
  std::function<TableText()> text;
  if (!layers) {
    text = [layout = layout_of(scene, table, false)] { return factor_text(layout); };
  }
  const ImageId factors = plan.add_image({.name = shader,
                                          .extent = {table.columns * blocks, table.rows(), 1},
                                          .key = picture_table_key(view, shader),
                                          .text = std::move(text)});
  std::vector<Specialization> constants = light.constants;
  add_table_constants(constants, table);
  constants.push_back({"kStokes", table.stokes});
  std::vector<std::uint32_t> push{light.steps};
  if (!layers) {
    push.push_back(std::bit_cast<std::uint32_t>(half_angle_of(scene, view)));
  }
  // A table of some thousand rays does not fill a GPU, whose threads would take the steps one after the other.
  const std::uint32_t team = shader == "sky_factors" && !light.by_shells ? 4 : 1;
  plan.add_pass({.name = shader,
                 .shader = shader,
                 .reads = light.reads(),
                 .writes = {{"factors_out", factors}},
                 .grid = {table.columns, table.rows(), 1},
                 .push_constants = std::move(push),
                 .specialization = std::move(constants),
                 .team = team,
                 .cost = ray_cost(light.steps)});
  return factors;
}

std::uint32_t march_shafts(const Part& part) {
  const bool shafts = part.scene.render.get<std::string>("volumetric_shadows") != "false";
  return shafts ? physics::kShaftsExact : physics::kShaftsNone;
}

void add_things_to_march(Plan& plan, const Part& part, const Light& light, std::vector<Binding>& reads,
                         std::vector<Specialization>& constants) {
  const ThingInputs things = add_things(plan, part.scene, part.things);
  reads.insert(reads.end(), things.reads.begin(), things.reads.end());
  reads.push_back({"shares_lut", add_thing_light(plan, part, light, things).shares});
  constants.insert(constants.end(), things.constants.begin(), things.constants.end());
  constants.push_back({"kShafts", march_shafts(part)});
}

std::uint32_t steps_past_things(const Part& part, const Light& light) {
  return part.scene.terrain && !light.by_shells ? (light.steps + 1) / 2 : light.steps;
}

}  // namespace airlight::orders
