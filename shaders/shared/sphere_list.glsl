// The scene's spheres as a buffer.
#include "shared/spheres.h"

layout(scalar, set = 0, binding = 10) readonly buffer Spheres {
  uint count;
  SphereData of[];
} spheres;

uint sphere_count() { return spheres.count; }
SphereData sphere(uint i) { return spheres.of[i]; }

#include "physics/spheres.glsl"
