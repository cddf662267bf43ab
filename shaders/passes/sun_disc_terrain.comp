#version 460
#extension GL_GOOGLE_include_directive : require
// sun_disc.comp, each sample hidden by the terrain too.
#include "shared/device.glsl"
#include "shared/tables.glsl"
#include "shared/terrain_maps.glsl"

vec2 terrain_shadow(uint k) { return vec2(0.0); }  // not called

#include "physics/terrain.glsl"

bool disc_is_hidden(vec3 direction) {
  return terrain_hit(scene.planet, ground_track(scene.camera.altitude, direction)).hit;
}

#include "shared/disc_pixels.glsl"
