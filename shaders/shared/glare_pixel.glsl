// The glare of the sun at a pixel.
#extension GL_EXT_scalar_block_layout : require
#define real float
#define CODE const
#include "shared/scene.h"
#include "shared/tables.h"
#include "shared/glare.h"

layout(scalar, set = 0, binding = 7) uniform SceneBlock { SceneData scene; };

#include "physics/phase.glsl"
#include "physics/geometry.glsl"
#include "physics/environment.glsl"
#include "physics/camera.glsl"
#include "shared/picture_ray.glsl"

// Point 0 is the sum of the points that follow.
layout(scalar, set = 0, binding = 8) readonly buffer Sources { GlarePoint values[]; } sources;

GlarePoint glare_point(uint i) { return sources.values[i]; }

#include "physics/glare.glsl"

vec3 glare_at(uvec2 pixel, uint points, float pixel_blur) {
  ViewRay ray = picture_ray(pixel);
  return ray.inside ? glare_along(ray.direction, points, pixel_blur) : vec3(0.0);
}
