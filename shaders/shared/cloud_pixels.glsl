// Puts a cloud into a picture: marches through it, with the air before it, and hides what is behind. With AIRLIGHT_THINGS
// the picture is one of things, which the pass over them has lit under the cloud; its pixels are marched up to them.
#include "shared/cloud_volume.glsl"
#include "shared/cloud_sunlight.glsl"
#include "physics/cloud_light.glsl"
#include "physics/cloud_march.glsl"
#include "shared/cloud_shade.glsl"
#include "shared/cloud_shafts.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
#include "shared/cloud_blocks.glsl"
layout(set = 0, binding = 23) uniform sampler3D cloud_source_lut;
layout(set = 0, binding = 24) uniform sampler3D cloud_gap_lut;  // cells to the nearest one that holds water
layout(set = 0, binding = 28) uniform sampler2D cloud_phase_lut;
layout(set = 0, binding = 26) uniform sampler3D cloud_shafts_lut;  // cloud_shafts.comp; any image where kAirByRay is 1
// 1: this is a further field over the picture of another, whose air is shaded and whose ground is lit by all of them.
layout(constant_id = 54) const uint kFurther = 0u;
// Of the field's two stretches along a ray that dips below it. A field through which the camera looks down stands on
// both sides of those below it.
layout(constant_id = 55) const uint kStretches = 0u;  // 0: both, 1: the nearer one, 2: the farther one
layout(constant_id = 50) const uint kAirByRay = 0u;  // 1: the air's shade is found along each ray, 0: on froxels
layout(scalar, set = 0, binding = 8) readonly buffer Directions { vec4 values[]; } directions;
layout(scalar, set = 0, binding = 9) buffer Radiance { vec4 values[]; } radiance_out;
layout(scalar, set = 0, binding = 31) buffer Through { float values[]; } through_out;
layout(push_constant, scalar) uniform Push {
  uint width;
  uint height;
  uint vectors;     // of each listed direction
  float step;       // km, the shortest
  float step_rise;  // of the step over the distance
};

const float kOpaque = 2e-3;     // a transmittance that hides what is behind
const uint kMostSteps = 4096u;  // along a ray
const float kStepDepth = 1.0;   // scaled, the most of a step
const float kEdgeDepth = 0.1;   // likewise where the cloud begins or ends
const float kSunStep = 1.0;     // scaled, the most by which the depth toward the sun may change along a step
const float kShaded = 5.0;      // where it is more than this, no sunlight is left that counts
const float kLeastStep = 0.15;  // of `step`
const float kSheet = 0.2;       // depth of a stretch that is seen through one length of air, over its distance

// What scatters sunlight once after this scaled depth of cloud on its whole way, in direction and wide of the sun by
// `nu`, per unit of scaled depth.
vec3 phase_behind(float nu, float depth) {
  vec2 texel = vec2(phase_table_place(nu), peak_table_row(depth)) + 0.5;
  return textureLod(cloud_phase_lut, texel / vec2(float(kPhaseSamples), float(kCloudPeakRows)), 0.0).rgb;
}

#ifdef AIRLIGHT_THINGS
#include "shared/things_seen.glsl"
layout(scalar, set = 0, binding = 32) buffer Seen { ThingsSeen values[]; } seen;
#else
uvec2 here;  // the pixel of the tile at hand
#endif
float seen_harmonics[kCloudMoments];  // of the direction in which light comes to the camera

vec4 source_block(uint block, vec3 place) {
  CloudData c = cloud();
  float columns = float(c.coarse_x + 1u);
  float x = (float(block) * columns + cell_texel(place.x, c.coarse_x)) / (columns * float(kCloudBlocks));
  float y = cell_texel(place.y, c.coarse_y) / float(c.coarse_y + 1u);
  return textureLod(cloud_source_lut, vec3(x, y, place.z), 0.0);
}

