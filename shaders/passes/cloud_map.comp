#version 460
#extension GL_GOOGLE_include_directive : require
// Marches the rays of the map of clouds that mirrors show. Of several fields the farther ones come first.
#define AIRLIGHT_CLOUD_SPANS
#define AIRLIGHT_FEW_SLICES
#include "shared/cloud_over_air.glsl"
#define AIRLIGHT_CLOUD_MAP buffer
#include "shared/cloud_map.glsl"

// A ray past a nearer field and then past `far`, for light behind that outshines what is taken of it.
CloudMapRay with_farther(CloudMapRay near, CloudMapRay far) {
  return CloudMapRay(near.sent + max(far.sent - near.taken, vec3(0.0)) * near.through,
                     far.taken + max(near.taken - far.sent, vec3(0.0)) / max(far.through, 1e-6),
                     near.through * far.through, near.beam * far.beam);
}

void main() {
  uvec2 at = gl_GlobalInvocationID.xy;
  if (at.x >= width || at.y >= height) {
    return;
  }
  AirRay of = ray_through_clouds(at, cloud_map_direction(at, width));
  PastCloud past = past_cloud(of, of.ray.length_);
  CloudMapRay ray = CloudMapRay(past.sent, past.taken, past.through, pow(past.through, 1.0 / cloud().scale));
  uint index = at.y * width + at.x;
  if (kFurther == 1u) {
    ray = with_farther(ray, cloud_map.values[index]);
  }
  cloud_map.values[index] = ray;
}
