// What a cloud makes of the light behind it on a ray: a march through it, with the air before it. The includer has the
// outputs, main() and the push constants `step` (km, the shortest) and `step_rise` (of the step over the distance).
// With AIRLIGHT_THINGS the picture is one of things, which the pass over them has lit under the cloud; rays are marched
// up to them. With AIRLIGHT_CLOUD_APART the cloud's own light is told apart; with AIRLIGHT_CLOUD_SPANS as well, rays end
// in the air, and the light behind is that of the air alone.
#include "shared/cloud_volume.glsl"
#include "shared/cloud_sunlight.glsl"
#include "physics/cloud_light.glsl"
#include "physics/cloud_march.glsl"
#include "shared/cloud_shade.glsl"
#include "shared/cloud_shafts.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
#include "shared/cloud_blocks.glsl"
layout(set = 0, binding = 28) uniform sampler2D cloud_phase_lut;
layout(set = 0, binding = 26) uniform sampler3D cloud_shafts_lut;  // cloud_shafts.comp; any image where kAirByRay is 1
// 1: this is a further field over the picture of another, whose air is shaded and whose ground is lit by all of them.
layout(constant_id = 54) const uint kFurther = 0u;
// Of the field's two stretches along a ray that dips below it. A field through which the camera looks down stands on
// both sides of those below it.
layout(constant_id = 55) const uint kStretches = 0u;  // 0: both, 1: the nearer one, 2: the farther one
layout(constant_id = 50) const uint kAirByRay = 0u;  // 1: the air's shade is found along each ray, 0: on froxels

// Turns of the march along a ray. After so many fine ones its steps grow, twice as long after 0.3 times as many again:
// few rays take more, and a device waits for its longest rays. In a thin field steps are never short, and steps of
// several cells make moire of its texture.
const float kFineTurns = 40.0;
const float kThinTurns = 64.0;
const float kShareToDouble = 0.3;
const float kMostTurns = 1024.0;

const float kOpaque = 2e-3;     // a transmittance that hides what is behind
const float kStepDepth = 1.0;   // scaled, the most of a step
const float kEdgeDepth = 0.1;   // likewise where the cloud begins or ends
const float kSunStep = 1.0;     // scaled, the most by which the depth toward the sun may change along a step
const float kShaded = 5.0;      // where it is more than this, no sunlight is left that counts
const float kLeastStep = 0.15;  // of `step`
const float kHeightShare = 0.125;  // of the cloud's height, the longest of `step` from space
#ifdef AIRLIGHT_THINGS
const bool kShowsAirAlone = false;  // pixels that do not show the ground
#else
const bool kShowsAirAlone = true;
#endif
const float kSheet = 0.2;       // depth of a stretch that is seen through one length of air, over its distance

// What scatters sunlight once after this scaled depth of cloud on its whole way, in direction and wide of the sun by
// `nu`, per unit of scaled depth.
vec3 phase_behind(float nu, float depth) {
  vec2 texel = vec2(phase_table_place(nu), peak_table_row(depth)) + 0.5;
  return textureLod(cloud_phase_lut, texel / vec2(float(kPhaseSamples), float(kCloudPeakRows)), 0.0).rgb;
}

#ifdef AIRLIGHT_THINGS
#include "shared/things_seen.glsl"
#else
uvec2 here;  // the pixel of the tile at hand
#endif
#include "shared/cloud_parts.glsl"
#include "shared/cloud_water.glsl"
#include "shared/cloud_gaps.glsl"
#include "shared/cloud_before.glsl"

// What the march through the cloud keeps from step to step.
struct March {
  float t;            // km
  float size;         // of the next step, km
  float near;         // extinction at t
  float near_inside;  // km inside the cloud there
  float near_sun;     // scaled depth toward the sun there; below 0: not known
  float start;        // of the stretch
  float turns;        // so far
  CloudGathered stretch;
  CloudPart part;
};

