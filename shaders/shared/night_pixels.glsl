// The pass over all pixels that adds the night sky.
// The includer defines: vec3 night_light(vec3 direction)
#include "shared/night_buffers.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(constant_id = 4) const uint kProjection = 0u;
layout(scalar, set = 0, binding = 9) buffer Radiance { vec4 values[]; } radiance_out;
layout(push_constant, scalar) uniform Push {
  uvec2 count;
};

vec3 night_light(vec3 direction);

void main() {
  uvec2 pixel = gl_GlobalInvocationID.xy;
  if (pixel.x >= count.x || pixel.y >= count.y) {
    return;
  }
  vec2 at = vec2(pixel + uvec2(scene.tile.x, scene.tile.y)) + 0.5;
  ViewRay view = view_ray(scene.camera, kProjection, at.x, at.y);
  vec3 light = view.inside ? night_light(view.direction) : vec3(0.0);
  radiance_out.values[pixel.y * count.x + pixel.x] += vec4(light, 0.0);
}
