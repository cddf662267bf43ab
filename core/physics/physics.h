#pragma once
// shaders/physics compiled as C++ on double: the same text that the device runs in float.

#include <memory>
#include <vector>

#include "core/physics/vector.h"

namespace airlight::physics {

#define UNROLL                 // a mark for the shaders' compiler
#define CODE static constexpr  // of a constant in the struct below

// The order follows the dependencies of these files.
// clang-format off
#include "shaders/shared/scene.h"
#include "shaders/shared/tables.h"
#include "shaders/shared/analytic.h"
#include "shaders/shared/glare.h"
#include "shaders/shared/night.h"
#include "shaders/shared/bodies.h"
#include "shaders/shared/terrain.h"
#include "shaders/shared/thing_light.h"
#include "shaders/shared/ground.h"
// clang-format on

// A two-dimensional table with the device's sampling: bilinear between texel centres, clamped at the edges.
struct HostTable {
  int width = 0;
  int height = 0;
  std::vector<vec3> texels;  // row by row

  vec3 fetch(real u, real v) const;       // texture coordinates, 0 to 1 over the whole table
  vec3 fetch_unit(real x, real y) const;  // unit range over the texel centres
};

// The shaders' structs have no initial values, as GLSL has none. Here they begin as zeros, which say that a thing is
// absent: an ocean's slopes, for instance.

// Terrain as its buffers have it (core/things).
struct HostTerrain {
  TerrainData shape{};
  std::shared_ptr<const std::vector<float>> heights;  // km, row by row from the top, then the maxima of each level
  std::vector<uint> colours;                          // square roots of albedo, 10 bits a channel
  std::shared_ptr<const std::vector<uint>> shadows;   // null: no sun has been asked for
};

// The ground's maps as their buffers have them (core/things).
struct HostGround {
  GroundData head{};
  std::shared_ptr<const std::vector<uint>> albedo;  // square roots, 10 bits a channel, level by level
  std::shared_ptr<const std::vector<uint>> water;   // shares, 8 bits each, likewise
};

// The bodies of a scene as their buffers have them (core/things), kind by kind.
struct HostBodies {
#define BODY_LIST(Data, one, all, bit, place) \
  std::vector<Data> all;                      \
  uint one##_count() const {                  \
    return static_cast<uint>((all).size());   \
  }                                           \
  const Data& one(uint i) const {             \
    return (all)[i];                          \
  }
  BODY_KINDS(BODY_LIST)
#undef BODY_LIST
};

struct Physics : HostBodies {
  SceneData scene{};
  uint media = 0;
  uint density_profiles = 0;  // four bits a medium
  uint phase_functions = 0;   // four bits a medium
  bool fade = false;
  bool lit_disc = false;
  bool covered_disc = false;
  bool refraction = false;
  std::shared_ptr<const std::vector<vec3>> phase_samples;  // logarithms, tables one behind the other; null: none
  HostTable transmittance_lut;
  HostTable multiple_scattering_lut;
  HostTable ground_irradiance_lut;
  HostTable moments_lut;  // blocks of moment_columns side by side (physics/moments.glsl)
  uint moment_columns = 0;
  uint degree = 2;
  bool delta = false;
  bool polarisation = false;
  bool with_stokes = false;
  bool molecules_alone = false;  // molecules apart, no medium scatters with a direction
  HostTable sun_table;           // mean extinction to the top over the rows of shells (physics/shells.glsl)
  AnalyticData analytic{};
  std::vector<GlarePoint> glare_points;             // the sum of the points first
  HostTable night_sky;                              // physics/night_sky.glsl
  std::shared_ptr<const HostTerrain> terrain_maps;  // null: no terrain
  // Light among terrain (physics/thing_light.glsl): the layers' shares as the device's image has them, the altitudes
  // that they count from, and the light without terrain, slice by slice.
  HostTable light_shares;
  HostTable light_bases;
  std::vector<HostTable> open_light_slices;
  HostTable sky_caps;                             // physics/sky_caps.glsl, sizes side by side; empty: an even sky
  std::shared_ptr<const HostGround> ground_maps;  // null: one albedo

