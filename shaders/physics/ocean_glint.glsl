// The sun in the waves of an ocean. Facets of the surface are mirrors whose slopes are normally distributed, alike in
// all directions: C. Cox and W. Munk, Measurement of the Roughness of the Sea Surface from Photographs of the Sun's
// Glitter, Journal of the Optical Society of America 44, 1954 [CM54]. Hidden facets: B. Smith, Geometrical shadowing of
// a random rough surface, IEEE Transactions on Antennas and Propagation 15, 1967, for both ways together: no more light
// leaves than arrives.

const real kWaterIndex = 1.34;

// Mean square slope of a clean surface, both directions together, for a wind in m/s at 12.5 m: the fit of [CM54] for 1
// to 14 m/s.
real ocean_slope_variance(real wind) { return 0.003 + 0.00512 * wind; }

// Share of unpolarized light that still water mirrors, by the cosine to its normal: Fresnel's equations.
real water_reflectance(real cosine) {
  real inside = sqrt(1.0 - (1.0 - cosine * cosine) / (kWaterIndex * kWaterIndex));
  real across = (cosine - kWaterIndex * inside) / (cosine + kWaterIndex * inside);
  real along = (kWaterIndex * cosine - inside) / (kWaterIndex * cosine + inside);
  return 0.5 * (across * across + along * along);
}

// Smith's integral over the slopes that hide a direction of this zenith cosine, times the cosine: finite at the
// horizon. The error function is M. Abramowitz and I. Stegun, Handbook of Mathematical Functions, 7.1.26: within
// 1.5e-7.
real hiding_slopes(real variance, real mu) {
  real spread = sqrt(variance * max(1.0 - mu * mu, 0.0));
  real a = mu / max(spread, 1e-9);
  real t = 1.0 / (1.0 + 0.3275911 * a);
  real tail = t * (0.254829592 + t * (-0.284496736 + t * (1.421413741 + t * (-1.453152027 + t * 1.061405429))));
  return max(exp(-min(a * a, 80.0)) * (spread / (2.0 * sqrt(kPi)) - 0.5 * mu * tail), 0.0);
}

// Radiance that the waves mirror toward the camera for a beam of irradiance 1 on a plane that faces the sun, 1/sr. All
// directions are unit vectors away from the surface, `up` its vertical.
real ocean_glint(real variance, vec3 up, vec3 to_sun, vec3 to_camera) {
  real mu_sun = dot(up, to_sun);
  real mu = dot(up, to_camera);
  if (mu_sun <= 0.0 || mu <= 0.0) {
    return 0.0;
  }
  vec3 facet = normalize(to_sun + to_camera);
  real upright = dot(facet, up);
  vec3 tilt = facet - up * upright;
  real square = upright * upright;
  real slopes = exp(-min(dot(tilt, tilt) / (square * variance), 80.0)) / (kPi * variance * square * square);
  real seen = mu_sun * mu + mu * hiding_slopes(variance, mu_sun) + mu_sun * hiding_slopes(variance, mu);
  return water_reflectance(clamp(dot(facet, to_sun), 0.0, 1.0)) * slopes * mu_sun / (4.0 * seen);
}
