// Puts a cloud into a picture: into pixels of a list, all pixels of a tile, or listed directions.
#include "shared/cloud_output.glsl"
#define AIRLIGHT_CLOUD_LIST readonly buffer
#include "shared/cloud_list.glsl"

layout(scalar, set = 0, binding = 8) readonly buffer Directions { vec4 values[]; } directions;
layout(constant_id = 58) const uint kFromList = 0u;  // 1: pixels of cloud_list
#ifdef AIRLIGHT_THINGS
layout(scalar, set = 0, binding = 32) buffer Seen { ThingsSeen values[]; } seen;
#endif

// Of the picture behind, as clouds leave it.
struct Clouded {
  vec3 light;
  float through;  // PastCloud, of what stands farthest
  vec3 air;
};

#ifdef AIRLIGHT_THINGS
// Where things fill a part of the pixel, that part ends at them and the rest behind them.
Clouded clouded(AirRay of, vec3 behind, uint index) {
  const float kFewest = 1e-4;
  ThingsSeen things = seen.values[index];
  Clouded sum = Clouded(vec3(0.0), 0.0, vec3(1.0));
  vec3 of_things = vec3(0.0);
  uint first = things.share > kFewest ? 0u : 1u;
  uint last = things.share < 1.0 - kFewest ? 2u : 1u;
  for (uint part = first; part < last; part++) {
    float share = part == 0u ? things.share : 1.0 - things.share;
    vec3 light = part == 0u ? things.light : max(behind - things.light, vec3(0.0));
    float end = part == 0u ? min(things.distance_ - of.before, of.ray.length_) : of.ray.length_;
    PastCloud past = past_cloud(of, end);
    vec3 left = light_past(past, light / share) * share;
    sum.light += left;
    of_things += part == 0u ? left : vec3(0.0);
    sum.through = past.through;
    sum.air = past.air;
  }
  if (kFields > 1u) {
    seen.values[index].light = of_things;
  }
  return sum;
}
#else
Clouded clouded(AirRay of, vec3 behind, uint index) {
  PastCloud past = past_cloud(of, of.ray.length_);
  return Clouded(light_past(past, behind), past.through, past.air);
}
#endif

void put_direction(uvec2 at) {
  vec3 direction = directions.values[at.x].xyz;
  uint index = vectors * at.x;
  Clouded now = clouded(ray_through_clouds(at, direction), radiance_out.values[index].rgb, at.x);
  radiance_out.values[index].rgb = now.light;
  radiance_out.values[index + 1u].rgb *= beam_of(now.through, cloud().scale);
  // Light of clouds is not polarised: Q and U are the air's.
  for (uint k = 2u; k < vectors; k++) {
    radiance_out.values[index + k].rgb *= now.air;
  }
}

void put_picture_pixel(uint index) {
  uvec2 pixel = uvec2(index % width, index / width);
  ViewRay view = picture_ray(pixel);
  Clouded now = clouded(ray_through_clouds(pixel, view.direction), radiance_out.values[index].rgb, index);
  put_pixel(index, now.light, view.inside, beam_of(now.through, cloud().scale), kFurther == 1u);
}

void main() {
  uvec2 at = gl_GlobalInvocationID.xy;
  if (kFromList == 1u) {
    uint i = 64u * (gl_WorkGroupID.y * kListGroups + gl_WorkGroupID.x) + gl_LocalInvocationIndex;
    if (i < cloud_list.count) {
      put_picture_pixel(cloud_list.values[i]);
    }
    return;
  }
  if (at.x >= width || at.y >= height) {
    return;
  }
  if (kProjection == kProjectionListed) {
    put_direction(at);
  } else {
    put_picture_pixel(at.y * width + at.x);
  }
}
