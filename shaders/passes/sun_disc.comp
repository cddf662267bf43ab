#version 460
#extension GL_GOOGLE_include_directive : require
// Adds the sun's disc to the pixels of a rectangle: limb-darkened, seen through the air, each sample hidden by the
// planet on its own. A pixel is integrated over the part of it that lies in the disc's bounding box, by solid angle: a
// disc far smaller than a pixel keeps its energy, one far larger its edge.
#include "shared/device.glsl"
#include "shared/tables.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(constant_id = 4) const uint kProjection = 0u;
layout(scalar, set = 0, binding = 9) buffer Radiance { vec4 values[]; } radiance_out;
layout(push_constant, scalar) uniform Push {
  uvec2 first;    // the rectangle
  uvec2 count;
  uvec2 samples;  // a pixel, across and down
  vec2 low;       // the disc's bounding box, in pixels; it may reach beyond a round picture's seam
  vec2 high;
};

vec3 disc_radiance(vec3 direction) {
  float profile = disc_profile(scene.sun, length(direction - scene.sun.direction));
  Ray ray = ray_in_atmosphere(scene.planet, scene.camera.altitude, direction.y, scene.sun.direction.y, 1.0);
  vec3 through = ray.length_ < 0.0 ? vec3(1.0) : transmittance_to_top(scene.planet, ray.h, ray.mu);
  return ray.at_ground ? vec3(0.0) : scene.sun.disc_radiance * through * profile;
}

// Solid angle of a pixel, by two points a side: exact where the density is a cubic.
float pixel_solid_angle(vec2 center) {
  const float offset = 0.28867513;
  float sum = 0.0;
  for (int i = 0; i < 4; i++) {
    vec2 at = center + offset * vec2(i % 2 == 0 ? -1.0 : 1.0, i < 2 ? -1.0 : 1.0);
    sum += solid_angle_density(scene.camera, kProjection, at.x, at.y);
  }
  return 0.25 * sum;
}

void main() {
  uvec2 pixel = gl_GlobalInvocationID.xy;
  if (pixel.x >= count.x || pixel.y >= count.y) {
    return;
  }
  pixel += first;
  vec2 center = vec2(pixel) + 0.5;
  bool inside = view_ray(scene.camera, kProjection, center.x, center.y).inside;
  if (kProjection == kProjectionEquirectangular) {
    // As near to the disc as going round allows.
    float round = float(scene.camera.width);
    center.x += floor((0.5 * (low.x + high.x) - center.x) / round + 0.5) * round;
  }
  vec2 from = max(center - 0.5, low);
  vec2 size = min(center + 0.5, high) - from;
  // Written as a loop that runs no turn: a branch not taken still runs, masked, on a software device.
  uint turns = size.x > 0.0 && size.y > 0.0 && inside ? samples.x * samples.y : 0u;
  vec3 sum = vec3(0.0);
  for (uint i = 0u; i < turns; i++) {
    vec2 at = from + size * (vec2(float(i % samples.x), float(i / samples.x)) + 0.5) / vec2(samples);
    sum += disc_radiance(view_ray(scene.camera, kProjection, at.x, at.y).direction) *
           solid_angle_density(scene.camera, kProjection, at.x, at.y);
  }
  float sample_area = size.x * size.y / float(samples.x * samples.y);
  vec3 mean = turns == 0u ? vec3(0.0) : sum * (sample_area / pixel_solid_angle(center));
  uvec2 at = pixel - uvec2(scene.tile.x, scene.tile.y);
  radiance_out.values[at.y * scene.tile.width + at.x] += vec4(mean, 0.0);
}
