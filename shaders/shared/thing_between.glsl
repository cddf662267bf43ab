// The pixels of a picture of things between the rays of its first round (thing_list.glsl), and the list of the second
// round's rays. A thread takes a quad of pixels.
#include "shared/device.glsl"
#include "shared/things.glsl"
#include "shared/sky_output.glsl"
#include "shared/horizon_pixels.glsl"
#include "shared/thing_pixel.glsl"

layout(push_constant, scalar) uniform Push {
  uint width;
  uint height;
  vec3 red;  // colours of the channels
  vec3 green;
  vec3 blue;
};
#include "shared/colours.glsl"
#include "shared/thing_quads.glsl"
#include "shared/thing_list.glsl"

layout(local_size_x = 64) in;
layout(scalar, set = 0, binding = 47) readonly buffer Quads { QuadSeen values[]; } quads;
layout(scalar, set = 0, binding = 48) buffer List { uint values[]; } rays_list_out;
layout(scalar, set = 0, binding = 49) buffer Units { uint values[]; } units_out;
#ifdef AIRLIGHT_CLOUDS
#include "shared/things_seen.glsl"
layout(scalar, set = 0, binding = 32) writeonly buffer Seen { ThingsSeen values[]; } seen_out;
#endif

ViewRay ray_at(uvec2 pixel, vec2 place) { return camera_ray(pixel, place); }

// The pixel `here`, which sees one thing or none; `distance_`: as QuadSeen has it.
void write_pixel(bool inside, vec3 light, float distance_) {
  write_radiance(here, inside, in_colours(light), vec3(1.0));
#ifdef AIRLIGHT_CLOUDS
  float share = distance_ > 0.0 ? 1.0 : 0.0;
  seen_out.values[here.y * scene.tile.width + here.x] = ThingsSeen(share * light, share, distance_);
#endif
}

const uint kEdgeUnits = kEdgeSide * kEdgeSide / kUnitRays;
const uint kTwoUnits = 2u;  // of several rays

shared uint holds_single[kThreads];  // 1: the pixel on a quad's ray has that one alone, inside of the picture's frame
shared uint edges;                   // pixels of the workgroup that ask for so many units
shared uint twos;
shared uint ones;
shared uint begin;  // of the workgroup's units

const float kMayDiffer = 0.05;  // light between rays that stand for the pixels between them

// The thread's quad.
struct Quad {
  ListedBlock block;
  uint number;  // of the block
  uint at;
  uvec2 last;   // place of the block's last pixel in the picture
};

// What its pixels ask for, by 8 bits each.
struct Asks {
  uint units;   // of rays: kEdgeUnits, kTwoUnits, 1 or 0
  uint places;  // which one it is of the workgroup's that ask for as many
  uint has;     // bits of the first unit
  uint waits;   // bit k: pixel k has one ray, and is not found yet
};

uint of_pixel(uint bytes, uint k) { return (bytes >> (8u * k)) & 255u; }

Asks asks_of(Quad quad, uint lane) {
  Asks asks = Asks(0u, 0u, 0u, 0u);
  holds_single[lane] = 0u;
  DONT_UNROLL for (uint k = 0u; k < kQuadPixels; k++) {
    here = first_of_block(quad.block.at) + place_in_block(quad.at, k, quad.last);
    bool mine = quad.block.there && here.x < width && here.y < height;
    if (mine || (k == 0u && quad.block.there && is_in_picture(here))) {
      ViewRay view = ray_at(here, vec2(0.5));
      PixelHolds holds = pixel_holds(here, view, sides_of(here, view.direction, false));
      bool single = view.inside && holds.count == 1u;
      holds_single[lane] = k == 0u && single ? 1u : holds_single[lane];
      asks.waits |= single && mine ? 1u << k : 0u;
      if (mine && !view.inside) {
        write_pixel(false, vec3(0.0), 0.0);
      } else if (mine && holds.edge) {
        asks.units |= kEdgeUnits << (8u * k);
        asks.places |= atomicAdd(edges, 1u) << (8u * k);
        asks.has |= kUnitEdge << (8u * k);
      } else if (mine && holds.several) {
        asks.units |= kTwoUnits << (8u * k);
        asks.places |= atomicAdd(twos, 1u) << (8u * k);
        asks.has |= kUnitSeveral << (8u * k);
      } else if (mine && holds.count > 1u) {
        asks.units |= 1u << (8u * k);
        asks.places |= atomicAdd(ones, 1u) << (8u * k);
        asks.has |= (holds.limb ? kUnitLimb : kUnitHorizon) << (8u * k);
      }
    }
  }
  return asks;
}

