// What a block of pixels shows (passes/thing_blocks.comp), and the air up to it along few rays.

const uint kShowsSky = 1u;
const uint kShowsThings = 2u;   // or ground
const uint kAtGround = 4u;      // has rays that would end on the ground, were there nothing before it
const uint kHasExact = 8u;      // has a mirror's ray

struct ThingBlock {
  float near;  // distances of what it shows, km
  float far;
  float shadowed;  // the longest way of a ray through shadows of bodies, km
  uint shows;
};

// Along a ray up to a surface, or to the end of the air.
struct AirNode {
  vec3 source;      // light over 1 - transmittance, W/(m2 sr)
  vec3 extinction;  // mean, 1/km; to the end of the air the optical depth
};

// Nodes of a block: at its corner pixels (bit 0: right, bit 1: below) up to `near`, up to `far` and to the sky.
const uint kNodesFar = 4u;
const uint kNodesSky = 8u;
const uint kNodes = 12u;
const float kFarthest = 4.0;  // most of `far` over `near` between which the air is taken as known

// Place of a surface between the nodes' two distances.
float between_nodes(ThingBlock block, float distance_) {
  float near = sqrt(block.near);
  return clamp((sqrt(max(distance_, 0.0)) - near) / max(sqrt(block.far) - near, 1e-4 * near + 1e-12), 0.0, 1.0);
}
