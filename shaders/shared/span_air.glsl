// The air before a thing as six floats: radiance and transmittance.

layout(scalar, set = 0, binding = 9) writeonly buffer SpanAir { vec2 values[]; } air_out;

void write_air(uint i, vec3 radiance, vec3 transmittance) {
  air_out.values[3u * i] = radiance.xy;
  air_out.values[3u * i + 1u] = vec2(radiance.z, transmittance.x);
  air_out.values[3u * i + 2u] = transmittance.yz;
}
