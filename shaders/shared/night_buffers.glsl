// The night sky's numbers (core/night/night.h) in one buffer: the map, the scattered light, the airglow at the zenith and
// the irradiance on level ground.
#include "shared/night.h"

layout(scalar, set = 0, binding = 4) readonly buffer NightSky { vec4 values[]; } night_sky;

const uint kNightTexels = kNightSide * kNightSide;

vec3 night_map(uint i) { return night_sky.values[i].rgb; }
vec3 night_scattered(uint i) { return night_sky.values[kNightTexels + i].rgb; }
vec3 airglow_zenith() { return night_sky.values[kNightTexels + 2u * kNightSlopes].rgb; }
vec3 night_on_ground() { return night_sky.values[kNightTexels + 2u * kNightSlopes + 1u].rgb; }

#include "physics/night_sky.glsl"
