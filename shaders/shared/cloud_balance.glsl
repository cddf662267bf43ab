// The light on a cloud as passes/cloud_balance.comp found it.
#include "shared/cloud_around.glsl"
layout(scalar, set = 0, binding = 27) readonly buffer Light { CloudLight values[]; } cloud_light;  // of each field
layout(set = 0, binding = 45) uniform sampler3D cloud_around_lut;  // passes/cloud_around.comp

const float kRim = 0.1;  // of the grid of a cloud that stands alone, over which its light ends

CloudLight light_of_cloud() { return cloud_light.values[kField]; }

// What clouds leave on a surface of the light from about the sun, where they leave so much of the sun's: that light is
// wide, and sees the more of the field's mean the smaller the clouds before the sun look. `mean`: of the sun's light;
// `up`: sine of the sun's height.
float left_about_sun(CloudData c, float h, float lit, float mean, float up) {
  const float kWide = 0.08;  // rad
  float high = c.top - c.base;
  float size = high * max(up, 0.0) / max(0.5 * (c.top + c.base) - h, 0.5 * high);
  return mix(lit, mean, kWide * kWide / (kWide * kWide + size * size));
}

// The light of sun, sky and ground at a place of the grid, at a level of the table.
vec3 light_around(vec3 place, float level) {
  vec3 size = vec3(textureSize(cloud_around_lut, 0));
  vec2 texel = vec2(cell_texel(place.x, uint(size.x) - 1u), cell_texel(place.y, uint(size.y) - 1u));
  return textureLod(cloud_around_lut, vec3(texel, level + 0.5) / size, 0.0).rgb;
}

// Light that falls from the field on a place below it, over the mean: what the field scatters, and sky and ground past
// it. Nearer to the base than the table's last level below it, and among cells, as on that level.
vec3 falling_at(CloudLight of, vec3 place) {
  CloudData c = cloud();
  if (c.repeats == 0u) {
    return vec3(1.0);  // around a cloud that stands alone the mean is no field's
  }
  float level = around_level(c, place.z, uint(textureSize(cloud_around_lut, 0).z));
  vec3 here = light_around(place, min(level, float(kLevelsBelow - 1u)));
  vec3 mean = of.under.sun * of.falling.x + of.under.sky * of.falling.y + of.under.ground * of.falling.z;
  return (of.under.sun * here.x + of.under.sky * here.y + of.under.ground * here.z) / max(mean, vec3(1e-30));
}

// Shares of the air's light scattered more than once.
struct MoreLight {
  vec3 share;  // that is left or added
  vec3 even;   // the part of it whose light comes from all directions alike
};

// At a place of the grid. Above the cloud the share passes over to the mean of the field within the field's height,
// and what the cloud changes fades in the air between: a curve near E_2 of the depth up to there. Around a cloud that
// stands alone the sky is clear.
MoreLight more_light_at(vec3 place) {
  CloudData c = cloud();
  float level = around_level(c, place.z, uint(textureSize(cloud_around_lut, 0).z));
  vec3 light = light_around(place, level);
  CloudLight of = light_of_cloud();
  float height = clamp(place.z, 0.0, 1.0);
  vec3 within = mix(share_around(of.at_base, light), share_around(of.at_top, light), height);
  vec3 local = mix(share_around(of.under, light), within, clamp(level - float(kLevelsBelow) + 1.0, 0.0, 1.0));
  vec3 even = mix(even_around(of.at_base, light), even_around(of.at_top, light), height);
  even = mix(even_around(of.under, light), even, clamp(level - float(kLevelsBelow) + 1.0, 0.0, 1.0));
  even *= 1.0 - clamp(place.z - 1.0, 0.0, 1.0);
  vec3 share = mix(local, of.air_above, clamp(place.z - 1.0, 0.0, 1.0));
  float risen = 1.0 - exp(-max(place.z - 1.0, 0.0) * (c.top - c.base) / of.scale_height);
  vec3 left = vec3(1.0) - of.fading * (risen * (1.6 - 0.6 * risen));
  vec2 inside = min(place.xy, 1.0 - place.xy) / kRim;
  float counts = c.repeats != 0u ? 1.0 : smoothstep(0.0, 1.0, min(inside.x, inside.y));
  MoreLight more;
  more.share = vec3(1.0) + (share - 1.0) * (counts * left);
  more.even = min(even * (counts * left), more.share);
  return more;
}
