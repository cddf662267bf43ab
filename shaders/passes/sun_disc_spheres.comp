#version 460
#extension GL_GOOGLE_include_directive : require
// sun_disc.comp, each sample hidden by the spheres too.
#include "shared/device.glsl"
#include "shared/tables.glsl"
#include "shared/sphere_list.glsl"

bool disc_is_hidden(vec3 direction) { return nearest_sphere(vec3(0.0), direction, kNoSphere).hit; }

#include "shared/disc_pixels.glsl"
