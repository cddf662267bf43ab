#version 460
#extension GL_GOOGLE_include_directive : require
// Puts a cloud into the picture of a clear sky.
#include "shared/cloud_over_air.glsl"
#include "shared/cloud_picture.glsl"