// Writes the pixel on the quad's ray, and those between alike rays; returns which pixels still wait.
uint found_between(Quad quad, uint lane, uint waits) {
  uvec2 at = quad_place(quad.at);
  uint beside = at.x < kQuadsAcross / 2u ? 1u : -1u;  // unsigned numbers wrap
  uint below = at.y < kQuadsAcross / 2u ? kQuadsAcross : -kQuadsAcross;
  uint ray = kQuads * quad.number + quad.at;
  QuadSeen own = quads.values[ray];
  vec4 light[4];  // and distance
  vec3 least = own.light;
  vec3 most = own.light;
  // On a map that is cut neighbours may look elsewhere.
  bool alike = kProjection != kProjectionCube && kProjection != kProjectionOctahedral;
  UNROLL for (uint i = 0u; i < 4u; i++) {
    uint other = (i & 1u) * beside + (i >> 1u) * below;
    QuadSeen there = quads.values[ray + other];
    light[i] = vec4(there.light, distance_of(there));
    least = min(least, there.light);
    most = max(most, there.light);
    alike = alike && there.met == own.met && holds_single[lane + other] != 0u;
  }
  alike = alike && all(lessThanEqual(most - least, kMayDiffer * most));
  vec2 own_place = vec2(place_in_block(quad.at, 0u, quad.last));
  vec2 way = abs(vec2(place_in_block(quad.at + beside + below, 0u, quad.last)) - own_place);
  UNROLL for (uint k = 0u; k < kQuadPixels; k++) {
    uvec2 place = place_in_block(quad.at, k, quad.last);
    vec2 along = abs(vec2(place) - own_place) / max(way, vec2(1.0));
    vec4 between = mix(mix(light[0], light[1], along.x), mix(light[2], light[3], along.x), along.y);
    here = first_of_block(quad.block.at) + place;
    bool found = (waits & (1u << k)) != 0u && (k == 0u || alike);
    if (found) {
      write_pixel(true, between.rgb, between.a);
    }
    waits &= found ? ~(1u << k) : ~0u;
  }
  return waits;
}

void add_unit(uint i, uint block, uint at, uint has) {
  uint all = rays_list_out.values.length();
  rays_list_out.values[unit_place(kTiles, begin + i, all)] = has + 16u * (at + kThingBlock * kThingBlock * block);
}

// Makes room for the workgroup's units, a multiple of an edge's, and returns how many they are.
uint units_of_group(uint lane) {
  uint all = (edges * kEdgeUnits + twos * kTwoUnits + ones + kEdgeUnits - 1u) / kEdgeUnits * kEdgeUnits;
  if (lane == 0u && all > 0u) {
    begin = atomicAdd(units_out.values[unit_count_place(kTiles)], all);
    uint groups = unit_group_place(kTiles);
    units_out.values[groups] = kListGroups;
    atomicMax(units_out.values[groups + 1u], (begin + all - 1u) / (kListGroups * kUnitsOfGroup) + 1u);
    units_out.values[groups + 2u] = 1u;
  }
  return all;
}

void main() {
  uint lane = gl_LocalInvocationIndex;
  ListedBlock block = listed_block(lane / kQuads);
  Quad quad = Quad(block, block_number(block.at), lane % kQuads, block_span(block.at));
  if (lane == 0u) {
    edges = 0u;
    twos = 0u;
    ones = 0u;
  }
  barrier();
  Asks asks = asks_of(quad, lane);
  barrier();
  asks.waits = found_between(quad, lane, asks.waits);
  uint single = asks.waits > 0u ? atomicAdd(ones, 1u) : 0u;
  barrier();
  uint all = units_of_group(lane);
  barrier();
  // Those of many units first, so that no pixel's rays are in two workgroups.
  uint first_two = edges * kEdgeUnits;
  uint first_one = first_two + twos * kTwoUnits;
  DONT_UNROLL for (uint k = 0u; k < kQuadPixels; k++) {
    uvec2 place = place_in_block(quad.at, k, quad.last);
    uint count = of_pixel(asks.units, k);
    uint before = count == kEdgeUnits ? 0u : count == kTwoUnits ? first_two : first_one;
    uint first = of_pixel(asks.places, k) * count + before;
    for (uint i = 0u; i < count; i++) {
      add_unit(first + i, quad.number, place.y * kThingBlock + place.x, of_pixel(asks.has, k) + i);
    }
  }
  if (asks.waits > 0u) {
    add_unit(first_one + single, quad.number, quad.at, asks.waits >> 1u);
  }
  uint empty = first_one + ones + lane;
  if (empty < all) {
    add_unit(empty, quad.number, 0u, 0u);
  }
}
