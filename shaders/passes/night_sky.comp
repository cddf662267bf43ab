#version 460
#extension GL_GOOGLE_include_directive : require
// Adds the night sky to a picture.
#include "shared/device.glsl"
#include "shared/tables.glsl"
#include "shared/night_pixels.glsl"

vec3 night_light(vec3 direction) { return night_along(scene.planet, scene.camera.altitude, direction); }