  uint medium_count() const { return media; }
  uint density_profile(uint i) const { return (density_profiles >> (kBitsPerMedium * i)) & 15u; }
  uint phase_of(uint i) const { return (phase_functions >> (kBitsPerMedium * i)) & kPhaseCodes; }
  bool phase_is_sharp(uint i) const { return ((phase_functions >> (kBitsPerMedium * i)) & kPhaseSharp) != 0u; }
  MediumData medium(uint i) const { return scene.media[i]; }
  vec2 density_layer(uint k) const { return scene.layers[k]; }
  uint most_layers() const { return kMaxDensityLayers; }
  vec3 phase_sample(uint k) const { return (*phase_samples)[k]; }
  bool sun_fade_enabled() const { return fade; }
  bool disc_is_lit() const { return lit_disc; }
  bool disc_is_covered() const { return covered_disc; }
  bool ground_reflects() const { return ground_irradiance_lut.width > 0; }
  vec3 fetch_transmittance(real x, real y) const { return transmittance_lut.fetch_unit(x, y); }
  bool bends_light() const { return refraction; }
  real optical_top() const { return scene.planet.atmosphere_height; }
  vec3 refraction_node(uint i) const { return scene.refraction.nodes[i]; }
  real true_ground_radius() const { return scene.refraction.ground_radius; }
  real optical_scale() const { return refraction ? scene.refraction.scale : 1.0; }
  vec3 fetch_multiple_scattering(real x, real y) const { return multiple_scattering_lut.fetch_unit(x, y); }
  vec3 fetch_ground_irradiance(real x) const { return ground_irradiance_lut.fetch_unit(x, 0.5); }
  uint moment_degree() const { return degree; }
  uint source_degree() const { return degree; }
  uint scattered_degree() const { return molecules_alone ? 0u : degree; }
  bool delta_scaled() const { return delta; }
  bool polarised() const { return polarisation; }
  bool stokes() const { return with_stokes; }
  uint shell_rows() const { return scene.shell_rows; }
  real shell_altitude(uint k) const { return scene.shell_altitudes[k]; }
  vec3 fetch_sun_table(real x, real y) const { return sun_table.fetch_unit(x, y); }
  GlarePoint glare_point(uint i) const { return glare_points[i]; }
  AnalyticMedium analytic_medium(uint i) const { return analytic.media[i]; }
  AnalyticDiffuse analytic_diffuse() const { return analytic.diffuse; }
  real share_above(uint i, uint j) const { return analytic.above[i * kMaxMedia + j]; }
  real share_below(uint i, uint j) const { return analytic.below[i * kMaxMedia + j]; }
  vec3 horizon_mass() const { return analytic.horizon_mass; }
  real lit_height() const { return analytic.lit_height; }
  bool scatters(uint i) const {
    const vec3 s = scene.media[i].scattering;
    return s.x > 0.0 || s.y > 0.0 || s.z > 0.0;
  }
  vec3 fetch_moment(uint k, real x, real y) const {
    return moments_lut.fetch((k * moment_columns + 0.5 + x * (moment_columns - 1.0)) / moments_lut.width,
                             (0.5 + y * (moments_lut.height - 1)) / moments_lut.height);
  }

// The order follows the dependencies of these files.
// clang-format off
#include "shaders/physics/phase.glsl"
#include "shaders/physics/phase_table.glsl"
#include "shaders/physics/geometry.glsl"
#include "shaders/physics/refraction.glsl"
#include "shaders/physics/shadow.glsl"
#include "shaders/physics/environment.glsl"
#include "shaders/physics/camera.glsl"
#include "shaders/physics/horizon.glsl"
#include "shaders/physics/glare.glsl"
  const TerrainData& terrain_shape() const { return terrain_maps->shape; }
  uint terrain_level(uint level) const { return terrain_maps->shape.level_first[level]; }
  real terrain_height(uint k) const { return static_cast<real>((*terrain_maps->heights)[k]); }
  uint terrain_shadow(uint k) const { return (*terrain_maps->shadows)[k]; }
  vec3 terrain_colour(uint k) const {
    const uint bits = terrain_maps->colours[k];
    const vec3 root = vec3(bits & 1023U, (bits >> 10U) & 1023U, bits >> 20U) / 1023.0;
    return root * root;
  }
#include "shaders/physics/terrain.glsl"
#include "shaders/physics/clouds.glsl"
  bool has_ground_maps() const { return ground_maps != nullptr; }
  const GroundShape& ground_shape() const { return ground_maps->head.shape; }
  uint ground_albedo_first(uint level) const { return ground_maps->head.albedo_first[level]; }
  uint ground_water_first(uint level) const { return ground_maps->head.water_first[level]; }
  real ground_glint_share(uint i) const { return ground_maps->head.glint_share[i]; }
  vec3 ground_albedo_texel(uint k) const {
    const uint bits = (*ground_maps->albedo)[k];
    const vec3 root = vec3(bits & 1023U, (bits >> 10U) & 1023U, bits >> 20U) / 1023.0;
    return root * root;
  }
  real ground_water_texel(uint k) const {
    return (((*ground_maps->water)[k >> 2U] >> (8U * (k & 3U))) & 255U) / 255.0;
  }
#include "shaders/physics/ocean_glint.glsl"
#include "shaders/physics/ground_map.glsl"
  bool bodies_stand_aside() const { return false; }
#include "shaders/physics/bodies.glsl"
  bool has_terrain() const { return terrain_maps != nullptr; }
#include "shaders/physics/things.glsl"
  real sun_share(const Ray& /*ray*/, real /*t*/, real /*width*/) const { return 1.0; }
  vec3 diffuse_share(const Ray& /*ray*/, real /*t*/) const { return vec3(1.0); }
#include "shaders/physics/medium.glsl"
#include "shaders/physics/polarisation.glsl"
#include "shaders/physics/stokes.glsl"
#include "shaders/physics/segment.glsl"
#include "shaders/physics/quadrature.glsl"
#include "shaders/physics/step_plan.glsl"
#include "shaders/physics/lut_mapping.glsl"
#include "shaders/physics/transmittance.glsl"
#include "shaders/physics/transmittance_lut.glsl"
  uint sun_steps = 0;  // 0: sunlight from the table; else by a march of so many steps, as in `nested`
  vec3 transmittance_to_top(PlanetData planet, real h, real mu) {
    return sun_steps > 0 ? exp(-optical_depth_to_top(planet, h, mu, sun_steps)) : table_transmittance(planet, h, mu);
  }
  // Without a table, where the air bends light.
  vec3 seen_transmittance(PlanetData planet, real h, real mu) {
    return refraction ? exp(-optical_depth_to_top(planet, h, mu, kTransmittanceSteps))
                      : transmittance_to_top(planet, h, mu);
  }
  real bending_along(PlanetData planet, real h, real mu) {
    return refraction ? bending_to_top(planet, h, mu, kBendingSteps) : 0.0;
  }
  Sight sight_of(const vec3& direction) {
    return sight_from(scene.planet, scene.camera.altitude, vec3(0.0), direction, scene.sun.direction);
  }
  bool disc_is_hidden(const vec3& direction) {
    return hits_thing(nearest_thing(scene.planet, sight_of(direction), kNoBody));
  }
#include "shaders/physics/sun_disc.glsl"
#include "shaders/physics/sunlight.glsl"
  vec3 night_table(real x, real y) const {
    return night_sky.fetch((x + 0.5) / night_sky.width, (y + 0.5) / night_sky.height);
  }
  vec3 night_texel(uint x, uint y) const { return night_table(real(x), real(y)); }
#include "shaders/physics/night_sky.glsl"
#include "shaders/physics/from_space.glsl"
#include "shaders/physics/march.glsl"
#include "shaders/physics/spread.glsl"
#include "shaders/physics/multiple_scattering.glsl"
#include "shaders/physics/layers.glsl"
#include "shaders/physics/sky_view_mapping.glsl"
#include "shaders/physics/columns.glsl"
#include "shaders/physics/analytic.glsl"
#include "shaders/physics/zenith_density.glsl"
#include "shaders/physics/irradiance.glsl"
#include "shaders/physics/moment_places.glsl"
#include "shaders/physics/moments.glsl"
#include "shaders/physics/orders.glsl"
#include "shaders/physics/ground_view.glsl"
#include "shaders/physics/ground_extinction.glsl"
#include "shaders/physics/order_tail.glsl"
#include "shaders/physics/sky_factors.glsl"
#include "shaders/physics/shells.glsl"
#include "shaders/physics/shell_march.glsl"
  vec3 fetch_share(uint block, uint layer, vec2 place) const {
    const real column = (block + (0.5 + place.x * (0.5 * light_shares.width - 1.0)) / (0.5 * light_shares.width)) / 2.0;
    const real rows = static_cast<real>(light_shares.height) / (kLightLayers + 1U);
    return light_shares.fetch(column, (layer + (0.5 + place.y * (rows - 1.0)) / rows) / (kLightLayers + 1.0));
  }
  vec3 fetch_slope_share(vec2 place) const { return fetch_share(kShareAlong, kLightLayers, place); }
  vec3 fetch_cap(uint block, real x, real y, uint size) const {
    const real column = (size * kCapAngles + 0.5 + x * (kCapAngles - 1.0)) / (kCapAngles * kCapSizes);
    const real row = (block * kCapTurns + 0.5 + y * (kCapTurns - 1.0)) / (2.0 * kCapTurns);
    return sky_caps.texels.empty() ? vec3(1.0) : sky_caps.fetch(column, row);
  }
  real fetch_base(vec2 place) const { return light_bases.fetch_unit(place.x, place.y).x; }
  vec3 fetch_open(uint block, uint direction, real row, real slice) const {
    const auto low = std::min(static_cast<uint>(slice), kOpenSlices);
    const real part = slice - low;
    const real column = block * kLightDirections + direction + 0.5;
    const auto at = [&](uint k) {
      return open_light_slices[k].fetch(column / (3.0 * kLightDirections), (row + 0.5) / kOpenRows);
    };
    return at(low) * (1.0 - part) + at(low + 1U) * part;
  }
#include "shaders/physics/surface_light.glsl"
#include "shaders/physics/terrain_light.glsl"
#include "shaders/physics/sphere_light.glsl"
#include "shaders/physics/thing_open.glsl"
#include "shaders/physics/thing_shares.glsl"
#include "shaders/physics/sky_caps.glsl"
#include "shaders/physics/things_light.glsl"
#include "shaders/physics/thing_light.glsl"
#include "shaders/physics/sky_table.glsl"
#include "shaders/physics/space_table.glsl"
#include "shaders/physics/aerial_volume.glsl"
  // clang-format on
};

#undef CODE
#undef UNROLL

}  // namespace airlight::physics
