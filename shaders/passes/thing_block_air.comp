#version 460
#extension GL_GOOGLE_include_directive : require
// The air up to what blocks of pixels show, along few rays of each: sixteen threads a block, four of which find it
// within the block. Where the air between the other rays is not what these find, the block is rendered ray by ray.
#include "shared/device.glsl"
#include "shared/tables.glsl"
#include "shared/moment_table.glsl"
#include "shared/picture_ray.glsl"
#include "shared/horizon_pixels.glsl"
#include "physics/orders.glsl"
#include "physics/sky_factors.glsl"
#include "shared/shell_table.glsl"
#include "shared/sky_table.glsl"
#include "physics/sky_table.glsl"
#include "physics/space_table.glsl"
#include "physics/aerial_volume.glsl"
#include "shared/factor_place.glsl"
#include "shared/aerial_volume.glsl"
#include "shared/thing_tables.glsl"
#include "shared/thing_light.h"
#include "shared/thing_tile.glsl"
#include "shared/thing_blocks.glsl"

const uint kThreads = 128u;
layout(local_size_x = 128) in;
#include "shared/thing_listing.glsl"
layout(scalar, set = 0, binding = 43) readonly buffer Blocks { ThingBlock values[]; } blocks;
layout(scalar, set = 0, binding = 44) writeonly buffer Nodes { AirNode values[]; } nodes_out;
layout(push_constant, scalar) uniform Push { uint all; };  // blocks

const uint kLanes = 16u;       // threads of a block
const uint kCheckSky = kNodes;  // in the middle
const uint kChecks = kNodes + 1u;  // three up to surfaces: in the middle and a quarter to either side of it

shared AirNode nodes[kThreads];

// The greatest error of a pixel within a block, as a share of its light. Light of a dark surface in the shade counts
// as a pixel's, and what the air leaves of a bright one's as well.
const float kOff = 0.01;
const float kDark = 0.05;  // albedo

vec3 shaded_surface() {
  return scene.sun.irradiance * moment_ground_irradiance(scene.moments, scene.sun.direction.y) / kPi;
}

// `surface`: light of a white surface in the shade; 0: of none. `shadowed`: length in the shadows of bodies, km.
bool is_near(AirNode a, AirNode b, float far, vec3 surface, float shadowed) {
  vec3 depth = b.extinction * far;
  SegmentTransfer one = segment_transfer(a.extinction * far);
  SegmentTransfer two = segment_transfer(depth);
  vec3 light = b.source * depth * two.mean;
  vec3 off = abs(a.source * a.extinction * far * one.mean - light) + b.source * min(b.extinction * shadowed, 1.0) +
             surface * abs(one.through - two.through);
  vec3 most = off - kOff * (light + kDark * surface * two.through);
  return max(max(most.x, most.y), most.z) <= 0.0;
}

AirNode mixed(AirNode a, AirNode b, float share) {
  return AirNode(mix(a.source, b.source, share), mix(a.extinction, b.extinction, share));
}

AirNode in_block(uint first, vec2 at) {
  return mixed(mixed(nodes[first], nodes[first + 1u], at.x), mixed(nodes[first + 2u], nodes[first + 3u], at.x), at.y);
}

// Where a check stands in its block, from -1 to 1 about the middle, and between the two distances from 0 to 1.
float check_side(uint lane) { return lane <= kChecks ? 0.0 : lane == kChecks + 1u ? 0.5 : -0.5; }

uvec2 check_pixel(uint lane, uvec2 span) {
  vec2 side = vec2(check_side(lane), -check_side(lane));
  return uvec2((0.5 + 0.5 * side) * vec2(span));
}

uint kind_of(ThingBlock block, uint own, uvec2 span) {
  vec2 size = vec2(max(span, uvec2(1u)));
  bool sky = (block.shows & kShowsSky) != 0u;
  bool things = (block.shows & kShowsThings) != 0u;
  bool exact = (block.shows & kHasExact) != 0u || ((block.shows & kAtGround) != 0u && (sky || !things));
  // Both are asked for: on a software device a branch saves nothing.
  vec2 middle = vec2(check_pixel(kCheckSky, span)) / size;
  bool sky_known = is_near(in_block(own + kNodesSky, middle), nodes[own + kCheckSky], 1.0, vec3(0.0),
                           block.shadowed > 0.0 ? 1.0 : 0.0);
  bool known = true;
  for (uint lane = kChecks; lane < kLanes; lane++) {
    vec2 at = vec2(check_pixel(lane, span)) / size;
    AirNode found = mixed(in_block(own, at), in_block(own + kNodesFar, at), 0.5 + 0.8 * check_side(lane));
    known = known && is_near(found, nodes[own + lane], block.far, shaded_surface(), block.shadowed);
  }
  exact = exact || (sky && !sky_known) || (things && !(known && block.far <= kFarthest * block.near));
  return exact ? kTilesExact : things ? kTilesOfThings : kTilesOfSky;
}

AirNode node_along(Sight sight, Ray ray, bool sky) {
  SkyFactors air = factors_past_things(sight, ray, 0u);
  vec3 lost = air.depth * segment_transfer(air.depth).mean;
  AirNode node;
  vec3 light = phased(air, phases(seen_cosine(scene.sun, ray.mu, ray.nu))) * scene.sun.irradiance;
  node.source = light / max(lost, vec3(1e-30));
  node.extinction = air.depth / (sky ? 1.0 : max(ray.length_, 1e-12));
  return node;
}

void main() {
  uint thread = gl_LocalInvocationIndex;
  uint lane = thread % kLanes;
  uint index = (gl_WorkGroupID.x * kThreads + thread) / kLanes;
  bool mine = index < all;
  index = min(index, all - 1u);
  uvec2 at = uvec2(index % tile_row(), index / tile_row());
  ThingBlock block = blocks.values[index];
  uvec2 span = block_span(at);
  uvec2 corner = uvec2(lane & 1u, (lane >> 1u) & 1u);
  here = first_of_block(at) + (lane >= kNodes ? check_pixel(lane, span) : corner * span);
  bool sky = lane >= kNodesSky && lane <= kCheckSky;
  Sight sight = sight_of(vec3(0.0), picture_ray(here).direction);
  Ray ray = sight.ray;
  if (!sky) {
    float between = lane < kNodesFar ? 0.0 : lane < kNodesSky ? 1.0 : 0.5 + 0.8 * check_side(lane);
    float root = mix(sqrt(block.near), sqrt(block.far), between);
    float distance_ = root * root;
    float up_to = optical_length(scene.planet, sight.from.h, sight.track.mu, distance_);
    ray = ray_up_to(scene.planet, sight.from.h, sight.track.mu, ray, up_to);
  }
  AirNode node = node_along(sight, ray, sky);
  nodes[thread] = node;
  if (mine && lane < kNodes) {
    nodes_out.values[index * kNodes + lane] = node;
  }
  barrier();
  list_block(mine && lane == 0u, kind_of(block, thread - lane, span), at, all);
}
