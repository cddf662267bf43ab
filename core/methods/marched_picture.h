#pragma once
// The keys of a march of the picture pixel by pixel: where in its steps the source is evaluated, and at what
// resolution.

#include "core/methods/method.h"
#include "core/methods/sky_pass.h"

namespace airlight {

ParameterInfo jitter_parameter();
ParameterInfo resolution_parameter();
ParameterInfo automatic_resolution_parameter();

// Whether the camera's picture is marched at half resolution.
bool halves(const Scene& scene);

// Where in its step each source is evaluated along a listed direction, which is no pixel: 0.5, the middle, unless
// render.jitter is "fixed". Throws InputError where the steps are such that they cannot be jittered.
double place_in_step(const Scene& scene);

// Adds the pass that marches every pixel or listed direction, or at half resolution the two that do. `pass` has its
// shader, reads and constants, and its push constants after width and height; its shader includes march_pixels.glsl.
void add_marched_picture(Plan& plan, const Scene& scene, PassDesc pass, const SkyTarget& target);

}  // namespace airlight
