// What the passes over things have in common before their rays (thing_rays.glsl).

layout(push_constant, scalar) uniform Push {
  uint width;
  uint height;
  uint steps;
#ifdef AIRLIGHT_LISTED
  uint round;  // thing_list.glsl
  vec3 red;    // colours of the channels
  vec3 green;
  vec3 blue;
#endif
};
#ifdef AIRLIGHT_LISTED
#include "shared/colours.glsl"
#else
vec3 in_colours(vec3 light) { return light; }
#endif

vec3 looking;  // direction of the first part of the ray at hand

#ifndef AIRLIGHT_STOKES
vec3 ray_direction(vec3 direction) { return direction; }
#endif