CloudSource source_at(vec3 place) {
  float values[4u * kCloudBlocks];
  UNROLL for (uint b = 0u; b < kCloudBlocks; b++) {
    vec4 texel = source_block(b, place);
    values[4u * b] = texel.x;
    values[4u * b + 1u] = texel.y;
    values[4u * b + 2u] = texel.z;
    values[4u * b + 3u] = texel.w;
  }
  CloudSource source;
  source.sun = 0.0;
  UNROLL for (uint q = 0u; q < kCloudMoments; q++) {
    source.sun += values[q] * seen_harmonics[q];
  }
  source.sun = max(source.sun, 0.0);
  source.sky = max(values[kCloudSky] * seen_harmonics[0] + values[kCloudSky + 1u] * seen_harmonics[2] +
                       values[kCloudSky + 2u] * seen_harmonics[6],
                   0.0);
  source.ground = max(values[kCloudGround] * seen_harmonics[0] + values[kCloudGround + 1u] * seen_harmonics[2] +
                          values[kCloudGround + 2u] * seen_harmonics[6],
                      0.0);
  return source;
}

// Cells of the gaps' grid to the nearest water at least: it may stand two cells nearer than the interpolated gap says.
float empty_cells(vec3 place, uvec3 cells) {
  vec2 texel = vec2(cell_texel(place.x, cells.x), cell_texel(place.y, cells.y));
  return textureLod(cloud_gap_lut, vec3(texel / vec2(cells.xy + 1u), place.z), 0.0).r - 2.0;
}

#include "shared/cloud_ray_light.glsl"

struct Walk {
  vec3 light;     // so far, as the camera sees it
  ShadedAir shaded;  // where kAirByRay is 1
  vec3 air;       // of the air up to the last stretch
  vec3 seen;      // of it, what the cloud lets through
  CloudGathered stretch;
  float start;    // of the stretch
};

// The walk up to a distance, and the air before it.
struct Stop {
  Walk walk;
  Before before;
  vec3 clear;  // light of the air before it if there were no cloud
};

Stop stop_at(Walk walk, AirRay of, float distance_) {
  Stop stop;
  if (kAirByRay == 1u) {
    walk.shaded = further(walk.shaded, of, distance_);
    stop.clear = walk.shaded.clear.once + walk.shaded.clear.more;
    stop.before.light = walk.shaded.left;
    stop.before.transmittance = segment_transfer(walk.shaded.clear.depth).through;
  } else {
    ClearAir air = clear_air_up_to(of.ray, of.at, optical_up_to(of.ray, distance_));
    stop.clear = air.once + air.more;
    stop.before.light = stop.clear * share_by_froxels(of, distance_);
    stop.before.transmittance = segment_transfer(air.depth).through;
  }
  stop.walk = walk;
  return stop;
}

Walk closed(Walk walk, AirRay of) {
  float taken = walk.stretch.before - walk.stretch.transmittance;
  uint turns = taken > 0.0 ? 1u : 0u;
  for (uint turn = 0u; turn < turns; turn++) {
    float t = walk.stretch.reach / taken;
    Stop stop = stop_at(walk, of, t);
    walk = stop.walk;
    vec3 light = coloured(walk.stretch, of, t);
    vec3 air = max(stop.before.light - walk.air, vec3(0.0));
    walk.seen += air * walk.stretch.before;
    walk.light += air * walk.stretch.before + stop.before.transmittance * light;
    walk.air = max(stop.before.light, walk.air);
    walk.stretch = nothing_gathered(walk.stretch.transmittance);
  }
  return walk;
}

#include "shared/cloud_water.glsl"

