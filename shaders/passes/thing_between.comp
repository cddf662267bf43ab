#version 460
#extension GL_GOOGLE_include_directive : require
// Pixels of a picture of things between rays.
#include "shared/thing_between.glsl"
