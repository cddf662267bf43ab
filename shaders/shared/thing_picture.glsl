// The pixels of a picture of things, the air up to which the includer finds (factors_past_things()).

#include "shared/thing_pass.glsl"

struct Gathered {
  Stokes light;
  vec3 transmittance;  // up to the first thing
#ifdef AIRLIGHT_CLOUDS
  float distance_;
#endif
};

#ifdef AIRLIGHT_CLOUDS
#include "shared/things_seen.glsl"
layout(scalar, set = 0, binding = 32) writeonly buffer Seen { ThingsSeen values[]; } seen_out;

Gathered nothing_gathered() { return Gathered(no_light(), vec3(1.0), 0.0); }
#else
Gathered nothing_gathered() { return Gathered(no_light(), vec3(1.0)); }
#endif

Gathered with_air(Gathered sum, SkyFactors air, float nu, vec3 through, bool first) {
#ifdef AIRLIGHT_STOKES
  if (stokes() && first) {
    sum.light = times(shown_along(air, nu, looking), scene.sun.irradiance);
    sum.transmittance = beam_transmittance(air);
    return sum;
  }
#endif
  sum.light.i += through * phased(air, phases(nu)) * scene.sun.irradiance;
  sum.transmittance = first ? beam_transmittance(air) : sum.transmittance;
  return sum;
}

Gathered with_light(Gathered sum, vec3 light) {
  sum.light.i += light;
  return sum;
}

#ifndef AIRLIGHT_STOKES
Stokes with_share(Stokes sum, Stokes one, float share) {
  sum.i += share * one.i;
  return sum;
}

void write_light(uvec2 pixel, bool inside, Stokes light, vec3 transmittance) {
  write_radiance(pixel, inside, light.i, transmittance);
}
#endif

#include "shared/thing_rays.glsl"

ViewRay ray_of_pixel(uvec2 pixel) { return pixel_ray(pixel); }

// The pixel at hand.
void render(ViewRay view, ThingPixel rays) {
  Stokes light = no_light();
  vec3 transmittance = vec3(0.0);
#ifdef AIRLIGHT_CLOUDS
  ThingsSeen things = ThingsSeen(vec3(0.0), 0.0, 0.0);
#endif
  for (uint i = 0u; i < rays.count; i++) {
    WeightedRay one = ray_of_thing_pixel(here, view, rays, i);
    looking = one.direction;
    Gathered seen = gathered_along(ray_direction(looking), rays.spread, rays.bare, steps);
    light = with_share(light, seen.light, one.share);
    transmittance += one.share * seen.transmittance;
#ifdef AIRLIGHT_CLOUDS
    float of_thing = seen.distance_ > 0.0 ? one.share : 0.0;
    things.light += of_thing * seen.light.i;
    things.share += of_thing;
    things.distance_ += of_thing * seen.distance_;
#endif
  }
#ifdef AIRLIGHT_CLOUDS
  things.distance_ /= max(things.share, 1e-20);
  seen_out.values[kProjection == kProjectionListed ? here.x : here.y * scene.tile.width + here.x] = things;
#endif
  write_light(here, view.inside, light, transmittance);
}

#include "shared/thing_pixels.glsl"
