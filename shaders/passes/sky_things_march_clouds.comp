#version 460
#extension GL_GOOGLE_include_directive : require
// sky_things.comp with surfaces under a cloud; the cloud itself comes into the picture after it.
#define AIRLIGHT_CLOUDS
#define AIRLIGHT_SUN_SHARE
#define AIRLIGHT_STOKES
#include "shared/device.glsl"
#include "shared/tables.glsl"
#include "shared/moment_table.glsl"
#include "shared/sky_output.glsl"
#include "shared/horizon_pixels.glsl"
#include "shared/thing_march.glsl"
#include "shared/stokes_march.glsl"
#include "shared/cloud_volume.glsl"
#include "shared/cloud_sunlight.glsl"
#include "physics/cloud_march.glsl"
#include "shared/cloud_shade.glsl"
#include "shared/thing_picture.glsl"
