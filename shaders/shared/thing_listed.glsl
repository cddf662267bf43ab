// The rays of both rounds (thing_list.glsl), and the pixels of blocks of the sky.
#include "shared/thing_quads.glsl"
#include "shared/thing_list.glsl"

layout(local_size_x = 64) in;
layout(scalar, set = 0, binding = 47) buffer Quads { QuadSeen values[]; } quads_out;
layout(scalar, set = 0, binding = 48) readonly buffer List { uint values[]; } rays_list;
layout(scalar, set = 0, binding = 49) readonly buffer Units { uint values[]; } units;

shared PixelSeen seen[kThreads];

// A thread's ray, through the pixel `here`.
struct Asked {
  bool there;
  uint ray;   // of the pixel's
  uint has;   // bits of a unit
  uint quad;  // number of the quad, in the first round
};

Asked asked_of_sky(uint lane) {
  ListedBlock block = listed_block(0u);
  here = first_of_block(block.at) + uvec2(lane % kThingBlock, lane / kThingBlock);
  return Asked(block.there && here.x < width && here.y < height, 0u, 0u, 0u);
}

Asked asked_first(uint lane) {
  ListedBlock block = listed_block(lane / kQuads);
  uint quad = lane % kQuads;
  here = first_of_block(block.at) + place_in_block(quad, 0u, block_span(block.at));
  return Asked(block.there, 0u, 0u, kQuads * block_number(block.at) + quad);
}

Asked asked_of_list(uint lane) {
  uint i = (gl_WorkGroupID.y * kListGroups + gl_WorkGroupID.x) * kUnitsOfGroup + lane / kUnitRays;
  uint count = units.values[unit_count_place(kTiles)];
  uint unit = rays_list.values[unit_place(kTiles, min(i, max(count, 1u) - 1u), rays_list.values.length())];
  uint has = unit % 16u;
  uint at = unit / 16u % (kThingBlock * kThingBlock);
  uint number = unit / (16u * kThingBlock * kThingBlock);
  uvec2 block = uvec2(number % tile_row(), number / tile_row());
  uint slot = lane % kUnitRays;
  bool single = has < kUnitPixels;
  uvec2 place = single ? place_in_block(at, slot, block_span(block)) : uvec2(at % kThingBlock, at / kThingBlock);
  here = first_of_block(block) + place;
  uint first = kUnitRays * (has >= kUnitEdge ? has - kUnitEdge : has >= kUnitHorizon ? 0u : has % 2u);
  bool there = !single || (slot > 0u && (has & (1u << (slot - 1u))) != 0u);
  return Asked(there && i < count, single ? 0u : first + slot, has, 0u);
}

PixelHolds holds_of(uint has, PixelSides sides, vec3 middle) {
  PixelHolds holds = holds_alike(sides);
  if (has >= kUnitEdge) {
    return holding_edge(holds);
  }
  if (bodies_before() > 0u && has == kUnitLimb) {
    return holding_limb(holds, here, middle, limb_near(middle, pixel_width(sides)));
  }
  if (has == kUnitHorizon) {
    holds.count = horizon_rays(sides).count;
    return holds;
  }
  return has >= kUnitSeveral ? holding_several(holds) : holds;
}

void main() {
  uint lane = gl_LocalInvocationIndex;
  Asked asked;
  if (kTiles == kTilesOfSky) {
    asked = asked_of_sky(lane);
  } else if (round == 0u) {
    asked = asked_first(lane);
  } else {
    asked = asked_of_list(lane);
  }
  ViewRay middle = ray_at(here, vec2(0.5));
  PixelHolds holds = PixelHolds(false, false, false, 1u, 0.0, vec3(0.0));
  if (kTiles != kTilesOfSky) {
    holds = holds_of(asked.has, sides_of(here, middle.direction, true), middle.direction);
  }
  PixelSeen one = nothing_seen();
  if (asked.there && asked.ray < holds.count) {
    one = ray_seen(thing_ray(here, holds, asked.ray));
  }
  if (kTiles != kTilesOfSky && round == 0u) {
    if (asked.there) {
#ifdef AIRLIGHT_CLOUDS
      quads_out.values[asked.quad] = QuadSeen(one.light.i, met, one.things.distance_);
#else
      quads_out.values[asked.quad] = QuadSeen(one.light.i, met);
#endif
    }
    return;
  }
  // A pixel's first ray adds them up.
  seen[lane] = one;
  barrier();
  uint adds = asked.there && asked.ray == 0u ? holds.count : 0u;
  PixelSeen sum = nothing_seen();
  for (uint i = 0u; i < adds; i++) {
    sum = with_seen(sum, seen[lane + i]);
  }
  if (adds > 0u) {
    write_seen(middle.inside, sum);
  }
}
