// What clouds make of the light behind them in all directions from the camera, for mirrors near it: an octahedral map
// (physics/environment.glsl) whose outer texels lie on the square's edges. Its rays end in the sky or on the ground.
struct CloudMapRay {
  vec3 sent;      // PastCloud
  vec3 taken;
  float through;
  float beam;     // what is left of a beam
};

#ifndef AIRLIGHT_CLOUD_MAP
#define AIRLIGHT_CLOUD_MAP readonly buffer
#endif
layout(scalar, set = 0, binding = 50) AIRLIGHT_CLOUD_MAP CloudMap { CloudMapRay values[]; } cloud_map;

// Of a texel of a map of side x side.
vec3 cloud_map_direction(uvec2 at, uint side) {
  vec2 point = 2.0 * vec2(at) / float(side - 1u) - 1.0;
  return normalize(octahedral_direction(point.x, point.y));
}

CloudMapRay mixed(CloudMapRay a, CloudMapRay b, float share) {
  return CloudMapRay(mix(a.sent, b.sent, share), mix(a.taken, b.taken, share), mix(a.through, b.through, share),
                     mix(a.beam, b.beam, share));
}

CloudMapRay cloud_map_toward(vec3 direction) {
  uint side = uint(sqrt(float(cloud_map.values.length())) + 0.5);
  vec2 at = (0.5 + 0.5 * octahedral_point(direction, octant_of(direction))) * float(side - 1u);
  uvec2 texel = min(uvec2(max(at, vec2(0.0))), uvec2(side - 2u));
  vec2 part = at - vec2(texel);
  uint first = texel.y * side + texel.x;
  return mixed(mixed(cloud_map.values[first], cloud_map.values[first + 1u], part.x),
               mixed(cloud_map.values[first + side], cloud_map.values[first + side + 1u], part.x), part.y);
}
