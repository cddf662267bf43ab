#pragma once
// Keys of a march of the picture pixel by pixel: the place in its steps where the source is evaluated, and the
// resolution.

#include "core/methods/method.h"
#include "core/methods/sky_pass.h"

namespace airlight {

ParameterInfo jitter_parameter();
ParameterInfo resolution_parameter();
ParameterInfo automatic_resolution_parameter();

// Whether the camera's picture is marched at half resolution.
bool halves(const Scene& scene);

// The place in each step where the source is evaluated along a listed direction, which is no pixel: 0.5, the middle,
// unless render.jitter is "fixed". Throws InputError where the steps do not permit jitter.
double place_in_step(const Scene& scene);

// Adds the pass that marches every pixel or listed direction, or the two passes of half resolution. `pass` has its
// shader, reads, constants, and push constants after width and height; its shader includes march_pixels.glsl.
void add_marched_picture(Plan& plan, const Scene& scene, PassDesc pass, const SkyTarget& target);

}  // namespace airlight