// How much longer steps are than they should be.
float growth_after(float turns) {
  float fine = cloud().thin == 1u ? kThinTurns : kFineTurns;
  return max(1.0, exp2((turns / fine - 1.0) / kShareToDouble));
}

// The shortest step of even water, km. From space rays cross the cloud steeply: its height bounds the step.
float step_at(AirRay of, float t) {
  float most = table_from_space() ? (cloud().top - cloud().base) * kHeightShare : 1e9;
  return max(step, min((of.before + t) * step_rise, most));
}

// The most by which a ray climbs or falls, over its way, up to t.
float steepest(AirRay of, float t) { return abs(of.ray.mu) + t / scene.planet.ground_radius; }

// How much faster than the ray its place on the plane below the camera moves: from space, toward the planet's edge.
float widened(AirRay of, float t) {
  float r = scene.planet.ground_radius + scene.camera.altitude;
  float high = r + (of.before + t) * of.direction.y;
  return table_from_space() ? scene.planet.ground_radius * r / max(high * high, 1e-6) : 1.0;
}

// Leaps over empty cells to the next step; false: no step is left before `end`.
bool next_step(inout March m, AirRay of, float end) {
  CloudData c = cloud();
  uvec3 cells = gap_cells();
  vec3 per_km = vec3(cells) / vec3(c.width, c.depth, c.top - c.base);
  bool leaps = true;
  // A loop of its own: lanes that leap do not wait for lanes that gather light.
  while (leaps && m.t < end) {
    float growth = growth_after(m.turns);
    m.turns += 1.0;
    m.size = min(min(m.size, step_in_water(m.near_inside, of.before + m.t) * growth), end - m.t);
    vec3 middle = seen_in(c, of.direction, of.before + m.t + 0.5 * m.size);
    vec2 along = abs(of.direction.xz) * per_km.xy * widened(of, m.t);
    float leap = empty_cells(middle) / max(max(along.x, along.y), steepest(of, m.t) * per_km.z);
    leaps = leap > m.size;
    m.t += leaps ? leap : 0.0;
    m.near = leaps ? 0.0 : m.near;
    m.near_inside = leaps ? 0.0 : m.near_inside;
    m.near_sun = leaps ? -1.0 : m.near_sun;
    m.size = leaps ? step_at(of, m.t) * growth : m.size;
  }
  return !leaps;
}

// One step: the cloud's light along it, or a shorter size to try again with.
void take_step(inout March m, AirRay of, SunOnSpan sun) {
  CloudData c = cloud();
  vec3 end = seen_in(c, of.direction, of.before + m.t + m.size);
  Water water = water_on_ray(end, of.before + m.t + m.size);
  float depth = 0.5 * (m.near + water.extinction) * c.scale * m.size;
  float growth = growth_after(m.turns);
  float least = min(m.size, step_at(of, m.t) * kLeastStep * growth);
  // Where the cloud begins or ends, a line between the step's ends is far from its density.
  float most = min(m.near, water.extinction) > 0.0 ? kStepDepth : kEdgeDepth;
  if (depth > most && m.size > least) {
    m.size = max(least, m.size * max(most / depth, 0.25));
    return;
  }
  bool meets = depth > 0.0;
  float far_sun = m.near_sun;
  if (meets) {
    far_sun = shade_at(end, seen_at(sun, m.t + m.size));
    if (m.near_sun < 0.0) {
      m.near_sun = shade_at(seen_in(c, of.direction, of.before + m.t), seen_at(sun, m.t));
    }
  }
  float shade = abs(far_sun - m.near_sun);
  if (meets && shade > kSunStep && min(m.near_sun, far_sun) < kShaded && m.size > least) {
    m.size = max(least, m.size * max(kSunStep / shade, 0.25));
    return;
  }
  if (meets) {
    float passed = -log(m.stretch.transmittance) + 0.5 * (depth + m.near_sun + far_sun);
    m.start = m.stretch.before == m.stretch.transmittance ? m.t : m.start;
    float before = m.stretch.transmittance;
    float t = m.t + 0.5 * m.size;
    m.stretch = with_cloud_step(m.stretch, phase_behind(of.at.nu, passed), m.near_sun, far_sun, depth, t);
    m.part = with_step_of_part(m.part, m.t, before - m.stretch.transmittance, t);
  }
  m.near_sun = meets ? far_sun : -1.0;
  m.near = water.extinction;
  m.near_inside = water.inside;
  m.t += m.size;
  m.size = min(step_at(of, m.t) * growth, m.size * clamp(kStepDepth / max(depth, 1e-6), 1.0, 2.0));
}

