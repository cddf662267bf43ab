#version 460
#extension GL_GOOGLE_include_directive : require
// Adds stars to the pixels that hold some.
#include "shared/device.glsl"
#include "shared/tables.glsl"
#include "physics/from_space.glsl"

bool disc_is_hidden(vec3 direction) { return false; }

#include "shared/star_pixels.glsl"
