// Layout of a picture's layers: planes of floats, three per layer, over the pixels of the tile at hand. The order is
// single scattering of each medium that scatters, multiple scattering, the ground, the transmittance, Q and U if asked
// for.
#include "shared/scattering_media.glsl"
#include "shared/picture_ray.glsl"
#include "shared/horizon_pixels.glsl"
#include "physics/layers.glsl"

layout(scalar, set = 0, binding = 9) writeonly buffer Layers { float values[]; } layers_out;

void write_layer(uint layer, uvec2 pixel, uvec2 size, bool inside, vec3 value) {
  uint plane = size.x * size.y;
  uint at = 3u * layer * plane + pixel.y * size.x + pixel.x;
  layers_out.values[at] = inside ? value.x : 0.0;
  layers_out.values[at + plane] = inside ? value.y : 0.0;
  layers_out.values[at + 2u * plane] = inside ? value.z : 0.0;
}

void write_single(uint i, uvec2 pixel, uvec2 size, bool inside, LightLayers layers) {
  if (scatters(i)) {
    write_layer(single_block(i), pixel, size, inside, layers.single[i]);
  }
}

void write_layers(uvec2 pixel, uvec2 size, bool inside, LightLayers layers) {
  UNROLL for (uint i = 0u; i < kMaxMedia; i++) {
    write_single(i, pixel, size, inside, layers);
  }
  uint rest = diffuse_block();
  write_layer(rest, pixel, size, inside, layers.multiple);
  write_layer(rest + 1u, pixel, size, inside, layers.ground);
  write_layer(rest + 2u, pixel, size, inside, layers.transmittance);
  if (stokes()) {
    write_layer(rest + 3u, pixel, size, inside, layers.q);
    write_layer(rest + 4u, pixel, size, inside, layers.u);
  }
}
