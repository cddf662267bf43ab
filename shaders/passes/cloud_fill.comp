#version 460
#extension GL_GOOGLE_include_directive : require
// Puts a cloud into the pixels that stand between rays of the lattice (cloud_lattice.comp) which see much the same of
// it, and lists all others.
#include "shared/device.glsl"
#include "shared/picture_ray.glsl"
#include "shared/cloud_output.glsl"
#include "shared/cloud_list.glsl"
#include "shared/cloud_lattice.glsl"
#include "shared/peaks.glsl"
#include "shared/things_seen.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(scalar, set = 0, binding = 43) readonly buffer CloudLattice { LatticeRay values[]; } cloud_lattice;
layout(scalar, set = 0, binding = 32) readonly buffer Seen { ThingsSeen values[]; } seen;  // where kAmongThings is 1
layout(constant_id = 54) const uint kFurther = 0u;  // cloud_pixels.glsl
layout(constant_id = 59) const uint kAmongThings = 0u;
layout(push_constant, scalar) uniform Push {
  uint width;
  uint height;
  float contrast;  // between rays, of the light past them
  float scale;     // CloudData
};

vec3 light_past(LatticeRay ray, vec3 behind) {
  return ray.sent + max(behind * ray.share - ray.taken, vec3(0.0)) * ray.through;
}

LatticeRay mean_of(LatticeRay a, LatticeRay b) {
  LatticeRay mean;
  mean.sent = 0.5 * (a.sent + b.sent);
  mean.through = 0.5 * (a.through + b.through);
  mean.share = 0.5 * (a.share + b.share);
  mean.end = a.end;
  mean.taken = 0.5 * (a.taken + b.taken);
  return mean;
}

// Rays' transmittances differ by no more than `contrast` of the greatest of them, which counts as this at least.
const float kLeastByDay = 1.0;      // the light past the rays is compared as well
const float kLeastByNight = 0.001;  // stars, which are put behind the cloud later, may outshine it
float least_through() { return scene.sun.direction.y < 0.0 ? kLeastByNight : kLeastByDay; }

struct Between {
  LatticeRay ray;
  bool holds;  // false: the pixel is to be marched
};

// What clouds make of the light behind a pixel, of which so much is there. A pixel of the lattice has its own ray;
// others hold where the light past the four around them differs by no more than `contrast` of itself, all end alike,
// and no peak is near.
Between between_rays(uvec2 pixel, uint width, vec3 behind, vec3 direction, float contrast) {
  uvec2 at = whole_pixel(pixel);
  uvec2 corner = at / 2u - uvec2(scene.tile.x, scene.tile.y) / 2u;
  uint row = lattice_row(width);
  uint first = corner.y * row + corner.x;
  LatticeRay a = cloud_lattice.values[first];
  LatticeRay b = cloud_lattice.values[first + 1u];
  LatticeRay c = cloud_lattice.values[first + row];
  LatticeRay d = cloud_lattice.values[first + row + 1u];
  vec3 of_a = light_past(a, behind);
  vec3 of_b = light_past(b, behind);
  vec3 of_c = light_past(c, behind);
  vec3 of_d = light_past(d, behind);
  vec3 low = min(min(of_a, of_b), min(of_c, of_d));
  vec3 high = max(max(of_a, of_b), max(of_c, of_d));
  float thinnest = max(max(a.through, b.through), max(c.through, d.through));
  float thickest = min(min(a.through, b.through), min(c.through, d.through));
  uvec2 odd = at % 2u;
  bool own = odd.x + odd.y == 0u;
  Between from;
  from.ray = a;
  if (!own) {
    from.ray = odd.x == 0u ? mean_of(a, c) : odd.y == 0u ? mean_of(a, b) : mean_of(mean_of(a, b), mean_of(c, d));
  }
  bool alike = a.end < kEndsOutside && b.end == a.end && c.end == a.end && d.end == a.end;
  bool clear = thinnest - thickest <= contrast * max(thinnest, least_through());
  bool even = all(lessThanEqual(high - low, contrast * high)) && clear;
  from.holds = own || (alike && even && corners_from_peak(pixel, direction) > 4.0);
  return from;
}

bool shows_things(uint index) {
  if (kAmongThings == 1u) {
    return seen.values[index].share > 0.0;
  }
  return false;
}

void main() {
  uvec2 pixel = gl_GlobalInvocationID.xy;
  if (pixel.x >= width || pixel.y >= height) {
    return;
  }
  uint index = pixel.y * width + pixel.x;
  vec3 behind = radiance_out.values[index].rgb;
  ViewRay view = picture_ray(pixel);
  Between from = between_rays(pixel, width, behind, view.direction, contrast);
  if (!from.holds || shows_things(index)) {
    uint i = atomicAdd(cloud_list.count, 1u);
    atomicMax(cloud_list.groups.y, i / (64u * kListGroups) + 1u);
    cloud_list.values[i] = index;
    return;
  }
  put_pixel(index, light_past(from.ray, behind), view.inside, beam_of(from.ray.through, scale), kFurther == 1u);
}
