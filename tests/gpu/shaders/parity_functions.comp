#version 460
#extension GL_GOOGLE_include_directive : require
// One function of shaders/physics over an array of inputs.
#include "shared/device.glsl"

// The called functions fetch no sunlight, but the physics that declares them needs these functions.
vec3 transmittance_to_top(PlanetData planet, real h, real mu) { return vec3(1.0); }
real bending_along(PlanetData planet, real h, real mu) { return 0.0; }

#include "physics/sunlight.glsl"
#include "../parity_codes.h"
#include "../parity_calls.glsl"

layout(local_size_x = 64) in;
layout(constant_id = 40) const uint kFunction = 0u;
layout(scalar, set = 0, binding = 1) readonly buffer Inputs { Arguments values[]; } inputs;
layout(scalar, set = 0, binding = 2) writeonly buffer Outputs { Results values[]; } outputs;

void main() {
  uint i = gl_GlobalInvocationID.x;
  if (i < inputs.values.length()) {
    outputs.values[i] = call(kFunction, inputs.values[i]);
  }
}
