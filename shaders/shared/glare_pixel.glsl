// The glare of the sun at a pixel: of its disc's points near by, of their sum further off, where the two are one.
#extension GL_EXT_scalar_block_layout : require
#define real float
#include "shared/scene.h"
#include "shared/tables.h"

layout(scalar, set = 0, binding = 7) uniform SceneBlock { SceneData scene; };

#include "physics/phase.glsl"
#include "physics/geometry.glsl"
#include "physics/environment.glsl"
#include "physics/camera.glsl"
#include "shared/picture_ray.glsl"
#include "physics/glare.glsl"

struct GlarePoint {
  vec4 direction;   // w: from this angle on, the first point stands for all
  vec4 irradiance;  // w: how wide the point is
};
// The sum first, then the points.
layout(scalar, set = 0, binding = 8) readonly buffer Sources { GlarePoint values[]; } sources;

vec3 glare_at(uvec2 pixel, uint points, float pixel_blur) {
  ViewRay ray = picture_ray(pixel);
  GlarePoint all = sources.values[0];
  bool is_far = angle_between(ray.direction, all.direction.xyz) > all.direction.w;
  uint first = is_far ? 0u : 1u;
  uint end = !ray.inside ? first : is_far ? 1u : points;
  vec3 sum = vec3(0.0);
  for (uint i = first; i < end; i++) {
    GlarePoint point = sources.values[i];
    float blur = sqrt(point.irradiance.w * point.irradiance.w + pixel_blur * pixel_blur);
    sum += point.irradiance.xyz * glare_spread(angle_between(ray.direction, point.direction.xyz), blur);
  }
  return sum;
}