// Steps are as long as `step` says, or shorter where the cloud is thick. Density and the depth toward the sun are
// linear between a step's ends.
Walk crossed(Walk walk, CloudCrossing span, AirRay of) {
  Ray ray = of.ray;
  vec3 direction = of.direction;
  CloudData c = cloud();
  float radius = scene.planet.ground_radius;
  float t = span.from;
  float size = max(step, t * step_rise);
  float near = 0.0;       // density at t
  float near_inside = 0.0;
  float near_sun = -1.0;  // scaled depth toward the sun there; below 0: not known
  if (span.from < span.to) {
    Water water = water_on_ray(cloud_place(radius, c, scene.camera.altitude, direction, t), t);
    near = water.extinction;
    near_inside = water.inside;
  }
  uvec3 cells = uvec3(textureSize(cloud_gap_lut, 0)) - uvec3(1u, 1u, 0u);
  vec3 per_km = vec3(cells) / vec3(c.width, c.depth, c.top - c.base);
  for (uint i = 0u; i < kMostSteps && t < span.to && walk.stretch.transmittance > kOpaque; i++) {
    // A loop of its own: lanes that leap do not wait for lanes that gather light.
    vec3 middle = vec3(0.0);
    bool leaps = true;
    while (leaps && t < span.to) {
      size = min(min(size, step_in_water(near_inside, t)), span.to - t);
      middle = cloud_place(radius, c, scene.camera.altitude, direction, t + 0.5 * size);
      float climb = abs(direction.y) + t / radius;
      float leap = empty_cells(middle, cells) / max(max(abs(direction.x) * per_km.x, abs(direction.z) * per_km.y),
                                                    climb * per_km.z);
      leaps = leap > size;
      if (leaps) {
        t += leap;
        near = 0.0;
        near_inside = 0.0;
        near_sun = -1.0;
        size = max(step, t * step_rise);
      }
    }
    if (leaps) {
      break;
    }
    vec3 end = cloud_place(radius, c, scene.camera.altitude, direction, t + size);
    Water water = water_on_ray(end, t + size);
    float far = water.extinction;
    float depth = 0.5 * (near + far) * c.scale * size;
    float least = min(size, max(step * kLeastStep, t * step_rise * kLeastStep));
    // Where the cloud begins or ends, a line between the step's ends is far from its density.
    float most = min(near, far) > 0.0 ? kStepDepth : kEdgeDepth;
    if (depth > most && size > least) {
      size = max(least, size * max(most / depth, 0.25));
      continue;
    }
    // As loops: a processor runs the code of a branch that none takes, but no turn of a loop.
    uint meets = depth > 0.0 ? 1u : 0u;
    float far_sun = near_sun;
    for (uint turn = 0u; turn < meets; turn++) {
      if (near_sun < 0.0) {
        near_sun = shade_on_ray(ray, cloud_place(radius, c, scene.camera.altitude, direction, t), t);
      }
      far_sun = shade_on_ray(ray, end, t + size);
    }
    float shade = abs(far_sun - near_sun);
    if (meets > 0u && shade > kSunStep && min(near_sun, far_sun) < kShaded && size > least) {
      size = max(least, size * max(kSunStep / shade, 0.25));
      continue;
    }
    for (uint turn = 0u; turn < meets; turn++) {
      CloudSource source = source_at(middle);
      float passed = -log(walk.stretch.transmittance) + 0.5 * (depth + near_sun + far_sun);
      walk.start = walk.stretch.before == walk.stretch.transmittance ? t : walk.start;
      walk.stretch = with_cloud_step(walk.stretch, source, phase_behind(of.at.nu, passed), near_sun, far_sun, depth,
                                     t + 0.5 * size);
      near_sun = far_sun;
    }
    near_sun = depth > 0.0 ? near_sun : -1.0;
    near = far;
    near_inside = water.inside;
    t += size;
    size = min(max(step, t * step_rise), size * clamp(kStepDepth / max(depth, 1e-6), 1.0, 2.0));
    bool begun = walk.stretch.before > walk.stretch.transmittance;
    uint closes = begun && t - walk.start > kSheet * t + step ? 1u : 0u;
    for (uint turn = 0u; turn < closes; turn++) {
      walk = closed(walk, of);
      walk.start = t;
    }
  }
  return closed(walk, of);
}

vec3 direction_of(uvec2 pixel, out bool inside) {
  if (kProjection == kProjectionListed) {
    inside = true;
    return directions.values[pixel.x].xyz;
  }
  ViewRay view = picture_ray(pixel);
  inside = view.inside;
  return view.direction;
}

// The light of a ray that ends at a distance in front of this light, as the cloud leaves it.
struct PastCloud {
  vec3 light;
  float through;  // transmittance of the cloud
  vec3 air;       // share of the air's light that is seen, of what the picture had of it
#ifdef AIRLIGHT_THINGS
  vec3 things;    // the part of the light that comes from directions of things
#endif
};

