#version 460
#extension GL_GOOGLE_include_directive : require
// Puts a cloud into the picture of a clear sky.
#include "shared/device.glsl"
#include "shared/tables.glsl"
#include "shared/moment_table.glsl"
#include "shared/picture_ray.glsl"
#include "physics/shells.glsl"
#include "physics/cloud_air.glsl"
#include "shared/sky_table.glsl"
#include "physics/sky_table.glsl"
#include "physics/space_table.glsl"
#include "physics/aerial_volume.glsl"
#include "shared/factor_place.glsl"
#include "shared/aerial_volume.glsl"
#include "shared/volume_fetch.glsl"
#include "shared/cloud_pixels.glsl"