// Steps are as long as `step` says, or shorter where the cloud is thick. Density and the depth toward the sun are
// linear between a step's ends. The march puts stretches aside, and the air before them is found for all together, as
// the sources of their parts are: else lanes that end a stretch at different steps would wait for one another at each.
Walk crossed(Walk walk, CloudCrossing span, AirRay of, SunOnSpan sun) {
  March m;
  m.t = span.from;
  m.size = step_at(of, m.t);
  m.near = 0.0;
  m.near_inside = 0.0;
  m.near_sun = -1.0;
  m.start = 0.0;
  m.turns = 0.0;
  m.stretch = nothing_gathered(walk.transmittance);
  m.part = empty_part();
  float part_length = length_of_parts(of.direction, steepest(of, span.from));
  if (m.t < span.to) {
    Water water = water_on_ray(seen_in(cloud(), of.direction, of.before + m.t), of.before + m.t);
    m.near = water.extinction;
    m.near_inside = water.inside;
  }
  bool goes_on = true;
  while (goes_on && m.t < span.to) {
    Sheets sheets;
    sheets.count = 0u;
    CloudParts parts;
    parts.count = 0u;
    while (goes_on && sheets.count < kMostSheets && parts.count < kMostParts && m.t < span.to) {
      bool found = next_step(m, of, span.to);
      if (found) {
        take_step(m, of, sun);
      }
      goes_on = found && m.turns < kMostTurns && m.stretch.transmittance > kOpaque;
      bool begun = m.stretch.before > m.stretch.transmittance;
      bool ends = !goes_on || m.t >= span.to || m.t - m.start > kSheet * m.t + step;
      bool closes = begun && ends;
      if (m.part.taken > 0.0 && (closes || m.t - m.part.from > part_length)) {
        parts.of[parts.count] = m.part;
        parts.of[parts.count].sheet = sheets.count;
        parts.count++;
        m.part = empty_part();
      }
      if (closes) {
        sheets.of[sheets.count] = m.stretch;
        sheets.count++;
        m.stretch = nothing_gathered(m.stretch.transmittance);
        m.start = m.t;
      }
    }
    for (uint i = 0u; i < parts.count; i++) {
      CloudPart part = parts.of[i];
      CloudSource source = source_at(seen_in(cloud(), of.direction, of.before + part.reach / part.taken));
      if (part.sheet < sheets.count) {
        sheets.of[part.sheet] = with_cloud_source(sheets.of[part.sheet], source, part.taken);
      } else {
        m.stretch = with_cloud_source(m.stretch, source, part.taken);
      }
    }
    walk = with_sheets(walk, sheets, of);
  }
  walk.transmittance = m.stretch.transmittance;
  return walk;
}

// What the cloud makes of the light behind it on a ray up to a distance.
struct PastCloud {
  vec3 sent;      // light of the cloud and of the air before it
  vec3 share;     // of the light behind
  vec3 taken;     // from that share: the air's light that stands in `sent`, less what more the ground sends
  float through;  // transmittance of the cloud
  vec3 air;       // share of the air's light that is seen, of what the picture had of it
#ifdef AIRLIGHT_CLOUD_APART
  vec3 cloud;     // the part of the light that the cloud sends
  vec3 ground;    // the part that the ground sends beyond what it sent without clouds
  float reach;    // km, the mean distance of what hides the rest
#endif
};

vec3 light_past(PastCloud past, vec3 behind) {
  return past.sent + max(behind * past.share - past.taken, vec3(0.0)) * past.through;
}

