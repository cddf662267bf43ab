#version 460
#extension GL_GOOGLE_include_directive : require
// Adds the sun's disc to the pixels of a rectangle.
#define AIRLIGHT_EXACT_BENDING
#include "shared/device.glsl"
#include "shared/tables.glsl"

bool disc_is_hidden(vec3 direction) { return false; }

#include "shared/disc_pixels.glsl"
