// The rays that a march of the picture takes, the place in their steps, and where the light goes. A march takes every
// pixel. At half resolution it takes the corners of pixels two apart, then every pixel from the four corners around it.
#include "shared/sky_output.glsl"
#include "shared/horizon_pixels.glsl"
#include "shared/peaks.glsl"
#include "physics/spread.glsl"

layout(constant_id = 23) const uint kJitter = kJitterNone;
layout(constant_id = 24) const uint kPart = 0u;  // kPartWhole, ...

// rgb: radiance; a: 1 where the ray ends on the ground.
layout(scalar, set = 0, binding = 11) readonly buffer HalfRadiance { vec4 values[]; } half_radiance;

// Pairs of pixels are those of the whole picture in every tile: a tile's corners start at those of a pair.
ViewRay marched_ray(uvec2 pixel) {
  if (kPart == kPartHalf) {
    return view_ray(scene.camera, kProjection, 2.0 * float(pixel.x + scene.tile.x / 2u),
                    2.0 * float(pixel.y + scene.tile.y / 2u));
  }
  return pixel_ray(pixel);
}

// A corner is a single ray; the pixels around it take the planet's edge into account.
PixelRays marched_rays(uvec2 pixel, ViewRay view) {
  if (kPart == kPartHalf) {
    return one_ray(0.0);
  }
  return rays_at(pixel, view);
}

float place_in_step(uvec2 pixel) {
  if (kJitter != kJitterBlueNoise) {
    return kJitter == kJitterFixed ? kFixedPlace : 0.5;
  }
  uvec2 first = uvec2(scene.tile.x, scene.tile.y);
  uvec2 at = pixel + (kPart == kPartHalf ? first / 2u : first);
  return spread_place(at.x, at.y);
}

struct Upsampled {
  vec3 radiance;
  bool holds;  // false: the pixel is to be marched
};

// Bilinear between the corners; a pixel's centre is a quarter and three quarters of their distance away from them.
// `holds` requires that the corners and the pixel agree on whether their rays end on the ground, that no channel
// differs by more than a quarter (an exponential between such corners makes the chord's middle 0.6 % too bright), and
// that no peak is near.
Upsampled upsampled(uvec2 pixel, uint width, vec3 direction, bool at_ground) {
  Upsampled from;
  from.radiance = vec3(0.0);
  from.holds = false;
  if (kPart == kPartUpsampled) {
    const float kContrast = 1.25;
    uint row = width / 2u + 2u;
    uvec2 at = whole_pixel(pixel);
    uvec2 corner = at / 2u - uvec2(scene.tile.x, scene.tile.y) / 2u;
    uint first = corner.y * row + corner.x;
    vec4 a = half_radiance.values[first];
    vec4 b = half_radiance.values[first + 1u];
    vec4 c = half_radiance.values[first + row];
    vec4 d = half_radiance.values[first + row + 1u];
    float x = at.x % 2u == 0u ? 0.25 : 0.75;
    float y = at.y % 2u == 0u ? 0.25 : 0.75;
    vec4 sum = mix(mix(a, b, x), mix(c, d, x), y);
    vec3 low = min(min(a.rgb, b.rgb), min(c.rgb, d.rgb));
    vec3 high = max(max(a.rgb, b.rgb), max(c.rgb, d.rgb));
    from.radiance = sum.rgb;
    from.holds = sum.a == (at_ground ? 1.0 : 0.0) && all(lessThanEqual(high, kContrast * low)) &&
                 corners_from_peak(pixel, direction) > 4.0;
  }
  return from;
}

void write_marched(uvec2 pixel, uint width, ViewRay view, bool at_ground, Upsampled from, PathRadiance path) {
  if (kPart == kPartHalf) {
    radiance_out.values[pixel.y * width + pixel.x] = vec4(path.radiance, at_ground ? 1.0 : 0.0);
  } else {
    write_radiance(pixel, view.inside, from.holds ? from.radiance : path.radiance, path.transmittance);
  }
}
