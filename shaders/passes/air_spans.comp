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

layout(local_size_x = 64) in;
layout(push_constant, scalar) uniform Push {
  uint count;
  uint steps;
};

// Place in the picture in pixels from the upper left corner, distance in km, unused.
layout(scalar, set = 0, binding = 8) readonly buffer Spans { vec4 values[]; } spans;
// Radiance and transmittance in turn.
layout(scalar, set = 0, binding = 9) writeonly buffer SpanAir { vec4 values[]; } air_out;

void main() {
  uint i = gl_GlobalInvocationID.x;
  if (i >= count) {
    return;
  }
  vec4 span = spans.values[i];
  ViewRay view = view_ray(scene.camera, kProjection, span.x, span.y);
  Ray ray = ray_up_to(scene.planet, scene.camera.altitude, view.direction.y, air_ray(view.direction), span.z);
  SkyFactors air = scene_air_factors(ray, steps);
  air_out.values[2u * i] = vec4(phased(air, phases(ray.nu)) * scene.sun.irradiance, 1.0);
  air_out.values[2u * i + 1u] = vec4(air.transmittance, 1.0);
}
