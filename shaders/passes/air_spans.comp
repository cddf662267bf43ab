#version 460
#extension GL_GOOGLE_include_directive : require
// The air between the camera and things: in-scattered radiance and transmittance along listed rays of the picture, each
// up to a distance, by the view march on the table of moments. One thread a ray.
#include "shared/device.glsl"
#include "shared/tables.glsl"
#include "shared/moment_table.glsl"
#include "shared/picture_ray.glsl"
#include "physics/orders.glsl"
#include "physics/sky_factors.glsl"
#include "shared/shell_table.glsl"
#include "physics/aerial_volume.glsl"

layout(local_size_x = 256) in;
layout(push_constant, scalar) uniform Push {
  uint spans_count;
  uint steps;
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
  ViewRay view = view_ray(scene.camera, kProjection, span.x, span.y);
  Ray whole = air_ray(view.direction);
  Ray ray = ray_up_to(scene.planet, scene.camera.altitude, view.direction.y, whole, span.z);
  // Where air is cut into shells, steps follow from the edges that a ray crosses.
  uint count = shell_rows() > 0u ? steps : steps_up_to(scene.planet, whole, ray.length_, steps);
  SkyFactors air = scene_air_factors(ray, count);
  air_out.values[2u * i] = vec4(phased(air, phases(ray.nu)) * scene.sun.irradiance, 1.0);
  air_out.values[2u * i + 1u] = vec4(air.transmittance, 1.0);
}
