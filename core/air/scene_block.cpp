#include "core/air/scene_block.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>
#include <numbers>

#include "core/air/refraction.h"
#include "core/plan/bytes.h"
#include "core/plan/plan.h"
#include "core/scene/density_profiles.h"

namespace airlight {
namespace {

using physics::vec3;

static_assert(static_cast<physics::uint>(Projection::perspective) == physics::kProjectionPerspective &&
              static_cast<physics::uint>(Projection::equirectangular) == physics::kProjectionEquirectangular &&
              static_cast<physics::uint>(Projection::fisheye) == physics::kProjectionFisheye &&
              static_cast<physics::uint>(Projection::cube) == physics::kProjectionCube &&
              static_cast<physics::uint>(Projection::octahedral) == physics::kProjectionOctahedral);
static_assert(static_cast<physics::uint>(CubeLayout::stack) == physics::kCubeStack &&
              static_cast<physics::uint>(CubeLayout::strip) == physics::kCubeStrip &&
              static_cast<physics::uint>(CubeLayout::cross) == physics::kCubeCross);

// Radiance at the disc's centre: the limb-darkened profile 1 - u(1 - mu) has mean 1 - u/3 over the disc, and
// radiance_scale 1 makes the mean radiance irradiance / solid angle.
vec3 disc_radiance(const Sun& sun) {
  const double half = std::sin(0.5 * sun.disc.angular_radius);
  const double solid_angle = 4.0 * std::numbers::pi * half * half;
  const double mean_over_centre = 1.0 - sun.disc.limb_darkening / 3.0;
  return vector_of(sun.irradiance) * (sun.disc.radiance_scale / (solid_angle * mean_over_centre));
}

// A ball's light: across the disc, from straight up to the left, by the bright limb; toward the camera by the phase.
void put_lit_ball(physics::Physics& p, const Sun& light, physics::SunData& ball) {
  const LitBall& lit = *light.disc.lit;
  const double phase = std::clamp(std::abs(lit.phase), 0.0, 0.999 * std::numbers::pi);
  const vec3 up = p.direction_from_angles(light.elevation + 0.5 * std::numbers::pi, light.azimuth);
  const vec3 left = p.direction_from_angles(0.0, light.azimuth - 0.5 * std::numbers::pi);
  const vec3 across = up * std::cos(lit.bright_limb) + left * std::sin(lit.bright_limb);
  ball.lit_from = across * std::sin(phase) - ball.direction * std::cos(phase);
  ball.lit_scale = p.lit_ball_scale(phase);
  ball.earthshine = lit.earthshine;
}

// All but what belongs to the air: its fade stays.
void put_picture(physics::Physics& p, const Scene& scene) {
  physics::SunData& sun = p.scene.sun;
  sun.direction = p.direction_from_angles(scene.sun.elevation, scene.sun.azimuth);
  const double passed = light_passed(scene.camera);
  sun.irradiance = vector_of(scene.sun.irradiance) * (scene.sun.uncovered * passed);
  sun.angular_radius = scene.sun.disc.angular_radius;
  sun.limb_darkening = scene.sun.disc.limb_darkening;
  sun.disc_radiance = disc_radiance(scene.sun) * passed;
  p.lit_disc = scene.sun.disc.lit.has_value();
  if (p.lit_disc) {
    put_lit_ball(p, scene.sun, sun);
  }
  p.covered_disc = scene.sun.disc.cover.has_value();
  if (p.covered_disc) {
    const DiscCover& cover = *scene.sun.disc.cover;
    sun.lit_from = p.direction_from_angles(cover.elevation, cover.azimuth);
    sun.lit_scale = 2.0 * std::sin(0.5 * cover.angular_radius);
  }
  sun.dispersion = scene.planet.refraction ? vector_of(scene.planet.refraction->dispersion) : vec3(1.0);
  const CameraBasis basis = camera_basis(scene.camera);
  physics::CameraData& camera = p.scene.camera;
  camera.altitude = optical_altitude(p, scene.camera.altitude);
  sun.seen = seen_direction(p, sun.direction).direction;
  camera.right = basis.right;
  camera.up = basis.up;
  camera.forward = basis.forward;
  const double filter = scene.camera.polariser.value_or(0.0);
  camera.polariser = basis.up * std::cos(filter) + basis.right * std::sin(filter);
  camera.azimuth = scene.camera.azimuth;
  camera.half_fov = 0.5 * scene.camera.vertical_fov;
  camera.width = static_cast<physics::uint>(scene.image.width);
  camera.height = static_cast<physics::uint>(scene.image.height);
  camera.cube_layout = static_cast<physics::uint>(scene.camera.cube_layout);
  const physics::PlanetData& planet = p.scene.planet;
  // A cosine changes by less than its angle.
  const double reach = p.pixel_reach(camera, projection_code(scene.camera.projection));
  const double horizon = p.horizon_mu(planet, camera.altitude);
  camera.edge_low = horizon - 1.1 * reach;
  camera.edge_high = horizon + 1.1 * (p.air_edge(planet, camera.altitude) + reach);
  p.scene.tile.width = camera.width;
}

device::vec2 narrow(const physics::vec2& from) {
  return {narrowed(from.x), narrowed(from.y)};
}

device::MediumData narrow(const physics::MediumData& from) {
  device::MediumData m{};
  m.scattering = narrowed(from.scattering);
  m.absorption = narrowed(from.absorption);
  for (const DensityNumber& number : kDensityNumbers) {
    m.*number.device = narrowed(from.*number.formula);
  }
  m.g = narrowed(from.g);
  m.depolarization = narrowed(from.depolarization);
  m.phase_table = from.phase_table;
  m.first_layer = from.first_layer;
  m.layer_count = from.layer_count;
  const auto narrow_each = [](const vec3& x) { return narrowed(x); };
  std::ranges::transform(from.legendre, std::begin(m.legendre), narrow_each);
  std::ranges::transform(from.peak, std::begin(m.peak), narrow_each);
  return m;
}

device::SunData narrow(const physics::SunData& from) {
  return {.direction = narrowed(from.direction),
          .seen = narrowed(from.seen),
          .dispersion = narrowed(from.dispersion),
          .irradiance = narrowed(from.irradiance),
          .angular_radius = narrowed(from.angular_radius),
          .limb_darkening = narrowed(from.limb_darkening),
          .disc_radiance = narrowed(from.disc_radiance),
          .fade_scale = narrowed(from.fade_scale),
          .fade_bias = narrowed(from.fade_bias),
          .lit_from = narrowed(from.lit_from),
          .lit_scale = narrowed(from.lit_scale),
          .earthshine = narrowed(from.earthshine)};
}

device::CameraData narrow(const physics::CameraData& from) {
  return {.altitude = narrowed(from.altitude),
          .right = narrowed(from.right),
          .up = narrowed(from.up),
          .forward = narrowed(from.forward),
          .polariser = narrowed(from.polariser),
          .azimuth = narrowed(from.azimuth),
          .half_fov = narrowed(from.half_fov),
          .width = from.width,
          .height = from.height,
          .cube_layout = from.cube_layout,
          .edge_low = narrowed(from.edge_low),
          .edge_high = narrowed(from.edge_high)};
}

}  // namespace

CameraBasis camera_basis(const Camera& camera) {
  const double cos_azimuth = std::cos(camera.azimuth);
  const double sin_azimuth = std::sin(camera.azimuth);
  const double cos_pitch = std::cos(camera.pitch);
  const double sin_pitch = std::sin(camera.pitch);
  const vec3 forward{sin_azimuth * cos_pitch, sin_pitch, -cos_azimuth * cos_pitch};
  const vec3 right{cos_azimuth, 0.0, sin_azimuth};
  const vec3 up{-sin_azimuth * sin_pitch, cos_pitch, cos_azimuth * sin_pitch};
  const double c = std::cos(camera.roll);
  const double s = std::sin(camera.roll);
  return {right * c - up * s, right * s + up * c, forward};
}

physics::Physics formulas_of(const Air& air, const Scene& scene) {
  physics::Physics p = air.formulas();
  put_picture(p, scene);
  return p;
}

physics::Physics geometry_of(const Scene& scene) {
  physics::Physics p;
  const Planet& planet = scene.planet;
  put_planet(p, planet);
  put_picture(p, scene);
  return p;
}

device::SceneData narrowed(const physics::SceneData& data) {
  device::SceneData out{};
  out.planet = {narrowed(data.planet.ground_radius), narrowed(data.planet.atmosphere_height),
                narrowed(data.planet.ground_albedo)};
  out.sun = narrow(data.sun);
  out.camera = narrow(data.camera);
  out.refraction.ground_radius = narrowed(data.refraction.ground_radius);
  out.refraction.scale = narrowed(data.refraction.scale);
  std::ranges::transform(data.refraction.nodes, std::begin(out.refraction.nodes),
                         [](const vec3& node) { return narrowed(node); });
  out.multiple_scattering_scale = narrowed(data.multiple_scattering_scale);
  out.moments = {narrowed(data.moments.top), narrowed(data.moments.elevation_scale), narrowed(data.moments.v_low),
                 narrowed(data.moments.v_high)};
  std::ranges::transform(data.media, std::begin(out.media), [](const physics::MediumData& m) { return narrow(m); });
  std::ranges::transform(data.layers, std::begin(out.layers), [](const physics::vec2& v) { return narrow(v); });
  out.shell_rows = data.shell_rows;
  std::ranges::transform(data.shell_altitudes, std::begin(out.shell_altitudes), [](double h) { return narrowed(h); });
  out.tile = {data.tile.x, data.tile.y, data.tile.width};
  return out;
}

std::vector<std::byte> narrowed_tables(const physics::Physics& p) {
  std::vector<float> values(4);  // a buffer has something in it
  if (p.phase_samples != nullptr) {
    values.clear();
    for (const vec3& sample : *p.phase_samples) {
      values.insert(values.end(), {narrowed(sample.x), narrowed(sample.y), narrowed(sample.z), 0.0F});
    }
  }
  return bytes_of(values);
}

std::vector<std::byte> device_scene_bytes(const Air& air, const Scene& scene) {
  return device_scene_bytes(air, scene, {0, 0, scene.image.width, scene.image.height});
}

std::vector<std::byte> device_scene_bytes(const Air& air, const Scene& scene, const Tile& tile) {
  return device_scene_bytes(formulas_of(air, scene), tile);
}

std::vector<std::byte> device_scene_bytes(const physics::Physics& p, const Tile& tile) {
  device::SceneData data = narrowed(p.scene);
  data.tile = {static_cast<unsigned int>(tile.x), static_cast<unsigned int>(tile.y),
               static_cast<unsigned int>(tile.width)};
  const std::vector<std::byte> tables = narrowed_tables(p);
  std::vector<std::byte> bytes(scene_tables_offset(sizeof data) + tables.size());
  std::memcpy(bytes.data(), &data, sizeof data);
  std::ranges::copy(tables, bytes.begin() + static_cast<std::ptrdiff_t>(bytes.size() - tables.size()));
  return bytes;
}

}  // namespace airlight
