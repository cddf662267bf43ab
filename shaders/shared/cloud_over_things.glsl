// What passes over clouds read of a picture of things.
#define AIRLIGHT_THINGS
#include "shared/device.glsl"
#include "shared/tables.glsl"
#include "shared/moment_table.glsl"
#include "shared/picture_ray.glsl"
#include "physics/orders.glsl"
#include "physics/sky_factors.glsl"
#include "shared/shell_table.glsl"
#include "physics/cloud_air.glsl"
#include "shared/sky_table.glsl"
#include "physics/sky_table.glsl"
#include "physics/space_table.glsl"
#include "physics/aerial_volume.glsl"
#include "shared/factor_place.glsl"
#include "shared/aerial_volume.glsl"

vec2 pixel_centre(uvec2 pixel) { return vec2(pixel.x + scene.tile.x, pixel.y + scene.tile.y) + 0.5; }

#include "shared/thing_tables.glsl"

// The ray at hand among things.
Sight seen_sight;
Phases seen_phases;

vec3 past_shadows(VolumeRay of, float distance_, vec3 all) {
  return kShafts == kShaftsNone ? all : max(lit_single(of, seen_phases, seen_sight, distance_, all), vec3(0.0));
}

#include "shared/cloud_push.glsl"
#include "shared/cloud_pixels.glsl"
