// The kinds of bodies, which stand free in the air (physics/bodies.glsl): the data of each, and one list of them all;
// the same text in C++ (core/physics, core/things). A kind of the list is
//   its data; what one and all are called; its bit of kThings; the binding of its buffer, which is called as all are
#include "spheres.h"

#define BODY_KINDS(kind) kind(SphereData, sphere, spheres, kHasSpheres, 13)

const uint kNoBody = 0xffffffffu;
