// The picture's pixels through exposure and tone curve to sRGB: four 16-bit channels a pixel, ready for a PNG. The
// includer defines real and includes shared/tables.h.
#include "post/tone.glsl"

layout(constant_id = 1) const uint kCurve = 0u;
layout(scalar, set = 0, binding = 0) readonly buffer Picture { vec4 values[]; } picture;
layout(scalar, set = 0, binding = 1) writeonly buffer Encoded { uvec2 values[]; } encoded_out;

void write_tone(uint index, vec3 exposed) {
  vec3 display = tone_curve(kCurve, exposed);
  vec3 srgb = vec3(srgb_encoded(display.x), srgb_encoded(display.y), srgb_encoded(display.z));
  float alpha = clamp(picture.values[index].w, 0.0, 1.0);
  encoded_out.values[index] = uvec2(packUnorm2x16(srgb.xy), packUnorm2x16(vec2(srgb.z, alpha)));
}
