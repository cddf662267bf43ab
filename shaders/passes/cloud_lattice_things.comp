#version 460
#extension GL_GOOGLE_include_directive : require
// cloud_lattice.comp for a picture of things.
#include "shared/cloud_over_things.glsl"
#include "shared/cloud_lattice_rays.glsl"
