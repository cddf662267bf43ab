#version 460
#extension GL_GOOGLE_include_directive : require
// What a cloud makes of the light behind it on rays of a lattice.
#include "shared/cloud_over_air.glsl"
#include "shared/cloud_lattice_rays.glsl"
