#version 460
#extension GL_GOOGLE_include_directive : require
// The sky-view table: one march a texel, from the camera's altitude to the top of the atmosphere or to the ground.
#include "shared/device.glsl"
#include "shared/tables.glsl"
#include "shared/scattering_tables.glsl"
#include "shared/ground_table.glsl"
#include "physics/march.glsl"
#include "physics/sky_view_mapping.glsl"
#include "shared/sky_view_ray.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(constant_id = 6) const uint kStepDistribution = 1u;
layout(set = 0, binding = 4, rgba32f) uniform writeonly image2D sky_view_out;
layout(push_constant, scalar) uniform Push {
  uint steps;
  uint sky_rows;
};

void main() {
  ivec2 size = imageSize(sky_view_out);
  ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
  if (texel.x >= size.x || texel.y >= size.y) {
    return;
  }
  Ray ray = sky_view_texel_ray(texel, size, int(sky_rows));
  PathRadiance path = march(scene.planet, scene.sun, ray, steps, kStepDistribution, scene.multiple_scattering_scale);
  imageStore(sky_view_out, texel, vec4(path.radiance, 1.0));
}
