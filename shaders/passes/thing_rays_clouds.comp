#version 460
#extension GL_GOOGLE_include_directive : require
// thing_rays.comp with surfaces under a cloud; the cloud itself comes into the picture after it.
#define AIRLIGHT_CLOUDS
#define AIRLIGHT_LISTED
#define AIRLIGHT_BLOCK_AIR
#include "shared/device.glsl"
#include "shared/tables.glsl"
#include "shared/moment_table.glsl"
#include "shared/sky_output.glsl"
#include "shared/horizon_pixels.glsl"
#include "physics/orders.glsl"
#include "physics/sky_factors.glsl"
#include "shared/shell_table.glsl"
#include "shared/sky_table.glsl"
#include "physics/sky_table.glsl"
#include "physics/space_table.glsl"
#include "physics/aerial_volume.glsl"
#include "shared/factor_place.glsl"
#include "shared/aerial_volume.glsl"
#include "shared/thing_tables.glsl"
#include "shared/cloud_volume.glsl"
#include "shared/cloud_sunlight.glsl"
#include "physics/cloud_march.glsl"
#include "shared/cloud_shade.glsl"
#include "shared/thing_picture.glsl"
