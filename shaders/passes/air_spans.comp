#version 460
#extension GL_GOOGLE_include_directive : require
// The air between the camera and things: in-scattered radiance and transmittance along rays of the picture, each up to
// a distance, by the view march on the table of moments.
#define AIRLIGHT_HALF_RATIOS
#include "shared/device.glsl"
#include "shared/tables.glsl"
#include "shared/moment_table.glsl"
#include "shared/picture_ray.glsl"
#include "physics/orders.glsl"
#include "physics/sky_factors.glsl"
#include "shared/shell_table.glsl"
#include "physics/aerial_volume.glsl"

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
  ViewRay view = view_ray(scene.camera, kProjection, span.place.x, span.place.y);
  Ray whole = air_ray(view.direction);
  float up_to = optical_length(scene.planet, scene.camera.altitude, view.direction.y, span.distance_);
  Ray ray = ray_up_to(scene.planet, scene.camera.altitude, view.direction.y, whole, up_to);
  // Where air is cut into shells, steps follow from the edges that a ray crosses.
  uint count = shell_rows() > 0u ? steps : steps_up_to(scene.planet, whole, ray.length_, 2u, steps);
  SkyFactors air = scene_air_factors(ray, count);
  Phases seen = phases(seen_cosine(scene.sun, ray.mu, ray.nu));
  write_air(span.index, phased(air, seen) * scene.sun.irradiance, air.transmittance);
}
