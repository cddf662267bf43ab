#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
layout(scalar, set = 0, binding = 0) readonly buffer Picture { vec4 values[]; } picture;
vec4 value_at(uint x, uint y);
#include "post/statistics.glsl"
vec4 value_at(uint x, uint y) { return picture.values[y * width + x]; }
