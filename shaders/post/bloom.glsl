// Sampling for the bloom chain: bilinear, and across the seam of a picture that goes all the way round.

layout(constant_id = 0) const uint kWrap = 0u;  // 1: the left edge meets the right

vec3 sample_chain(sampler2D image, vec2 uv) {
  if (kWrap == 0u) {
    return textureLod(image, uv, 0.0).rgb;
  }
  float width = float(textureSize(image, 0).x);
  float u = fract(uv.x);
  float beyond = max(0.5 - u * width, 0.0) + max(u * width - (width - 0.5), 0.0);  // texels past the edge's centre
  vec3 here = textureLod(image, vec2(u, uv.y), 0.0).rgb;
  vec3 across = textureLod(image, vec2(u < 0.5 ? 1.0 : 0.0, uv.y), 0.0).rgb;
  return mix(here, across, beyond);
}

