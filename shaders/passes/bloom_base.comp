#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
// The picture averaged onto the bloom's own grid, whose texels span a fixed angle: the glow is as wide at 270 lines as
// at 2160. A picture coarser than the grid is copied.

layout(local_size_x = 16, local_size_y = 16) in;
layout(scalar, set = 0, binding = 0) readonly buffer Picture { vec4 values[]; } picture;
layout(set = 0, binding = 1, rgba32f) uniform writeonly image2D base_out;
layout(push_constant, scalar) uniform Push {
  uint width;
  uint height;
};

void main() {
  ivec2 size = imageSize(base_out);
  ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
  if (texel.x >= size.x || texel.y >= size.y) {
    return;
  }
  vec2 scale = vec2(width, height) / vec2(size);
  vec2 low = vec2(texel) * scale;
  vec2 high = low + scale;
  vec3 sum = vec3(0.0);
  for (uint y = uint(low.y); y < min(uint(ceil(high.y)), height); y++) {
    float wy = min(float(y + 1u), high.y) - max(float(y), low.y);
    for (uint x = uint(low.x); x < min(uint(ceil(high.x)), width); x++) {
      float wx = min(float(x + 1u), high.x) - max(float(x), low.x);
      sum += picture.values[y * width + x].rgb * (wx * wy);
    }
  }
  imageStore(base_out, texel, vec4(sum / (scale.x * scale.y), 1.0));
}
