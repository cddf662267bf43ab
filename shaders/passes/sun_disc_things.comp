#version 460
#extension GL_GOOGLE_include_directive : require
// sun_disc.comp, each sample hidden by things too.
#define AIRLIGHT_EXACT_BENDING
#include "shared/device.glsl"
#include "shared/tables.glsl"
#include "shared/things.glsl"

bool disc_is_hidden(vec3 direction) {
  return hits_thing(nearest_thing(scene.planet, sight_of(vec3(0.0), direction), kNoBody));
}

#include "shared/disc_pixels.glsl"
