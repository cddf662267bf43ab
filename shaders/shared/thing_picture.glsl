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
  write_radiance(pixel, inside, in_colours(light.i), transmittance);
}
#endif

#include "shared/thing_rays.glsl"

ViewRay ray_at(uvec2 pixel, vec2 place) {
  if (kProjection == kProjectionListed) {
    return ViewRay(directions.values[pixel.x].xyz, true);
  }
  return camera_ray(pixel, place);
}

struct PixelSeen {
  Stokes light;
  vec3 transmittance;
#ifdef AIRLIGHT_CLOUDS
  ThingsSeen things;  // their distance times their share
#endif
};

PixelSeen nothing_seen() {
#ifdef AIRLIGHT_CLOUDS
  return PixelSeen(no_light(), vec3(0.0), ThingsSeen(vec3(0.0), 0.0, 0.0));
#else
  return PixelSeen(no_light(), vec3(0.0));
#endif
}

PixelSeen ray_seen(ThingRay one) {
  looking = one.direction;
  Gathered found = gathered_along(ray_direction(looking), one.spread, one.bare, steps);
  PixelSeen part = nothing_seen();
  part.light = with_share(part.light, found.light, one.share);
  part.transmittance = one.share * found.transmittance;
#ifdef AIRLIGHT_CLOUDS
  float of_thing = found.distance_ > 0.0 ? one.share : 0.0;
  part.things = ThingsSeen(of_thing * found.light.i, of_thing, of_thing * found.distance_);
#endif
  return part;
}

PixelSeen with_seen(PixelSeen sum, PixelSeen one) {
  sum.light = with_share(sum.light, one.light, 1.0);
  sum.transmittance += one.transmittance;
#ifdef AIRLIGHT_CLOUDS
  sum.things.light += one.things.light;
  sum.things.share += one.things.share;
  sum.things.distance_ += one.things.distance_;
#endif
  return sum;
}

void write_seen(bool inside, PixelSeen seen) {
#ifdef AIRLIGHT_CLOUDS
  seen.things.distance_ /= max(seen.things.share, 1e-20);
  seen_out.values[kProjection == kProjectionListed ? here.x : here.y * scene.tile.width + here.x] = seen.things;
#endif
  write_light(here, inside, seen.light, seen.transmittance);
}

#ifdef AIRLIGHT_LISTED
#include "shared/thing_listed.glsl"
#else
#include "shared/thing_pixels.glsl"
#endif
