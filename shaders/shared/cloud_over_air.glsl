// What passes over clouds read of a picture without things.
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
layout(push_constant, scalar) uniform Push {
  uint width;
  uint height;
  uint vectors;     // of each listed direction
  float step;       // km, the shortest
  float step_rise;  // of the step over the distance
};
#include "shared/cloud_pixels.glsl"
