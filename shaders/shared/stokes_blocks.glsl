// Stores Q of the light that is not sunlight scattered once in a block, and U over the sine in the next.
void store_stokes(uint block, SkyFactors factors, float cos_azimuth, uvec2 texel) {
  if (stokes()) {
    Stokes light = diffuse_stokes(factors, cos_azimuth, scene.sun.direction.y, section_of_row(texel.y) == kSectionSky);
    ivec2 at = ivec2(block * kSkyColumns + texel.x, texel.y);
    imageStore(factors_out, at, vec4(light.q * scene.sun.irradiance, 1.0));
    imageStore(factors_out, at + ivec2(kSkyColumns, 0), vec4(light.u * scene.sun.irradiance, 1.0));
  }
}
