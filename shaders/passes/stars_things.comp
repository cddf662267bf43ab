#version 460
#extension GL_GOOGLE_include_directive : require
// stars.comp, with things before them.
#include "shared/device.glsl"
#include "shared/tables.glsl"
#include "shared/things.glsl"
#include "physics/from_space.glsl"

bool disc_is_hidden(vec3 direction) {
  return hits_thing(nearest_thing(scene.planet, sight_of(vec3(0.0), direction), kNoBody));
}

#include "shared/star_pixels.glsl"
