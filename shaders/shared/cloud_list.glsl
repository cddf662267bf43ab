// Pixels whose rays are to be marched, each as its place in the tile, rows from the top, and how many workgroups of 64
// threads take them. The lattice's pass empties the list, cloud_fill.comp adds to it, cloud_picture.glsl reads it.
#ifndef AIRLIGHT_CLOUD_LIST
#define AIRLIGHT_CLOUD_LIST buffer
#endif
const uint kListGroups = 64u;  // across

layout(scalar, set = 0, binding = 44) AIRLIGHT_CLOUD_LIST CloudList {
  uvec3 groups;
  uint count;
  uint values[];
} cloud_list;
