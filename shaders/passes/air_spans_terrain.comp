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
  uint span_columns;
  uint span_count;
  uint first_row;
  uint steps;
  float shadow_end;
};
#include "shared/span_list.glsl"
#include "shared/span_air.glsl"

void main() {
  Span span = span_of(gl_GlobalInvocationID.xy);
  if (!span.is_there) {
    return;
  }
  if (nothing_there(span)) {
    write_air(span.index, vec3(0.0), vec3(1.0));
    return;
  }
  float h = scene.camera.altitude;
  vec3 direction = view_ray(scene.camera, kProjection, span.place.x, span.place.y).direction;
  current_track = ground_track(h, direction);
  Ray whole = air_ray(direction);
  Ray ray = ray_up_to(scene.planet, h, direction.y, whole, span.distance_);
  ray.at_ground = false;
  float before = air_entry(scene.planet, h, direction.y).distance_;
  // The picture's density of steps over the part with shadows, on a shorter way.
  Ray shaded = whole;
  shaded.length_ = min(whole.length_, max(track_distance(scene.planet, current_track, shadow_end) - before, 0.0));
  shaded.at_ground = false;
  uint near = steps;
  if (shell_rows() == 0u && shaded.length_ > 0.0) {
    near = steps_up_to(scene.planet, shaded, min(ray.length_, shaded.length_), 6u, steps);
  }
  SkyFactors air = terrain_factors(ray, direction, before, shadow_end, near, max(steps / 2u, 1u));
  write_air(span.index, phased(air, phases(whole.nu)) * scene.sun.irradiance, air.transmittance);
}
