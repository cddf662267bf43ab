// Light of a point source that an eye or a lens scatters around it [S95], as a function of the angle from the source.
//
// The photopic eye's point spread is 0.384 f0 + 0.478 f1 + 0.138 f2, angles in degrees:
//   f0 = 2.61e6 exp(-(angle / 0.02)^2)   what is not scattered: the picture itself
//   f1 = 20.91 / (angle + 0.02)^3        near the source, half of it within 0.05 degrees
//   f2 = 72.37 / (angle + 0.02)^2        the veil, to the edge of the field
// each of integral 1 over the half sphere in front. This file has f1 and f2 alone, scaled to 1 together. A lens
// scatters less than an eye, but falls off as steeply.
//
// The includer defines before it: GlarePoint glare_point(uint i); point 0 is the sum of all points.

const real kGlareCore = 0.02;
const real kGlareNear = 0.478 / (0.478 + 0.138);
const real kDegreesPerRadian = 57.29577951308232;

// The spread, 1/sr. `angle` and `blur` in radians; blur, the width of source or pixel, rounds the peak off.
real glare_spread(real angle, real blur) {
  real at = kDegreesPerRadian * sqrt(angle * angle + blur * blur) + kGlareCore;
  real square = at * at;
  return kGlareNear * 20.91 / (square * at) + (1.0 - kGlareNear) * 72.37 / square;
}

vec3 glare_of_point(GlarePoint point, real angle, real pixel_blur) {
  return point.irradiance * glare_spread(angle, sqrt(point.blur * point.blur + pixel_blur * pixel_blur));
}

// The sum of the points' glares near the sun; further off, where it is the same, the glare of point 0, the points' sum.
vec3 glare_along(vec3 direction, uint points, real pixel_blur) {
  GlarePoint all = glare_point(0u);
  real from_all = angle_between(direction, all.direction);
  if (from_all > all.far) {
    return glare_of_point(all, from_all, pixel_blur);
  }
  vec3 sum = vec3(0.0);
  for (uint i = 1u; i < points; i++) {
    GlarePoint point = glare_point(i);
    sum = sum + glare_of_point(point, angle_between(direction, point.direction), pixel_blur);
  }
  return sum;
}
