#version 460
#extension GL_GOOGLE_include_directive : require
// The mean extinction between camera and ground, over the way through the air: one thread a texel. With kDeltaScaled it
// leaves out what the peaks of phase functions scatter, as `orders` does.
#include "shared/device.glsl"
#include "shared/moment_shape.glsl"

vec3 fetch_moment(uint k, float x, float y) { return vec3(0.0); }

real shell_altitude(uint k) { return 0.0; }

#include "physics/polarisation.glsl"
#include "physics/moments.glsl"
#include "physics/ground_view.glsl"
#include "physics/ground_extinction.glsl"

layout(local_size_x = 64) in;
layout(set = 0, binding = 4, rgba32f) uniform writeonly image2D ground_view_out;

void main() {
  uint texel = gl_GlobalInvocationID.x;
  uint columns = uint(imageSize(ground_view_out).x);
  if (texel >= columns) {
    return;
  }
  ViewRange range = view_range(scene.planet, scene.camera.altitude);
  Ray ray = ray_of_unit(scene.planet, range, float(texel) / float(columns - 1u));
  imageStore(ground_view_out, ivec2(texel, 0), vec4(mean_extinction(scene.planet, ray), 1.0));
}
