#version 460
#extension GL_GOOGLE_include_directive : require
// The air up to what blocks of pixels show, along few rays of each: at its corners, and four within it. Where the air
// between the others is not what these find, the block is rendered ray by ray. A block has units of four rays, as it
// shows surfaces, sky or both. Units of sixteen blocks stand in one list, so that no thread waits for blocks that have
// few.
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

const uint kLanes = 8u;  // threads of a block
const uint kBlocks = kThreads / kLanes;

// Nodes that are not kept: three up to surfaces, in the middle of the block and a quarter to either side of it, and one
// to the sky in the middle.
const uint kChecks = kNodes;
const uint kCheckSky = kNodes + 3u;
const uint kFound = kNodes + 4u;
const uint kUnits = kFound / 4u;  // of a block: up to near surfaces, up to far ones, to the sky, and checks
shared AirNode nodes[kBlocks * kFound];
shared uint units[kBlocks * kUnits];
shared uint unit_count;

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

// Where a node stands in its block, from -1 to 1 about the middle, and between the two distances from 0 to 1.
float check_side(uint node) { return node == kChecks + 1u ? 0.5 : node == kChecks + 2u ? -0.5 : 0.0; }

uvec2 node_pixel(uint node, uvec2 span) {
  if (node < kNodes) {
    return uvec2(node & 1u, (node >> 1u) & 1u) * span;
  }
  vec2 side = vec2(check_side(node), -check_side(node));
  return uvec2((0.5 + 0.5 * side) * vec2(span));
}

float node_distance(ThingBlock block, uint node) {
  float between = node < kNodesFar ? 0.0 : node < kNodesSky ? 1.0 : 0.5 + 0.8 * check_side(node);
  float root = mix(sqrt(block.near), sqrt(block.far), between);
  return root * root;
}

bool shows_sky(ThingBlock block) { return (block.shows & kShowsSky) != 0u; }
bool shows_things(ThingBlock block) { return (block.shows & kShowsThings) != 0u; }

bool has_unit(ThingBlock block, uint unit) {
  return 4u * unit < kNodesSky ? shows_things(block) : 4u * unit >= kChecks || shows_sky(block);
}

uint kind_of(ThingBlock block, uint own, uvec2 span) {
  vec2 size = vec2(max(span, uvec2(1u)));
  bool sky = shows_sky(block);
  bool things = shows_things(block);
  bool exact = (block.shows & kHasExact) != 0u || ((block.shows & kAtGround) != 0u && (sky || !things));
  // Both are asked for: on a software device a branch saves nothing.
  vec2 middle = vec2(node_pixel(kCheckSky, span)) / size;
  bool sky_known = is_near(in_block(own + kNodesSky, middle), nodes[own + kCheckSky], 1.0, vec3(0.0),
                           block.shadowed > 0.0 ? 1.0 : 0.0);
  bool known = true;
  for (uint node = kChecks; node < kCheckSky; node++) {
    vec2 at = vec2(node_pixel(node, span)) / size;
    AirNode found = mixed(in_block(own, at), in_block(own + kNodesFar, at), 0.5 + 0.8 * check_side(node));
    known = known && is_near(found, nodes[own + node], block.far, shaded_surface(), block.shadowed);
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

void find_node(uint index, uint own, uint node) {
  uvec2 at = uvec2(index % tile_row(), index / tile_row());
  ThingBlock block = blocks.values[index];
  here = first_of_block(at) + node_pixel(node, block_span(at));
  bool sky = node >= kNodesSky && node < kNodes || node == kCheckSky;
  Sight sight = sight_of(vec3(0.0), picture_ray(here).direction);
  Ray ray = sight.ray;
  if (!sky) {
    float up_to = optical_length(scene.planet, sight.from.h, sight.track.mu, node_distance(block, node));
    ray = ray_up_to(scene.planet, sight.from.h, sight.track.mu, ray, up_to);
  }
  nodes[own + node] = node_along(sight, ray, sky);
}

// A ray through a gap that no pixel shows has the air up to the farthest surface.
AirNode kept_node(ThingBlock block, uint own, uint node) {
  bool gap = node >= kNodesSky && !shows_sky(block);
  AirNode found = nodes[own + node - (gap ? kNodesSky - kNodesFar : 0u)];
  found.extinction *= gap ? block.far : 1.0;
  return found;
}

void main() {
  uint thread = gl_LocalInvocationIndex;
  uint lane = thread % kLanes;
  uint place = thread / kLanes;
  uint first = gl_WorkGroupID.x * kBlocks;
  bool mine = first + place < all;
  uint index = min(first + place, all - 1u);
  ThingBlock block = blocks.values[index];
  if (thread == 0u) {
    unit_count = 0u;
  }
  barrier();
  if (mine && lane < kUnits && has_unit(block, lane)) {
    units[atomicAdd(unit_count, 1u)] = place * kUnits + lane;
  }
  barrier();
  for (uint i = thread / 4u; i < unit_count; i += kThreads / 4u) {
    uint unit = units[i];
    uint of = unit / kUnits;
    find_node(first + of, of * kFound, unit % kUnits * 4u + (lane & 3u));
  }
  barrier();
  uint own = place * kFound;
  for (uint node = lane; mine && node < kNodes; node += kLanes) {
    nodes_out.values[index * kNodes + node] = kept_node(block, own, node);
  }
  uvec2 at = uvec2(index % tile_row(), index / tile_row());
  list_block(mine && lane == 0u, kind_of(block, own, block_span(at)), at, all);
}
