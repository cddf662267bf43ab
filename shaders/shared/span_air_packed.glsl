// The air before a thing in 16 bytes: radiance and transmittance as six floats without sign, of 8 bits of exponent and
// 13 of mantissa. They have a float's range, are good to 2^-14, and hold 0 and 1 exactly.

layout(scalar, set = 0, binding = 9) writeonly buffer SpanAir { uvec4 values[]; } air_out;

// A negative value is an error and becomes not-a-number.
uint float21(float x) { return x >= 0.0 ? ((floatBitsToUint(x) + 512u) >> 10) & 0x1FFFFFu : 0x1FF000u; }

void write_air(uint i, vec3 radiance, vec3 transmittance) {
  uint a = float21(radiance.y);
  uint b = float21(transmittance.y);
  air_out.values[i] = uvec4(float21(radiance.x) | a << 21, a >> 11 | float21(radiance.z) << 10,
                            float21(transmittance.x) | b << 21, b >> 11 | float21(transmittance.z) << 10);
}
