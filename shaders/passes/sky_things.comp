#version 460
#extension GL_GOOGLE_include_directive : require
// Things, the ground, the sky and the air before and behind them, with the things' shadows on each other and in the
// air: surfaces first, then the view march on the table of moments up to them, along each pixel's ray and along the
// rays that mirrors reflect. A pixel with an edge, a shadow's edge or a mirror is the mean over rays through all of it.
#define AIRLIGHT_SUN_SHARE
#define AIRLIGHT_STOKES
#include "shared/device.glsl"
#include "shared/tables.glsl"
#include "shared/moment_table.glsl"
#include "shared/sky_output.glsl"
#include "shared/horizon_pixels.glsl"
#include "shared/thing_march.glsl"
#include "shared/stokes_march.glsl"
#include "shared/thing_picture.glsl"
