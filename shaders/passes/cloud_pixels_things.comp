#version 460
#extension GL_GOOGLE_include_directive : require
// cloud_pixels.comp over a picture of things.
#include "shared/cloud_over_things.glsl"
#include "shared/cloud_picture.glsl"
