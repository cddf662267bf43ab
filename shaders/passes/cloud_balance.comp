#version 460
#extension GL_GOOGLE_include_directive : require
// How much light there is below a cloud, among and above it, over that of a clear sky: light from below that the cloud
// sends down again included. One thread.
#include "shared/device.glsl"
#include "shared/tables.glsl"
#include "shared/moment_table.glsl"
#include "physics/shells.glsl"
#include "physics/cloud_air.glsl"
#include "shared/cloud_volume.glsl"
#include "shared/cloud_sunlight.glsl"
#include "physics/cloud_march.glsl"
#include "shared/cloud_shade.glsl"
#include "shared/cloud_around.glsl"

layout(local_size_x = 64) in;
layout(push_constant, scalar) uniform Push {
  float mu_sun;  // where the clouds' light is found
  float open;    // km, altitude up to which there is air alone above the field
};
layout(set = 0, binding = 17) uniform sampler2D cloud_sums_lut;  // passes/cloud_sums.comp
layout(scalar, set = 0, binding = 18) buffer Light { CloudLight values[]; } light_out;  // of fields, the lowest first

// Light from all around in clear air, but for that from about the sun, and its parts from above and from below.
struct Sides {
  vec3 around;
  vec3 above;
  vec3 below;
};

// Optical depth of the air above an altitude.
vec3 depth_above(float h) { return -log(max(transmittance_to_sun(scene.planet, h, 1.0), vec3(1e-30))); }

// Irradiance of the ground.
vec3 light_on_ground(float mu_sun) {
  return transmittance_to_sun(scene.planet, 0.0, mu_sun) * ground_facing(scene.planet, mu_sun) +
         moment_ground_irradiance(scene.moments, mu_sun);
}

// Light that clouds shade as the sun's rays are shaded: the sun's and that from about it.
vec3 beam_at(float h, float mu_sun) {
  return transmittance_to_sun(scene.planet, h, mu_sun) +
         light_around_sun(air_moment_coordinate(scene.moments, h, mu_sun), h, mu_sun);
}

// Irradiance of a level plane from above by all other light. `facing`: the sun's zenith cosine, as it is seen.
vec3 sky_at(float h, float mu_sun, float facing) {
  MomentCoordinate at = air_moment_coordinate(scene.moments, h, mu_sun);
  return max(level_irradiance(at, 1.0) - light_around_sun(at, h, mu_sun) * facing, vec3(0.0));
}

// By moments of degree 1 the ground sends too much, since they do not know that light changes abruptly at its horizon:
// what it sends is known. The excess fades upward about as the fourth power of the air above (core/CLOUDS.md).
Sides sides_at(float h, float mu_sun) {
  MomentCoordinate at = air_moment_coordinate(scene.moments, h, mu_sun);
  vec3 sent = 2.0 * scene.planet.ground_albedo * light_on_ground(mu_sun);
  vec3 excess = light_from_side(air_moment_coordinate(scene.moments, 0.0, mu_sun), -1.0) - sent;
  vec3 left = min(depth_above(h) / max(depth_above(0.0), vec3(1e-30)), vec3(1.0));
  Sides sides;
  sides.around = max(light_from_all_around(at) - light_around_sun(at, h, mu_sun), vec3(1e-30));
  sides.below = clamp(light_from_side(at, -1.0) - excess * left * left * left * left, vec3(0.0), sides.around);
  sides.above = sides.around - sides.below;
  return sides;
}

// What air of this vertical optical depth leaves of light that is even over a hemisphere: E_2, with E_1 taken as
// exp(-x) ln(1 + exp(-0.577) / x). It is 0.012 too large at a depth of 0.1, 0.06 at most.
vec3 even_transmittance(vec3 depth) {
  vec3 x = max(depth, vec3(1e-6));
  return exp(-x) * (vec3(1.0) - x * log(vec3(1.0) + 0.5614595 / x));
}

// Of light from below that is even over a hemisphere, what the air between two altitudes, km, sends down again, for it
// and for a level plane: half of what it turns. Forward scattering counts as none, by the similarity of 1 - chi_1.
vec3 sent_back(float low, float high) {
  const uint kSteps = 32u;
  vec3 turning = vec3(0.0);
  for (uint k = 0u; k < kSteps; k++) {
    float at = (float(k) + 0.5) / float(kSteps);
    Densities d = densities_at(low + (high - low) * at * at);
    UNROLL for (uint i = 0u; i < kMaxMedia; i++) {
      if (i < medium_count()) {
        MediumData m = medium(i);
        turning += m.scattering * (vec3(1.0) - m.legendre[1]) * (d.of[i] * 2.0 * at / float(kSteps));
      }
    }
  }
  turning *= max(high - low, 0.0);
  return 0.5 * (vec3(1.0) - exp(-turning) + turning * even_transmittance(turning));
}

