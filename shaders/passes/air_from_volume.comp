#version 460
#extension GL_GOOGLE_include_directive : require
// The result of air_spans.comp, taken from the aerial volume: a fetch for the mean extinction, one for each medium that
// is not folded, times its phase function here, and one for all other light.
#include "shared/device.glsl"
#include "shared/picture_ray.glsl"
#include "shared/sky_table.glsl"
#include "physics/sky_table.glsl"
#include "physics/space_table.glsl"
#include "physics/aerial_volume.glsl"
#include "shared/factor_place.glsl"
#include "shared/aerial_volume.glsl"

layout(local_size_x = 64) in;
layout(push_constant, scalar) uniform Push {
  uint span_columns;
  uint span_count;
  uint first_row;
};
#include "shared/span_list.glsl"
#include "shared/span_air_packed.glsl"

#include "shared/volume_fetch.glsl"

vec3 single_at(uint i, FactorPlace at, float w) {
  return scatters(i) ? fetch_block(single_block(i), at, w) * medium_phase(i, at.nu) : vec3(0.0);
}

void main() {
  Span span = span_of(gl_GlobalInvocationID.xy);
  if (!span.is_there) {
    return;
  }
  if (nothing_there(span)) {
    write_air(span.index, vec3(0.0), vec3(1.0));
    return;
  }
  ViewRay view = view_ray(scene.camera, kProjection, span.place.x, span.place.y);
  Ray ray = air_ray(view.direction);
  float up_to = optical_length(scene.planet, scene.camera.altitude, view.direction.y, span.distance_);
  float distance_ = clamp(up_to, 0.0, max(ray.length_, 0.0));
  FactorPlace at = factor_place(view.direction);
  float z = slice_coordinate(scene.planet, ray, distance_);
  vec2 row = vec2(texel_from_unit(z, float(kExtinctionSlices)), at.v);
  vec3 depth = textureLod(extinction_lut, row, 0.0).rgb * distance_;
  SegmentTransfer segment = segment_transfer(depth);
  float w = texel_from_unit(z, float(kSlices));
  vec3 source = fetch_block(diffuse_block(), at, w) * volume_carrier(at.nu);
  UNROLL for (uint i = 0u; i < kMaxMedia; i++) {
    source += single_at(i, at, w);
  }
  write_air(span.index, source * depth * segment.mean * scene.sun.irradiance, segment.through);
}
