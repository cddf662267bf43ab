// Transmittance to the top of the atmosphere from its table.
// The includer defines the fetch; coordinates as in lut_mapping.glsl:
//   vec3 fetch_transmittance(real x, real y);

vec3 table_transmittance(PlanetData planet, real h, real mu) {
  TransmittanceCoordinate c = transmittance_coordinate(planet, h, mu);
  return fetch_transmittance(c.x, c.y);
}