PastCloud past_cloud(AirRay of, float end) {
  Walk walk = begun_walk();
  CloudSpans spans = cloud_spans(scene.planet.ground_radius, cloud(), of.ray.h, of.ray.mu, end);
  bool nearer = kStretches != 2u && spans.first.from < spans.first.to;
  bool farther = kStretches != 1u && spans.second.from < spans.second.to;
  CloudCrossing span = spans.second;
  if (nearer) {
    span = spans.first;
  }
  uint crossings = (nearer ? 1u : 0u) + (farther ? 1u : 0u);
  for (uint i = 0u; i < crossings; i++) {
    walk = crossed(walk, span, of, sun_on_span(of.ray, span));
    span = spans.second;
  }
  PastCloud past;
  past.sent = walk.light * scene.sun.irradiance;
  past.share = vec3(1.0);
  past.taken = walk.air * scene.sun.irradiance;
  past.through = walk.transmittance > kOpaque ? walk.transmittance : 0.0;
  past.air = walk.seen;
#ifdef AIRLIGHT_CLOUD_APART
  past.cloud = (walk.light - walk.seen) * scene.sun.irradiance;
  past.ground = vec3(0.0);
  past.reach = of.before + walk.reach / max(1.0 - walk.transmittance, 1e-6);
#endif
  bool known = kAirByRay == 0u && kShowsAirAlone && !of.ray.at_ground;
  if (past.through > 0.0 && (!known || kFurther == 1u)) {
    Stop stop = stop_at(walk, of, end);
    vec3 air = walk.seen + max(stop.before.light - walk.air, vec3(0.0)) * past.through;
    // The picture of a further field has the air shaded, and the ground lit, by all of them.
    vec3 had = kFurther == 1u ? stop.before.light : stop.clear;
    past.air = air / max(had, vec3(1e-20));
    past.taken = (had - stop.before.light + walk.air) * scene.sun.irradiance;
#if !defined(AIRLIGHT_THINGS) && !defined(AIRLIGHT_CLOUD_SPANS)
    if (kFurther == 0u && of.ray.at_ground) {
      vec3 more = stop.before.transmittance * ground_change(of) * scene.sun.irradiance;
      past.taken -= more;
#ifdef AIRLIGHT_CLOUD_APART
      past.ground = more * past.through;
#endif
    }
#endif
  }
  if (past.through > 0.0 && known && kFurther == 0u) {
    past.share = share_by_froxels(of, end);
  }
  return past;
}

// The ray's direction in the cloud, whose vertical is that of the place. Near the camera the two verticals are alike.
vec3 direction_in_cloud(AirRay of) {
  float r = scene.planet.ground_radius + of.ray.h;
  float mu = clamp((r * of.ray.mu + of.way.from) / (scene.planet.ground_radius + highest_cloud().top), -1.0, 1.0);
  float level = sqrt((1.0 - mu * mu) / max(dot(of.direction.xz, of.direction.xz), 1e-12));
  return table_from_space() ? vec3(of.direction.x * level, mu, of.direction.z * level) : of.direction;
}

// Begins with the ray of a pixel.
AirRay ray_through_clouds(uvec2 pixel, vec3 direction) {
  here = pixel;
  AirRay of;
  of.ray = air_ray(direction);
  of.at = factor_place(direction);
  of.direction = direction;
  of.before = way_to_air(direction);
  of.way = shaded_way(scene.planet.ground_radius, highest_cloud(), of.ray.h, of.ray.mu, max(of.ray.length_, 0.0));
  if (kAirByRay == 0u) {
    of = among_froxels(of);
  }
  vec3 along = direction_in_cloud(of);
  UNROLL for (uint q = 0u; q < kCloudMoments; q++) {
    seen_harmonics[q] = cloud_harmonic(q, vec3(-along.x, along.z, -along.y));
  }
#ifdef AIRLIGHT_THINGS
  seen_sight = sight_of(vec3(0.0), direction);
  seen_phases = phases(of.at.nu);
#endif
  return of;
}
