// Fetches from the aerial volume (physics/aerial_volume.glsl).

layout(set = 0, binding = 3) uniform sampler3D volume_lut;
layout(set = 0, binding = 4) uniform sampler2D extinction_lut;

vec3 fetch_block(uint block, FactorPlace at, float w) {
  float blocks = float(bitCount(kScatteringMedia) + 1u);
  float u = (float(block * kSkyColumns) + 0.5 + at.x * float(kSkyColumns - 1u)) / (blocks * float(kSkyColumns));
  return volume_source(textureLod(volume_lut, vec3(u, at.v, w), 0.0).rgb);
}
