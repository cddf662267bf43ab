// The air up to what a pixel's rays meet, between the nodes of its block (passes/thing_block_air.comp).
#include "shared/thing_blocks.glsl"

layout(scalar, set = 0, binding = 43) readonly buffer Blocks { ThingBlock values[]; } blocks;
layout(scalar, set = 0, binding = 44) readonly buffer Nodes { AirNode values[]; } nodes;

bool knows_air() { return has_terrain() && (kTiles == kTilesOfSky || kTiles == kTilesOfThings); }

AirNode between_corners(uint first, vec4 shares) {
  AirNode sum = AirNode(vec3(0.0), vec3(0.0));
  UNROLL for (uint i = 0u; i < 4u; i++) {
    AirNode node = nodes.values[first + i];
    sum.source += shares[i] * node.source;
    sum.extinction += shares[i] * node.extinction;
  }
  return sum;
}

struct KnownAir {
  vec3 light;
  vec3 transmittance;
};

// `sky`: to the end of the air; else up to a surface at a distance, of which `length_` lies in the air.
KnownAir known_air(bool sky, float distance_, float length_) {
  uvec2 pixel = here + before_tile();
  uvec2 at = pixel / kThingBlock;
  uint index = at.y * tile_row() + at.x;
  vec2 place = vec2(pixel % kThingBlock) / vec2(max(block_span(at), uvec2(1u)));
  vec2 left = vec2(1.0) - place;
  vec4 shares = vec4(left.x * left.y, place.x * left.y, left.x * place.y, place.x * place.y);
  AirNode node;
  if (kTiles == kTilesOfSky) {
    node = between_corners(index * kNodes + kNodesSky, shares);
  } else {
    float far = between_nodes(blocks.values[index], distance_);
    AirNode a = between_corners(index * kNodes + (sky ? kNodesSky : 0u), shares);
    AirNode b = between_corners(index * kNodes + (sky ? kNodesSky : kNodesFar), shares);
    node.source = mix(a.source, b.source, far);
    node.extinction = mix(a.extinction, b.extinction, far);
  }
  vec3 depth = node.extinction * (sky ? 1.0 : length_);
  SegmentTransfer segment = segment_transfer(depth);
  return KnownAir(node.source * depth * segment.mean, segment.through);
}
