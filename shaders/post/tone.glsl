// Tone curves: scene-linear BT.709, exposed, to display-linear 0 to 1; and the sRGB encoding.

#include "post/luminance.glsl"

// A fit to the ACES reference rendering of one channel [N16].
real tone_aces(real x) { return clamp(x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14), 0.0, 1.0); }

// [R02] eq. 3
real tone_reinhard(real x) { return x / (1.0 + x); }

real tone_exponential(real x) { return 1.0 - exp(-x); }

vec3 tone_curve(uint curve, vec3 c) {
  if (curve == kToneAces) {
    return vec3(tone_aces(c.x), tone_aces(c.y), tone_aces(c.z));
  }
  if (curve == kToneReinhard) {
    return vec3(tone_reinhard(c.x), tone_reinhard(c.y), tone_reinhard(c.z));
  }
  if (curve == kToneReinhardLuminance) {
    // Scaled by luminance, so hue stays; channels above 1 are clipped by the encoding.
    return c * (1.0 / (1.0 + luminance_bt709(c)));
  }
  if (curve == kToneExponential) {
    return vec3(tone_exponential(c.x), tone_exponential(c.y), tone_exponential(c.z));
  }
  return c;  // clamp and none: the encoding clips
}

// IEC 61966-2-1, of a value clipped to 0 to 1.
real srgb_encoded(real x) {
  real y = clamp(x, 0.0, 1.0);
  return y <= 0.0031308 ? 12.92 * y : 1.055 * pow(max(y, 0.0031308), 1.0 / 2.4) - 0.055;
}
