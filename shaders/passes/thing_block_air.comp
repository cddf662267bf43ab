#version 460
#extension GL_GOOGLE_include_directive : require
// The air up to what blocks of pixels show, along few rays of a patch of them: at its corners, and four within it. The
// first time patches are squares of 2 x 2 blocks. Where the air between a square's nodes is not what the four within it
// find, the square is listed, and each of its blocks is a patch the second time. A block in which the same is so again
// is rendered ray by ray. A patch has units of four rays, as it shows surfaces, sky or both. Units of a workgroup stand
// in one list, so that no thread waits for patches that have few.
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
layout(scalar, set = 0, binding = 48) buffer Squares { uint values[]; } squares_out;  // counts of groups, and the list
layout(push_constant, scalar) uniform Push {
  uint all;    // blocks
  uint round;  // 0: patches are squares; 1: blocks of those that are listed
};

const uint kBlocksOfSquare = 4u;
const uint kLanes = 16u;  // of a patch
const uint kPatches = kThreads / kLanes;
const uint kListedGroups = 64u;  // workgroups along x the second time
const uint kSquareWords = 4u;    // before the list of squares

// Nodes that are not kept: three up to surfaces, in the middle of the patch and a quarter to either side of it, and one
// to the sky in the middle.
const uint kChecks = kNodes;
const uint kCheckSky = kNodes + 3u;
const uint kFound = kNodes + 4u;
const uint kUnits = kFound / 4u;  // of a patch: up to near surfaces, up to far ones, to the sky, and checks
shared AirNode nodes[kPatches * kFound];
shared uint units[kPatches * kUnits];
shared uint unit_count;
shared uint off[kPatches];  // 1: a check has failed

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

// Between the four nodes from `first` on.
AirNode in_patch(uint first, vec2 at) {
  return mixed(mixed(nodes[first], nodes[first + 1u], at.x), mixed(nodes[first + 2u], nodes[first + 3u], at.x), at.y);
}

// A square or a block.
struct Patch {
  ThingBlock shown;
  uvec2 at;    // its first block
  uvec2 span;  // its last pixel in the picture
  bool there;
};
shared Patch patches[kPatches];

uvec2 in_square(uint block) { return uvec2(block % 2u, block / 2u); }

ThingBlock block_at(uvec2 at) { return blocks.values[at.y * tile_row() + at.x]; }

ThingBlock both(ThingBlock a, ThingBlock b) {
  return ThingBlock(min(a.near, b.near), max(a.far, b.far), max(a.shadowed, b.shadowed), a.shows | b.shows);
}

Patch square_patch(uint i) {
  uint count = all / kBlocksOfSquare;
  uint square = min(i, count - 1u);
  uint row = tile_row() / 2u;
  Patch patch_;
  patch_.at = 2u * uvec2(square % row, square / row);
  patch_.shown = block_at(patch_.at);
  for (uint k = 1u; k < kBlocksOfSquare; k++) {
    patch_.shown = both(patch_.shown, block_at(patch_.at + in_square(k)));
  }
  patch_.span = span_from(patch_.at, kThingSquare);
  patch_.there = i < count;
  return patch_;
}

// Of listed squares.
Patch block_patch(uint i) {
  uint count = squares_out.values[3];
  uint square = squares_out.values[kSquareWords + min(i / kBlocksOfSquare, max(count, 1u) - 1u)];
  Patch patch_;
  patch_.at = uvec2(square & 0xffffu, square >> 16u) + in_square(i % kBlocksOfSquare);
  patch_.shown = block_at(patch_.at);
  patch_.span = block_span(patch_.at);
  patch_.there = i / kBlocksOfSquare < count;
  return patch_;
}

void list_square(uvec2 at) {
  uint place = atomicAdd(squares_out.values[3], 1u);
  squares_out.values[kSquareWords + place] = at.x | (at.y << 16u);
  uint squares = kPatches / kBlocksOfSquare;  // of a workgroup the second time
  squares_out.values[0] = kListedGroups;
  atomicMax(squares_out.values[1], place / (squares * kListedGroups) + 1u);
  squares_out.values[2] = 1u;
}

// Where a node stands in its patch, from -1 to 1 about the middle, and between the two distances from 0 to 1.
float check_side(uint node) { return node == kChecks + 1u ? 0.5 : node == kChecks + 2u ? -0.5 : 0.0; }

uvec2 node_pixel(uint node, uvec2 span) {
  if (node < kNodes) {
    return uvec2(node & 1u, (node >> 1u) & 1u) * span;
  }
  vec2 side = vec2(check_side(node), -check_side(node));
  return uvec2((0.5 + 0.5 * side) * vec2(span));
}

float node_distance(ThingBlock shown, uint node) {
  float between = node < kNodesFar ? 0.0 : node < kNodesSky ? 1.0 : 0.5 + 0.8 * check_side(node);
  float root = mix(sqrt(shown.near), sqrt(shown.far), between);
  return root * root;
}

bool shows_sky(ThingBlock shown) { return (shown.shows & kShowsSky) != 0u; }
bool shows_things(ThingBlock shown) { return (shown.shows & kShowsThings) != 0u; }

// Whether the air may be known between nodes.
bool is_simple(ThingBlock shown) {
  bool sky = shows_sky(shown);
  bool things = shows_things(shown);
  bool ground = (shown.shows & kAtGround) != 0u && (sky || !things);
  return (shown.shows & kHasExact) == 0u && !ground && (!things || shown.far <= kFarthest * shown.near);
}

