// A picture that clouds are put into, and what they leave of beams.
layout(scalar, set = 0, binding = 9) buffer Radiance { vec4 values[]; } radiance_out;
layout(scalar, set = 0, binding = 31) buffer Through { float values[]; } through_out;

// What a cloud leaves of a beam, which loses what the peak of the phase function scatters.
float beam_of(float through, float scale) { return pow(through, 1.0 / scale); }

// `further`: over the picture of another field.
void put_pixel(uint index, vec3 light, bool inside, float beam, bool further) {
  if (inside) {
    radiance_out.values[index].rgb = light;
  }
  through_out.values[index] = further ? through_out.values[index] * beam : beam;
}