PastCloud past_cloud(AirRay of, float end, vec3 behind) {
  CloudData c = cloud();
  Walk walk;
  walk.light = vec3(0.0);
  walk.shaded = no_shaded_air();
  walk.air = vec3(0.0);
  walk.seen = vec3(0.0);
  walk.start = 0.0;
  walk.stretch = nothing_gathered(1.0);
  CloudSpans spans = cloud_spans(scene.planet.ground_radius, c, of.ray.h, of.ray.mu, end);
  if (kStretches != 2u) {
    walk = crossed(walk, spans.first, of);
  }
  if (kStretches != 1u) {
    walk = crossed(walk, spans.second, of);
  }
  PastCloud past;
  past.through = walk.stretch.transmittance > kOpaque ? walk.stretch.transmittance : 0.0;
  Stop stop = stop_at(walk, of, end);
  vec3 seen_air = walk.seen + max(stop.before.light - walk.air, vec3(0.0)) * past.through;
  if (kFurther == 1u) {
    past.air = seen_air / max(stop.before.light, vec3(1e-20));
    past.light = walk.light * scene.sun.irradiance +
                 max(behind - walk.air * scene.sun.irradiance, vec3(0.0)) * past.through;
    return past;
  }
  past.air = seen_air / max(stop.clear, vec3(1e-20));
  vec3 sky = behind - (stop.clear - stop.before.light + walk.air) * scene.sun.irradiance;
#ifndef AIRLIGHT_THINGS
  uint grounds = of.ray.at_ground ? 1u : 0u;
  for (uint turn = 0u; turn < grounds; turn++) {
    sky += stop.before.transmittance * ground_change(of.ray, of.direction) * scene.sun.irradiance;
  }
#endif
  past.light = walk.light * scene.sun.irradiance + max(sky, vec3(0.0)) * past.through;
  return past;
}

#ifdef AIRLIGHT_THINGS
// Where things fill a part of the pixel, that part ends at them and the rest behind them.
PastCloud past_cloud_and_things(AirRay of, vec3 behind, ThingsSeen things) {
  const float kFewest = 1e-4;
  PastCloud sum;
  sum.light = vec3(0.0);
  sum.through = 0.0;
  sum.air = vec3(1.0);
  sum.things = vec3(0.0);
  uint first = things.share > kFewest ? 0u : 1u;
  uint last = things.share < 1.0 - kFewest ? 2u : 1u;
  for (uint part = first; part < last; part++) {
    float share = part == 0u ? things.share : 1.0 - things.share;
    vec3 light = part == 0u ? things.light : max(behind - things.light, vec3(0.0));
    float end = part == 0u ? min(things.distance_, of.ray.length_) : of.ray.length_;
    PastCloud past = past_cloud(of, end, light / share);
    sum.light += past.light * share;
    sum.things += part == 0u ? past.light * share : vec3(0.0);
    sum.through = past.through;
    sum.air = past.air;
  }
  return sum;
}
#endif

void main() {
  uvec2 pixel = gl_GlobalInvocationID.xy;
  if (pixel.x >= width || pixel.y >= height) {
    return;
  }
  bool listed = kProjection == kProjectionListed;
  uint index = listed ? vectors * pixel.x : pixel.y * scene.tile.width + pixel.x;
  bool inside;
  vec3 direction = direction_of(pixel, inside);
  CloudData c = cloud();
  here = pixel;
  AirRay of;
  of.ray = air_ray(direction);
  of.at = factor_place(direction);
  of.direction = direction;
  of.reach = shaded_reach(scene.planet.ground_radius, highest_cloud(), of.ray.h, of.ray.mu, max(of.ray.length_, 0.0));
  UNROLL for (uint q = 0u; q < kCloudMoments; q++) {
    seen_harmonics[q] = cloud_harmonic(q, vec3(-direction.x, direction.z, -direction.y));
  }
  vec4 behind = radiance_out.values[index];
#ifdef AIRLIGHT_THINGS
  seen_sight = sight_of(vec3(0.0), direction);
  seen_phases = phases(of.at.nu);
  uint of_things = listed ? pixel.x : index;
  PastCloud past = past_cloud_and_things(of, behind.rgb, seen.values[of_things]);
  if (kFields > 1u) {
    seen.values[of_things].light = past.things;
  }
#else
  PastCloud past = past_cloud(of, of.ray.length_, behind.rgb);
#endif
  float through = past.through;
  if (inside) {
    radiance_out.values[index] = vec4(past.light, behind.a);
    if (listed) {
      radiance_out.values[index + 1u].rgb *= pow(through, 1.0 / c.scale);
      // Light of clouds is not polarised: Q and U are the air's.
      for (uint k = 2u; k < vectors; k++) {
        radiance_out.values[index + k].rgb *= past.air;
      }
    }
  }
  if (!listed) {
    // Of a beam, which loses what the peak of the phase function scatters.
    float beam = pow(through, 1.0 / c.scale);
    through_out.values[index] = kFurther == 1u ? through_out.values[index] * beam : beam;
  }
}
