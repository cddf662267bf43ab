#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
layout(set = 0, binding = 0) uniform sampler2D table;
vec4 value_at(uint x, uint y) { return texelFetch(table, ivec2(x, y), 0); }
#include "post/statistics.glsl"
