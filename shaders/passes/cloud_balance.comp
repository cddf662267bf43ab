#version 460
#extension GL_GOOGLE_include_directive : require
// How much light there is below a cloud, over that of a clear sky: light from below that the cloud sends down again
// included. One thread.
#include "shared/device.glsl"
#include "shared/tables.glsl"
#include "shared/moment_table.glsl"
#include "physics/shells.glsl"
#include "physics/cloud_air.glsl"
#include "shared/cloud_volume.glsl"
#include "shared/cloud_sunlight.glsl"
#include "physics/cloud_march.glsl"
#include "shared/cloud_shade.glsl"

layout(local_size_x = 64) in;
layout(set = 0, binding = 17) uniform sampler2D cloud_sums_lut;  // passes/cloud_sums.comp
layout(scalar, set = 0, binding = 18) buffer Light { CloudLight values[]; } light_out;  // of fields, the lowest first

void main() {
  if (gl_GlobalInvocationID.x > 0u) {
    return;
  }
  CloudData c = cloud();
  vec4 sum = texelFetch(cloud_sums_lut, ivec2(0), 0);
  float mu_sun = scene.sun.direction.y;
  float h = optical_altitude_at(c.base);
  float facing = max(seen_sun_mu(scene.planet, h, mu_sun), 0.0);
  MomentCoordinate at = air_moment_coordinate(scene.moments, h, mu_sun);
  vec3 direct = transmittance_to_sun(scene.planet, h, mu_sun) * facing;
  vec3 sky = level_irradiance(at, 1.0);
  vec3 clear = max(direct + sky, vec3(1e-30));
  vec3 up = level_irradiance(at, -1.0);
  for (uint below = 0u; below < kField; below++) {
    up = max(up + light_out.values[below].above * clear, vec3(0.0));
  }
  // The ordinates' sun has irradiance 1 across its rays.
  float across = length(vec3(c.sunward_east, c.sunward_north, 1.0));
  float through = sum.w + sum.x * across;
  vec3 first = (direct * through + sky * sum.y / kPi) / clear;
  CloudLight light;
  light.below = first / max(vec3(1.0) - up / clear * (sum.z / kPi), vec3(0.05));
  light.direct = sum.w;
  light.forward = texelFetch(cloud_sums_lut, ivec2(1, 0), 0).w;
  // Light from all around in the middle of the air below, by where it comes from: the cloud, the ground, or that air,
  // which sends on sunlight past the field and its own light.
  float middle = optical_altitude_at(0.5 * c.base);
  vec3 around = light_from_all_around(air_moment_coordinate(scene.moments, middle, mu_sun));
  vec3 lit_ground = 2.0 * scene.planet.ground_albedo * clear;
  vec3 from_sky = light_from_side(at, 1.0);
  vec3 of_air = max(around - from_sky - lit_ground, vec3(0.0));
  float past = exp(-mean_shade(c, way_through_shell(scene.planet.ground_radius, c, 0.5 * c.base,
                                                      seen_sun_mu(scene.planet, middle, mu_sun))));
  vec3 beam = transmittance_to_sun(scene.planet, middle, mu_sun);
  vec3 sources = max(beam + around, vec3(1e-30));
  vec4 falling = texelFetch(cloud_sums_lut, ivec2(1, 0), 0);
  vec3 of_cloud = direct * (falling.x * across) + from_sky * (falling.y / (2.0 * kPi)) +
                  up * light.below * (falling.z / kPi);
  light.air_below = (of_air * beam * past / sources + of_cloud + lit_ground * light.below) /
                    max(around - of_air * around / sources, vec3(1e-30));
  vec3 air_share = (beam * past + around * light.air_below) / sources;
  vec3 sent = mix(air_share, light.below, min(0.5 * lit_ground / max(up, vec3(1e-30)), vec3(1.0)));  // over `up`
  vec4 rising = texelFetch(cloud_sums_lut, ivec2(3, 0), 0);
  float top = optical_altitude_at(c.top);
  MomentCoordinate over = air_moment_coordinate(scene.moments, top, mu_sun);
  vec3 sun_above = transmittance_to_sun(scene.planet, top, mu_sun) * facing;
  of_cloud = sun_above * (rising.x * across) + level_irradiance(over, 1.0) * (rising.y / kPi) +
             light_from_side(over, -1.0) * sent * (rising.z / (2.0 * kPi));
  light.air_above = (light_from_side(over, 1.0) + of_cloud) / light_from_all_around(over);
  vec4 risen = texelFetch(cloud_sums_lut, ivec2(2, 0), 0);
  vec3 from_above = sun_above * (risen.x * across) + level_irradiance(over, 1.0) * (risen.y / kPi);
  vec3 clear_above = max(sun_above + level_irradiance(over, 1.0), vec3(1e-30));
  light.above = (from_above + up * (light.below * (risen.z / kPi) - 1.0)) / clear_above;
  light_out.values[kField] = light;
}
