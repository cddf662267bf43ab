// The pass over the pixels of the sun's disc.
layout(constant_id = 35) const uint kLitDisc = 0u;  // 1: a ball by another's light, 2: covered by another
bool disc_is_lit() { return kLitDisc == 1u; }
bool disc_is_covered() { return kLitDisc == 2u; }

#include "physics/sun_disc.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(constant_id = 4) const uint kProjection = 0u;
layout(scalar, set = 0, binding = 9) buffer Radiance { vec4 values[]; } radiance_out;
layout(push_constant, scalar) uniform Push {
  uvec2 first;  // the rectangle
  uvec2 count;
  uvec2 samples;
  vec2 low;
  vec2 high;
  vec3 red;  // colours of the channels
  vec3 green;
  vec3 blue;
};
#include "shared/colours.glsl"

void main() {
  uvec2 pixel = gl_GlobalInvocationID.xy;
  if (pixel.x >= count.x || pixel.y >= count.y) {
    return;
  }
  pixel += first;
  DiscBox box = DiscBox(low, high, samples.x, samples.y);
  vec3 mean = disc_in_pixel(kProjection, float(pixel.x) + 0.5, float(pixel.y) + 0.5, box);
  uvec2 at = pixel - uvec2(scene.tile.x, scene.tile.y);
  radiance_out.values[at.y * scene.tile.width + at.x] += vec4(in_colours(mean), 0.0);
}
