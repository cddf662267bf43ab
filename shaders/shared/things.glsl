// The things of a scene as buffers, and what of them there is (core/things/thing_buffers.cpp).
#include "shared/terrain.h"
#include "shared/bodies.h"
#include "shared/ground.h"

layout(constant_id = 33) const uint kThings = 0u;  // bits kHasTerrain, ...

bool has_terrain() { return (kThings & kHasTerrain) != 0u; }
bool has_ground_maps() { return (kThings & kHasGroundMaps) != 0u; }
bool bodies_stand_aside() { return (kThings & kBodiesAside) != 0u; }

uvec2 here;  // the pixel of the tile at hand

#include "shared/terrain_maps.glsl"

#define BODY_BUFFER(Data, one, all, bit, place)                        \
  layout(scalar, set = 0, binding = place) readonly buffer Data##List { \
    uint count;                                                         \
    Data of[];                                                          \
  } all;                                                                \
  uint one##_count() { return (kThings & bit) != 0u ? all.count : 0u; } \
  Data one(uint i) { return all.of[i]; }
BODY_KINDS(BODY_BUFFER)
#include "physics/bodies.glsl"

#include "shared/ground_maps.glsl"

#include "physics/things.glsl"

Sight sight_of(vec3 origin, vec3 direction) {
  return sight_from(scene.planet, scene.camera.altitude, origin, direction, scene.sun.direction);
}

// Whether bodies leave the sun's light as it is, or wholly take it, within `width` of a place.
bool is_evenly_lit(vec3 point, float width) {
  float share = 1.0;
  for (uint i = 0u; i < bodies_before(); i++) {
    float far = max(length(ball_of_body(i).centre - point), 1e-9);
    share = min(share, sun_past_body(i, point, scene.sun.seen, scene.sun.angular_radius + width / far));
  }
  return share <= 0.0 || share >= 1.0;
}