bool has_unit(ThingBlock shown, uint unit) {
  if (!is_simple(shown)) {
    return false;
  }
  return 4u * unit < kNodesSky ? shows_things(shown) : 4u * unit >= kChecks || shows_sky(shown);
}

// Whether a node that is not kept is what lies between the patch's others, the first of which is `own`.
bool check_holds(Patch patch_, uint own, uint node) {
  ThingBlock shown = patch_.shown;
  vec2 at = vec2(node_pixel(node, patch_.span)) / vec2(max(patch_.span, uvec2(1u)));
  bool sky = node == kCheckSky;
  // Both are asked for: on a software device a branch saves nothing.
  AirNode through = in_patch(own + kNodesSky, at);
  AirNode found = mixed(in_patch(own, at), in_patch(own + kNodesFar, at), 0.5 + 0.8 * check_side(node));
  if (sky) {
    return is_near(through, nodes[own + node], 1.0, vec3(0.0), shown.shadowed > 0.0 ? 1.0 : 0.0);
  }
  return is_near(found, nodes[own + node], shown.far, shaded_surface(), shown.shadowed);
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

void find_node(uint place, uint node) {
  Patch patch_ = patches[place];
  here = first_of_block(patch_.at) + node_pixel(node, patch_.span);
  bool sky = node >= kNodesSky && node < kNodes || node == kCheckSky;
  Sight sight = sight_of(vec3(0.0), picture_ray(here).direction);
  Ray ray = sight.ray;
  if (!sky) {
    float up_to = optical_length(scene.planet, sight.from.h, sight.track.mu, node_distance(patch_.shown, node));
    ray = ray_up_to(scene.planet, sight.from.h, sight.track.mu, ray, up_to);
  }
  nodes[place * kFound + node] = node_along(sight, ray, sky);
}

// The node of block k of a square between the square's nodes.
AirNode node_in_square(Patch square, uint own, uint k, ThingBlock shown, uvec2 span, uint node) {
  vec2 at = vec2(kThingBlock * in_square(k) + node_pixel(node, span)) / vec2(max(square.span, uvec2(1u)));
  if (node >= kNodesSky) {
    return in_patch(own + kNodesSky, at);
  }
  float far = between_nodes(square.shown, node < kNodesFar ? shown.near : shown.far);
  return mixed(in_patch(own, at), in_patch(own + kNodesFar, at), far);
}

// Keeps one of a block's nodes. A ray through a gap that no pixel shows has the air up to the farthest surface.
void keep_node(uvec2 block, ThingBlock shown, uint node, AirNode found, bool gap) {
  found.extinction *= gap ? shown.far : 1.0;
  nodes_out.values[(block.y * tile_row() + block.x) * kNodes + node] = found;
}

uint known_kind(ThingBlock shown) { return shows_things(shown) ? kTilesOfThings : kTilesOfSky; }

// Keeps the nodes of a known square's blocks, those of its threads beside one another.
void keep_square(uint place, uint lane) {
  Patch square = patches[place];
  for (uint i = lane; i < kBlocksOfSquare * kNodes; i += kLanes) {
    uint k = i / kNodes;
    uint node = i % kNodes;
    uvec2 at = square.at + in_square(k);
    ThingBlock shown = block_at(at);
    if (node >= kNodesSky || shows_things(shown)) {
      bool gap = node >= kNodesSky && !shows_sky(shown);
      uint from = node - (gap ? kNodesSky - kNodesFar : 0u);
      keep_node(at, shown, node, node_in_square(square, place * kFound, k, shown, block_span(at), from), gap);
    }
  }
}

void main() {
  uint thread = gl_LocalInvocationIndex;
  uint lane = thread % kLanes;
  uint place = thread / kLanes;
  uint own = place * kFound;
  if (lane == 0u) {
    off[place] = 0u;
    uint i = (gl_WorkGroupID.y * kListedGroups + gl_WorkGroupID.x) * kPatches + place;
    if (round == 0u) {
      patches[place] = square_patch(gl_WorkGroupID.x * kPatches + place);
    } else {
      patches[place] = block_patch(i);
    }
  }
  if (thread == 0u) {
    unit_count = 0u;
  }
  barrier();
  Patch mine = patches[place];
  if (lane < kUnits && mine.there && has_unit(mine.shown, lane)) {
    units[atomicAdd(unit_count, 1u)] = place * kUnits + lane;
  }
  barrier();
  for (uint i = thread / kUnits; i < unit_count; i += kThreads / kUnits) {
    find_node(units[i] / kUnits, units[i] % kUnits * 4u + thread % 4u);
  }
  barrier();
  uint check = kChecks + lane % kUnits;
  bool shows = check == kCheckSky ? shows_sky(mine.shown) : shows_things(mine.shown);
  if (lane < kUnits && shows && !check_holds(mine, own, check)) {
    off[place] = 1u;
  }
  barrier();
  bool known = mine.there && is_simple(mine.shown) && off[place] == 0u;
  if (round == 0u) {
    uvec2 block = mine.at + in_square(min(lane, kBlocksOfSquare - 1u));
    if (known) {
      keep_square(place, lane);
    } else if (mine.there && lane == 0u) {
      list_square(mine.at);
    }
    list_block(known && lane < kBlocksOfSquare, known_kind(block_at(block)), block, all);
    return;
  }
  for (uint node = lane; mine.there && node < kNodes; node += kLanes) {
    bool gap = node >= kNodesSky && !shows_sky(mine.shown);
    keep_node(mine.at, mine.shown, node, nodes[own + node - (gap ? kNodesSky - kNodesFar : 0u)], gap);
  }
  list_block(mine.there && lane == 0u, known ? known_kind(mine.shown) : kTilesExact, mine.at, all);
}
