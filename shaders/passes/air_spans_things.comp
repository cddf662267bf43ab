#version 460
#extension GL_GOOGLE_include_directive : require
// air_spans.comp with the shadows of the scene's things in the air.
#define AIRLIGHT_SUN_SHARE
#define AIRLIGHT_COARSE_SLOPES
#include "shared/device.glsl"
#include "shared/tables.glsl"
#include "shared/moment_table.glsl"
#include "shared/picture_ray.glsl"
#include "shared/thing_march.glsl"

layout(local_size_x = 64) in;
layout(push_constant, scalar) uniform Push {
  uint span_columns;
  uint span_count;
  uint first_row;
  uint steps;
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
  Sight sight = sight_of(vec3(0.0), view_ray(scene.camera, kProjection, span.place.x, span.place.y).direction);
  float up_to = optical_length(scene.planet, sight.from.h, sight.track.mu, span.distance_);
  Ray ray = ray_up_to(scene.planet, sight.from.h, sight.track.mu, sight.ray, up_to);
  SkyFactors air = factors_past_things(sight, ray, steps);
  Phases seen = phases(seen_cosine(scene.sun, ray.mu, ray.nu));
  write_air(span.index, phased(air, seen) * scene.sun.irradiance, air.transmittance);
}
