#version 460
#extension GL_GOOGLE_include_directive : require
// sky_things.comp by tables: no ray marches. Pictures by blocks have their own passes (thing_rays.comp).
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
#include "shared/thing_picture.glsl"