void main() {
  if (gl_GlobalInvocationID.x > 0u) {
    return;
  }
  CloudData c = cloud();
  vec4 sum = texelFetch(cloud_sums_lut, ivec2(0), 0);
  float h = optical_altitude_at(c.base);
  float facing = max(seen_sun_mu(scene.planet, h, mu_sun), 0.0);
  vec3 direct = beam_at(h, mu_sun) * facing;
  vec3 sky = sky_at(h, mu_sun, facing);
  vec3 clear = max(direct + sky, vec3(1e-30));
  vec3 up = level_irradiance(air_moment_coordinate(scene.moments, h, mu_sun), -1.0);
  for (uint below = 0u; below < kField; below++) {
    up = max(up + light_out.values[below].above * clear, vec3(0.0));
  }
  // The ordinates' sun has irradiance 1 across its rays.
  float across = length(vec3(c.sunward_east, c.sunward_north, 1.0));
  float through = sum.w + sum.x * across;
  vec3 to_and_fro = max(vec3(1.0) - up / clear * (sum.z / kPi), vec3(0.05));  // between ground and field
  vec3 below = (direct * through + sky * sum.y / kPi) / clear / to_and_fro;

  // What the field adds to the light that rises from its top, which the air above sends down again in part.
  float top = optical_altitude_at(c.top);
  vec3 sun_above = beam_at(top, mu_sun) * facing;
  vec3 falling_sky = sky_at(top, mu_sun, facing);
  vec3 clear_above = max(sun_above + falling_sky, vec3(1e-30));
  vec4 risen = texelFetch(cloud_sums_lut, ivec2(2, 0), 0);
  vec3 added = sun_above * (risen.x * across) + falling_sky * (risen.y / kPi) + up * (below * (risen.z / kPi) - 1.0);
  vec3 let_through = vec3(sum.y / kPi) / to_and_fro;
  vec3 again = vec3(risen.y / kPi) + up / clear * let_through * (risen.z / kPi);
  vec3 back = sent_back(c.top, open);
  vec3 returned = max(back * added / (vec3(1.0) - back * again), -falling_sky);
  if (c.repeats == 0u) {
    returned = vec3(0.0);  // one cloud alone sends little: the air above spreads it over many times its width
  }
  CloudLight light;
  light.below = below + returned / clear * let_through;
  light.above = (added + returned * again) / clear_above;
  light.returned = returned / clear_above;
  light.direct = sum.w;
  vec3 sun_on_ground = transmittance_to_sun(scene.planet, 0.0, mu_sun);
  light.near_sun = (beam_at(0.0, mu_sun) - sun_on_ground) / max(sun_on_ground, vec3(1e-20));
  light.forward = texelFetch(cloud_sums_lut, ivec2(1, 0), 0).w;
  Sides base = sides_at(h, mu_sun);
  Sides summit = sides_at(top, mu_sun);
  // Of the light from above at the base, and from below at the top, the rest comes from the air in between.
  vec3 between = max(depth_above(h) - depth_above(top), vec3(0.0));
  vec3 through_air = even_transmittance(between);
  vec3 from_sky = min(summit.above * through_air, base.above);
  vec3 falling_air = base.above - from_sky;
  vec3 rising_air = max(summit.below - base.below * through_air, vec3(0.0));

  // In the middle of the air below the field: light of the field, of the ground, or of that air, which sends on
  // sunlight past the field and its own light.
  float middle = optical_altitude_at(0.5 * c.base);
  vec3 of_field = even_transmittance(max(depth_above(middle) - depth_above(h), vec3(0.0)));
  vec3 of_ground = even_transmittance(max(depth_above(0.0) - depth_above(middle), vec3(0.0)));
  vec3 on_ground = 2.0 * scene.planet.ground_albedo * light_on_ground(mu_sun);
  vec3 lit_ground = on_ground * of_ground;
  MomentCoordinate in_middle = air_moment_coordinate(scene.moments, middle, mu_sun);
  vec3 of_air = light_from_all_around(in_middle) - light_around_sun(in_middle, middle, mu_sun);
  of_air = max(of_air - base.above * of_field - lit_ground, vec3(0.0));
  vec3 around = of_air + base.above * of_field + lit_ground;
  float past = exp(-mean_shade(c, way_through_shell(scene.planet.ground_radius, c, 0.5 * c.base,
                                                      seen_sun_mu(scene.planet, middle, mu_sun))));
  vec3 beam = beam_at(middle, mu_sun);
  vec3 sources = max(beam + around, vec3(1e-30));
  vec3 scale = vec3(1.0) / max(around - of_air * around / sources, vec3(1e-30));
  vec3 sun_leaving = direct * across;
  light.under.sun = sun_leaving * of_field * scale;
  light.under.sky = from_sky / (2.0 * kPi) * of_field * scale;
  light.under.ground = up * light.below / kPi * of_field * scale;
  light.under.rest = (of_air * beam * past / sources + lit_ground * light.below) * scale;
  vec4 falling = texelFetch(cloud_sums_lut, ivec2(1, 0), 0);
  light.falling = falling.xyz;
  light.air_below = share_around(light.under, light.falling);
  vec3 fallen = falling_air * of_field * scale;  // as if nothing shaded what the air in the field sends

  // At the base: what comes up is sent by the ground and by the air below.
  vec3 air_share = (beam * past + around * (light.air_below + fallen)) / sources;
  vec3 ground_share = on_ground * even_transmittance(max(depth_above(0.0) - depth_above(h), vec3(0.0)));
  ground_share = min(ground_share / max(base.below, vec3(1e-30)), vec3(1.0));
  light.rising = mix(air_share, light.below, ground_share);
  vec3 sent = base.below * light.rising;
  light.at_base.sun = sun_leaving / base.around;
  light.at_base.sky = from_sky / (2.0 * kPi) / base.around;
  light.at_base.ground = sent / (2.0 * kPi) / base.around;
  light.at_base.rest = falling_air / base.around;  // likewise

  // At the top. The sky that is reflected counts by what falls on a level plane.
  light.at_top.sun = sun_above * across / summit.around;
  light.at_top.sky = (falling_sky + returned) / kPi / summit.around;
  light.at_top.ground = sent * through_air / (2.0 * kPi) / summit.around;
  light.at_top.rest = (summit.above - 2.0 * falling_sky) / summit.around;

  // What the air in between sends, of sunlight and of light from all around, and what of it leaves the field: by
  // reciprocity as light from there would reach it.
  uint levels = uint(textureSize(cloud_sums_lut, 0).x) - 4u;
  vec3 beam_between = beam_at(0.5 * (h + top), mu_sun);
  vec3 around_between = 0.5 * (base.around + summit.around);
  vec3 falls = vec3(0.0);
  vec3 rises = vec3(0.0);
  for (uint k = 0u; k < levels; k++) {
    int texel = int(4u + k);
    vec4 level = texelFetch(cloud_sums_lut, ivec2(texel, 0), 0);
    vec2 lit = texelFetch(cloud_sums_lut, ivec2(texel, 1), 0).xy;
    float low = float(k) / float(levels);
    float high = float(k + 1u) / float(levels);
    vec3 share = mix(share_around(light.at_base, level.xyz), share_around(light.at_top, level.xyz), 0.5 * (low + high));
    vec3 both = (beam_between + around_between) * (2.0 * kPi) * max(vec3(1.0) - through_air, vec3(1e-6));
    vec3 nearer = even_transmittance(between * low) - even_transmittance(between * high);
    vec3 farther = even_transmittance(between * (1.0 - high)) - even_transmittance(between * (1.0 - low));
    falls += nearer * (beam_between * lit.y + around_between * share * level.z) / both;
    rises += farther * (beam_between * lit.x + around_between * share * level.y) / both;
  }
  light.under.rest += fallen * falls;
  light.air_below += fallen * falls;
  light.at_base.rest = falling_air * falls / base.around;
  light.at_top.rest += rising_air * rises / summit.around;
  vec4 rising = texelFetch(cloud_sums_lut, ivec2(3, 0), 0);
  light.air_above = share_around(light.at_top, vec3(rising.x, 2.0 * kPi + rising.y, rising.z));
  const float kHigher = 4.0;  // km
  vec3 upward = depth_above(top);
  vec3 higher = depth_above(optical_altitude_at(c.top + kHigher));
  light.fading = vec3(1.0) - even_transmittance(upward);
  light.scale_height = kHigher / max(log(max(upward.z, 1e-9) / max(higher.z, 1e-12)), 1e-2);
  light_out.values[kField] = light;
}
