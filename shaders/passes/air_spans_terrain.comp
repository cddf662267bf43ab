#version 460
#extension GL_GOOGLE_include_directive : require
// air_spans.comp with terrain's shadow in the air.
#define AIRLIGHT_SUN_SHARE
#include "shared/device.glsl"
#include "shared/tables.glsl"
#include "shared/moment_table.glsl"
#include "shared/picture_ray.glsl"
#include "shared/terrain_maps.glsl"
#include "shared/terrain_light_maps.glsl"
#include "physics/terrain.glsl"

layout(constant_id = 28) const uint kShafts = 1u;
#include "shared/terrain_march.glsl"
#include "physics/aerial_volume.glsl"

layout(local_size_x = 64) in;
layout(push_constant, scalar) uniform Push {
  uint spans_count;
  uint steps;
  float shadow_end;
};

// Place in the picture in pixels from the upper left corner, distance in km, unused.
layout(std430, set = 0, binding = 8) readonly buffer Spans { vec4 values[]; } spans;
// Radiance and transmittance in turn.
layout(std430, set = 0, binding = 9) writeonly buffer SpanAir { vec4 values[]; } air_out;

void main() {
  uint i = gl_GlobalInvocationID.x;
  if (i >= spans_count) {
    return;
  }
  vec4 span = spans.values[i];
  float h = scene.camera.altitude;
  vec3 direction = view_ray(scene.camera, kProjection, span.x, span.y).direction;
  current_track = ground_track(h, direction);
  Ray whole = air_ray(direction);
  Ray ray = ray_up_to(scene.planet, h, direction.y, whole, span.z);
  ray.at_ground = false;
  float before = air_entry(scene.planet, h, direction.y).distance_;
  // The picture's steps over the part in which shadows stand, as dense over a shorter way.
  Ray shaded = whole;
  shaded.length_ = min(whole.length_, max(track_distance(scene.planet, current_track, shadow_end) - before, 0.0));
  shaded.at_ground = false;
  uint near = steps;
  if (shell_rows() == 0u && shaded.length_ > 0.0) {
    near = steps_up_to(scene.planet, shaded, min(ray.length_, shaded.length_), steps);
  }
  SkyFactors air = terrain_factors(ray, direction, before, shadow_end, near, max(steps / 2u, 1u));
  air_out.values[2u * i] = vec4(phased(air, phases(whole.nu)) * scene.sun.irradiance, 1.0);
  air_out.values[2u * i + 1u] = vec4(air.transmittance, 1.0);
}
