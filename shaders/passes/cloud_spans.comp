#version 460
#extension GL_GOOGLE_include_directive : require
// Puts a cloud into the air before things (air_spans.comp): the march ends at each thing.
#define AIRLIGHT_CLOUD_APART
#define AIRLIGHT_CLOUD_SPANS
#include "shared/device.glsl"
#include "shared/tables.glsl"
#include "shared/moment_table.glsl"
#include "shared/picture_ray.glsl"
#include "physics/shells.glsl"
#include "physics/cloud_air.glsl"
#include "shared/sky_table.glsl"
#include "physics/sky_table.glsl"
#include "physics/space_table.glsl"
#include "physics/aerial_volume.glsl"
#include "shared/factor_place.glsl"
#include "shared/aerial_volume.glsl"
#include "shared/volume_fetch.glsl"

layout(push_constant, scalar) uniform Push {
  uint span_columns;
  uint span_count;
  uint first_row;
  float step;       // km, the shortest
  float step_rise;  // of the step over the distance
};
#include "shared/span_list.glsl"
#include "shared/cloud_pixels.glsl"

layout(scalar, set = 0, binding = 9) buffer SpanAir { vec3 values[]; } air_out;  // radiance, transmittance

void main() {
  Span span = span_of(gl_GlobalInvocationID.xy);
  if (!span.is_there || nothing_there(span)) {
    return;
  }
  vec3 direction = view_ray(scene.camera, kProjection, span.place.x, span.place.y).direction;
  AirRay of = ray_through_clouds(uvec2(span.place), direction);
  PastCloud past = past_cloud(of, min(span.distance_ - of.before, of.ray.length_));
  air_out.values[2u * span.index] = light_past(past, air_out.values[2u * span.index]);
  air_out.values[2u * span.index + 1u] *= past.through;
}
