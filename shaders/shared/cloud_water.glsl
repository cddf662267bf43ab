// A cloud's water along a pixel's ray, and what it leaves of the sun there.
#include "shared/cloud_carved.glsl"

const float kEdgeStep = 0.3;    // of `step`, the most of a step in a carved edge
const float kEdgeRise = 0.006;  // of that over the distance
// km: from the first to the second the edge passes into means, its finer lobes into theirs. These hold for noise whose
// tiles are kTile wide at most; lobes of wider tiles are seen from as much farther off.
const vec2 kCarvedRange = vec2(25.0, 50.0);
const vec2 kFinerRange = vec2(6.0, 12.0);
const float kTile = 1.25;  // km
const float kFromSpace = 8.0;  // both ranges from space are so many times as long

// Water at a place of a ray: extinction, 1/km, and how far inside the cloud the place is, km.
struct Water {
  float extinction;
  float inside;
};

// The distance from which lobes of tiles of kTile would look as large as this cloud's from distance t, km.
float looks_as_far(float t) {
  CloudData c = cloud();
  return t / (max(c.width / max(c.edge.tiles, 1.0) / kTile, 1.0) * (table_from_space() ? kFromSpace : 1.0));
}

// At distance t, km, from the camera.
Water water_on_ray(vec3 place, float t) {
  Water water;
  water.extinction = 0.0;
  water.inside = 0.0;
  if (!inside_cloud_grid(cloud(), place)) {
    return water;
  }
  vec2 mean = water_at(place);
  water.extinction = mean.x;
  water.inside = mean.y;
  float near = looks_as_far(t);
  if (kCarved == 1u && near < kCarvedRange.y) {
    float fine = carved_extinction(place, mean.y, 1.0 - smoothstep(kFinerRange.x, kFinerRange.y, near));
    water.extinction = mix(fine, mean.x, smoothstep(kCarvedRange.x, kCarvedRange.y, near));
  }
  return water;
}

// The longest step from a place that misses no lobe of a carved edge.
float step_in_water(float inside, float t) {
  CloudEdge edge = cloud().edge;
  float away = max(-inside, inside - edge.carving - edge.soft);
  float near = looks_as_far(t);
  return kCarved == 1u && near < kCarvedRange.y ? max(max(step * kEdgeStep, near * kEdgeRise), away) : 1e9;
}

// The cosine of the sun's zenith distance as it is seen along a ray, which is as good as even between two distances.
struct SunOnSpan {
  float from;  // km
  float to;
  float at_from;
  float at_to;
};

float seen_on_ray(Ray ray, float t) {
  RayPoint point = sunlit_among_things(scene.planet, ray, t);
  return seen_sun_mu(scene.planet, point.h, point.mu_sun);
}

SunOnSpan sun_on_span(Ray ray, CloudCrossing span) {
  SunOnSpan sun;
  sun.from = span.from;
  sun.to = span.to;
  sun.at_from = seen_on_ray(ray, span.from);
  sun.at_to = seen_on_ray(ray, span.to);
  return sun;
}

float seen_at(SunOnSpan sun, float t) {
  return mix(sun.at_from, sun.at_to, (t - sun.from) / max(sun.to - sun.from, 1e-6));
}

float shade_at(vec3 place, float seen) {
  return cloud_shade_of(place, mix(cloud().base, cloud().top, place.z), seen);
}
