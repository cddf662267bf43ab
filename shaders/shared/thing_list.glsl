// Rays of a picture of things are asked for in two rounds. The first one has one ray in each quad of a block's pixels
// (thing_quads.glsl). Pixels between rays that look alike are found between these (passes/thing_between.comp). The
// second one has all other rays, of which this is the list: units of four rays. A pixel with an edge has four units in
// a row, a mirror or a shadow's wide edge two, the horizon or a body's limb one, and pixels of one ray in a quad are
// one. Units of simple blocks stand in the list from the front, those of exact ones from the back. Of each kind a
// buffer beside it holds three counts of workgroups and the number of units.

const uint kUnitRays = 4u;
const uint kUnitsOfGroup = 16u;
const uint kListGroups = 64u;  // workgroups along x

uint unit_group_place(uint kind) { return 4u * (kind - kTilesOfThings); }
uint unit_count_place(uint kind) { return unit_group_place(kind) + 3u; }

// `all`: words of the list.
uint unit_place(uint kind, uint i, uint all) { return kind == kTilesExact ? all - 1u - i : i; }

// A unit is 16 (64 times its block's number, and its pixel in the block or its quad) and what it has:
const uint kUnitPixels = 8u;   // below: which pixels of the quad, bits 0 to 2
const uint kUnitSeveral = 8u;   // and which unit of the pixel
const uint kUnitHorizon = 10u;
const uint kUnitLimb = 11u;
const uint kUnitEdge = 12u;
