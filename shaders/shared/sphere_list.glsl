// The scene's spheres as a buffer.

layout(scalar, set = 0, binding = 13) readonly buffer Spheres {
  uint count;
  SphereData of[];
} spheres;

uint sphere_count() { return (kThings & kHasSpheres) != 0u ? spheres.count : 0u; }
SphereData sphere(uint i) { return spheres.of[i]; }

#include "physics/spheres.glsl"
