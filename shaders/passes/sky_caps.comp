#version 460
#extension GL_GOOGLE_include_directive : require
// What bodies hide of the sky (physics/sky_caps.glsl), at the place of the body that looks largest: one workgroup, whose
// threads each find the sky's light in one direction and sum texels over all of them.
#include "shared/device.glsl"
#include "shared/tables.glsl"
#include "shared/moment_table.glsl"
#include "physics/orders.glsl"
#include "physics/sky_factors.glsl"
#include "shared/shell_table.glsl"
#include "shared/things.glsl"
#include "shared/thing_light.h"
#include "physics/surface_light.glsl"

vec3 fetch_cap(uint block, float x, float y, uint size) { return vec3(1.0); }
#include "physics/sky_caps.glsl"

const uint kTurns = kCapSpokes / 2u;  // a ring's other half is as bright
const uint kThreads = 128u;           // at least kCapRings * kTurns

layout(local_size_x = kThreads) in;
layout(set = 0, binding = 4) uniform writeonly image2D caps_out;
layout(push_constant, scalar) uniform Push { uint steps; };

shared vec4 light[kThreads];  // over its mean all around, and the zenith cosine where not negative

Place place_among_bodies() {
  vec3 among = vec3(0.0);
  float largest = -1.0;
  for (uint k = 0u; k < body_count(); k++) {
    SphereData ball = ball_of_body(k);
    float looks = ball.radius / max(length(ball.centre), 1e-9);
    among = looks > largest ? ball.centre : among;
    largest = max(looks, largest);
  }
  return place_at(scene.planet, scene.camera.altitude, among);
}

vec4 light_along(AboutSun direction) {
  Place place = place_among_bodies();
  PlaceSun sun = sun_at(scene.planet, place, scene.sun.direction);
  float mu = zenith_cosine(direction, clamp(dot(place.up, sun.seen), -1.0, 1.0));
  Ray ray = ray_in_atmosphere(scene.planet, sun.h, mu, sun.mu, direction.c);
  SkyFactors air = scene_air_factors(ray, steps);
  vec3 sky = phased(air, phases(seen_cosine(scene.sun, ray.mu, ray.nu))) + scene_ground_light(ray, air.transmittance);
  vec3 mean = mean_sky_irradiance(scene.moments, sun) / kPi;
  const float kMost = 6e4;  // that 16 bits hold
  return vec4(min(sky / max(mean, vec3(1e-30)), vec3(kMost)), max(mu, 0.0));
}

void store_cap(uint texel) {
  uvec2 at = uvec2(texel % kCapAngles, texel / kCapAngles % kCapTurns);
  uint size = texel / (kCapAngles * kCapTurns);
  vec2 middle = vec2(at) / vec2(kCapAngles - 1u, kCapTurns - 1u);
  AboutSun axis = cap_axis(CapPlace(middle.x, middle.y));
  float z = float(size) / float(kCapSizes - 1u);
  float rim = sqrt(max(2.0 - 2.0 * sqrt(max(1.0 - z * z * z * z, 0.0)), 0.0));
  vec4 level = vec4(0.0);  // and of even light
  vec4 around = vec4(0.0);
  for (uint ring = 0u; ring < kCapRings; ring++) {
    CapRing r = cap_ring(ring);
    for (uint spoke = 0u; spoke < kCapSpokes; spoke++) {
      float weight = r.weight * within_cap(rim, chord_between(cap_direction(r, spoke), axis), r.weight);
      vec4 one = light[ring * kTurns + min(spoke, kCapSpokes - 1u - spoke)];
      around += vec4(one.rgb, 1.0) * weight;
      level += vec4(one.rgb, 1.0) * (weight * one.a);
    }
  }
  around.rgb /= max(around.a, 1e-9);
  level.rgb = level.a > 1e-9 ? level.rgb / level.a : around.rgb;
  ivec2 to = ivec2(size * kCapAngles + at.x, at.y);
  imageStore(caps_out, to, vec4(level.rgb, 1.0));
  imageStore(caps_out, to + ivec2(0, kCapTurns), vec4(around.rgb, 1.0));
}

void main() {
  uint thread = gl_LocalInvocationIndex;
  light[thread] = light_along(cap_direction(cap_ring(min(thread / kTurns, kCapRings - 1u)), thread % kTurns));
  barrier();
  for (uint texel = thread; texel < kCapAngles * kCapTurns * kCapSizes; texel += kThreads) {
    store_cap(texel);
  }
}
