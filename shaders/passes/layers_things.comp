#version 460
#extension GL_GOOGLE_include_directive : require
// The layers of a picture with things, one pixel a thread. What mirrors show counts as light of the surface.
#define AIRLIGHT_SUN_SHARE
#define AIRLIGHT_STOKES
#include "shared/device.glsl"
#include "shared/tables.glsl"
#include "shared/moment_table.glsl"
#include "shared/layer_output.glsl"
#include "shared/thing_march.glsl"
#include "shared/stokes_march.glsl"
#include "shared/thing_layers.glsl"
