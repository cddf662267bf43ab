#version 460
#extension GL_GOOGLE_include_directive : require
// Spheres, the sky, the ground and the air before and behind them, with the spheres' shadow on ground and air. It is
// the view march on the table of moments along each pixel's ray and along the rays that mirrors reflect. A pixel with
// an edge, a shadow's edge or a mirror is the mean over rays through all of it.
#define AIRLIGHT_SUN_SHARE
#include "shared/device.glsl"
#include "shared/tables.glsl"
#include "shared/moment_table.glsl"
#include "shared/sky_output.glsl"
#include "shared/sphere_list.glsl"
#include "shared/horizon_pixels.glsl"

layout(constant_id = 28) const uint kShafts = 1u;    // 0: the air is lit as if there were no spheres
layout(constant_id = 29) const uint kDiscShows = 1u;  // 1: the disc shows in mirrors

// Start and direction of the march of the ray at hand.
vec3 current_start = vec3(0.0);
vec3 current_direction = vec3(0.0);

float sun_share(Ray ray, float t, float width) {
  if (kShafts == 0u && width > 0.0) {
    return 1.0;
  }
  return spheres_sunlit(current_start, current_direction, scene.sun.direction, scene.sun.angular_radius, t, width);
}

#include "physics/orders.glsl"
#include "physics/sky_factors.glsl"
#include "shared/shell_table.glsl"
#include "physics/surface_light.glsl"
#include "physics/sphere_light.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(push_constant, scalar) uniform Push {
  uint width;
  uint height;
  uint steps;
};

const uint kEdgeSide = 4u;  // rays across a pixel with an edge, a shadow's edge or a mirror
const uint kSegments = 6u;  // most segments of a ray from mirror to mirror; light beyond the last is lost

struct Seen {
  vec3 radiance;
  vec3 transmittance;  // up to the ray's first hit
};

// `spread`: angle between neighbouring rays.
Seen seen_along(vec3 direction, float spread) {
  Seen seen;
  seen.radiance = vec3(0.0);
  seen.transmittance = vec3(1.0);
  vec3 origin = vec3(0.0);
  vec3 through = vec3(1.0);
  float beam = 0.0;  // width, km
  uint left = kNoSphere;
  for (uint i = 0u; i < kSegments; i++) {
    Ray ray = ray_from(scene.planet, scene.camera.altitude, origin, direction, scene.sun.direction);
    SpherePlace start = sphere_place(scene.planet, scene.camera.altitude, origin);
    float h = i == 0u ? scene.camera.altitude : start.h;
    float mu = dot(direction, start.up);
    float before = air_entry(scene.planet, h, mu).distance_;
    SphereHit hit = nearest_sphere(origin, direction, left);
    hit.hit = hit.hit && !(ray.at_ground && hit.distance_ > before + ray.length_);
    if (hit.hit) {
      ray = ray_up_to(scene.planet, h, mu, ray, hit.distance_);
    }
    current_start = origin + direction * before;
    current_direction = direction;
    SkyFactors factors = scene_sky_factors(ray, steps);
    seen.radiance += through * phased(factors, phases(ray.nu)) * scene.sun.irradiance;
    through *= factors.transmittance;
    seen.transmittance = i == 0u ? factors.transmittance : seen.transmittance;
    if (!hit.hit) {
      bool disc = kDiscShows != 0u && i > 0u && !ray.at_ground;
      seen.radiance += disc ? through * mirrored_disc(scene.sun, direction, spread) : vec3(0.0);
      break;
    }
    SphereData s = sphere(hit.which);
    origin += direction * hit.distance_;
    vec3 normal = normalize(origin - s.centre);
    if (s.material != kSphereMirror) {
      float past = sun_past_spheres(origin, scene.sun.direction, scene.sun.angular_radius, hit.which);
      SpherePlace place = sphere_place(scene.planet, scene.camera.altitude, origin);
      seen.radiance += through * scene.sun.irradiance *
                       sphere_radiance(scene.planet, scene.moments, s, place, normal, direction, scene.sun.direction, past);
      break;
    }
    through *= s.albedo;
    beam += spread * hit.distance_;
    spread += 2.0 * beam / s.radius;
    direction = normalize(direction - normal * (2.0 * dot(direction, normal)));
    left = hit.which;
  }
  return seen;
}

vec3 direction_at(uvec2 pixel, vec2 place) {
  vec2 at = vec2(pixel + uvec2(scene.tile.x, scene.tile.y)) + place;
  return view_ray(scene.camera, kProjection, at.x, at.y).direction;
}

// Whether the pixel, which extends by `reach` from its middle, holds a sphere's edge or a mirror.
bool holds_edge(vec3 direction, float reach) {
  bool edge = false;
  for (uint i = 0u; i < sphere_count(); i++) {
    SphereData s = sphere(i);
    float far = length(s.centre);
    float size = atan(s.radius, sqrt(max(far * far - s.radius * s.radius, 0.0)));
    float along = dot(direction, s.centre);
    float apart = atan(length(s.centre - direction * along), along);
    edge = edge || abs(apart - size) < reach || (s.material == kSphereMirror && apart < size);
  }
  return edge;
}

// Whether the pixel's corners on the ground differ in their share of the sun.
bool holds_shadow(uvec2 pixel) {
  float h = scene.camera.altitude;
  float least = 1.0;
  float most = 0.0;
  for (uint i = 0u; i < 4u; i++) {
    vec3 direction = direction_at(pixel, vec2(i % 2u == 0u ? 0.01 : 0.99, i < 2u ? 0.01 : 0.99));
    vec3 point = direction * distance_to_ground(scene.planet, h, min(direction.y, horizon_mu(scene.planet, h)));
    float share = sun_past_spheres(point, scene.sun.direction, scene.sun.angular_radius, kNoSphere);
    share = meets_ground(scene.planet, h, direction.y) ? share : 1.0;
    least = min(least, share);
    most = max(most, share);
  }
  return most - least > 0.1;
}

void main() {
  uvec2 pixel = gl_GlobalInvocationID.xy;
  if (pixel.x >= width || pixel.y >= height) {
    return;
  }
  ViewRay view = pixel_ray(pixel);
  PixelRays rays = rays_at(pixel, view);
  float angle = 0.0;
  uint side = 1u;
  if (kProjection != kProjectionListed) {
    angle = length(direction_at(pixel, vec2(0.99, 0.5)) - direction_at(pixel, vec2(0.01, 0.5)));
    float corner = length(direction_at(pixel, vec2(0.99, 0.99)) - direction_at(pixel, vec2(0.01, 0.01)));
    bool edge = holds_edge(view.direction, max(angle, corner)) || holds_shadow(pixel);
    side = view.inside && edge ? kEdgeSide : 1u;
  }
  uint count = side > 1u ? side * side : rays.count;
  vec3 radiance = vec3(0.0);
  vec3 transmittance = vec3(0.0);
  for (uint i = 0u; i < count; i++) {
    WeightedRay one;
    if (side > 1u) {
      one.direction = direction_at(pixel, (vec2(float(i % side), float(i / side)) + 0.5) / float(side));
      one.share = 1.0 / float(count);
    } else {
      one = weighted_ray(pixel, view, rays, i);
    }
    Seen seen = seen_along(one.direction, angle / float(side));
    radiance += one.share * seen.radiance;
    transmittance += one.share * seen.transmittance;
  }
  write_radiance(pixel, view.inside, radiance, transmittance);
}
