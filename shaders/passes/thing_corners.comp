#version 460
#extension GL_GOOGLE_include_directive : require
// What the corners of pixels see, by which pixels tell edges and begin their search for terrain: the distance of terrain,
// and the share of the sun that bodies leave to ground or terrain there.
#include "shared/device.glsl"
#include "shared/things.glsl"
#include "shared/picture_ray.glsl"
#include "shared/thing_light.h"
#include "shared/thing_tile.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(scalar, set = 0, binding = 9) writeonly buffer Corners { vec2 values[]; } corners_out;
layout(push_constant, scalar) uniform Push {
  uint width;  // of the tile's blocks and 1
  uint height;
};

void main() {
  uvec2 corner = gl_GlobalInvocationID.xy;
  if (corner.x >= width || corner.y >= height) {
    return;
  }
  vec2 at = vec2(corner + uvec2(scene.tile.x, scene.tile.y) - before_tile());
  vec3 direction = view_ray(scene.camera, kProjection, at.x, at.y).direction;
  Sight sight = sight_of(vec3(0.0), direction);
  float terrain = kNoTerrain;
  if (has_terrain()) {
    TerrainHit hit = terrain_hit(scene.planet, sight.track);
    terrain = hit.hit ? hit.distance_ : kNoTerrain;
  }
  bool ground = sight.ray.at_ground && sight.ray.length_ >= 0.0;
  vec3 point = direction * (terrain < kNoTerrain ? terrain : sight.before + sight.ray.length_);
  float share = sun_past_bodies(point, scene.sun.seen, scene.sun.angular_radius, kNoBody);
  corners_out.values[corner.y * width + corner.x] = vec2(terrain, terrain < kNoTerrain || ground ? share : 1.0);
}
