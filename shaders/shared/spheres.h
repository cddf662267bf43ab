// Spheres before the sky as the shaders see them, the same text in C++ (core/physics).

const uint kMostSpheres = 16u;

const uint kSphereMatte = 0u;
const uint kSphereMirror = 1u;
const uint kSphereTranslucent = 2u;

struct SphereData {
  vec3 centre;  // from the camera, km
  real radius;  // km
  vec3 albedo;
  uint material;          // kSphereMatte, ...
  real scatter_strength;  // for a translucent sphere
};
