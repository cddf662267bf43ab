// Spheres before the sky: where rays meet them, their shadow and their light. Positions are from the camera, km, in its
// frame.

// Distance along a ray to where it enters the sphere; negative where it misses it.
real distance_to_sphere(SphereData s, vec3 origin, vec3 direction) {
  vec3 to = s.centre - origin;
  real along = dot(to, direction);
  vec3 off = to - direction * along;
  real inside = s.radius * s.radius - dot(off, off);
  return inside > 0.0 ? along - sqrt(max(inside, 0.0)) : -1.0;
}

// Angle from the sphere's edge, as the camera sees it, to a direction; below 0 within.
real angle_from_sphere(SphereData s, vec3 direction) {
  real far = length(s.centre);
  real size = atan(s.radius, sqrt(max(far * far - s.radius * s.radius, 0.0)));
  real along = dot(direction, s.centre);
  return atan(length(s.centre - direction * along), along) - size;
}

// Share of the sun's disc that the sphere leaves at a point: 1 where the two do not overlap; where one lies within the
// other, what a whole overlap leaves. In between it follows a limb-darkened disc behind a moving straight edge.
real sun_past_sphere(SphereData s, vec3 point, vec3 sun, real sun_radius) {
  vec3 to = s.centre - point;
  real along = dot(to, sun);
  real apart = atan(length(to - sun * along), along);
  real square = dot(to, to) - s.radius * s.radius;
  real size = atan(s.radius, sqrt(max(square, 0.0)));
  real ratio = size / max(sun_radius, 1e-9);
  real whole = min(ratio * ratio, 1.0);
  real x = clamp((apart - abs(size - sun_radius)) / (2.0 * max(min(size, sun_radius), 1e-9)), 0.0, 1.0);
  return square > 0.0 ? 1.0 - whole * (1.0 - x * x * (3.0 - 2.0 * x)) : 0.0;
}

// The part of a ray in the sphere's shadow, taken as a cylinder of the sphere's width. At its rim the share of the sun
// is about a half: what the penumbra takes away inside it adds outside.
ShadowSpan shadow_of_sphere(SphereData s, vec3 origin, vec3 direction, vec3 sun) {
  vec3 start = origin - s.centre;
  real start_along = dot(start, sun);
  real nu = dot(direction, sun);
  vec3 start_across = start - sun * start_along;
  vec3 across = direction - sun * nu;
  real a = max(dot(across, across), 1e-12);
  real b = dot(start_across, across);
  real c = dot(start_across, start_across) - s.radius * s.radius;
  real discriminant = b * b - a * c;
  ShadowSpan span;
  span.from = 0.0;
  span.to = -1.0;
  if (discriminant > 0.0) {
    real root = sqrt(discriminant);
    real behind = abs(nu) > 1e-9 ? -start_along / nu : (start_along < 0.0 ? 1e30 : -1e30);
    span.from = (-b - root) / a;
    span.to = (root - b) / a;
    // The shadow begins behind the sphere's middle, as seen from the sun.
    span.from = nu < -1e-9 ? max(span.from, behind) : span.from;
    span.to = nu < -1e-9 ? span.to : min(span.to, behind);
  }
  return span;
}

// The part inside the air of a ray from any place, relative to that place's own vertical.
Ray ray_from(PlanetData planet, real camera_altitude, vec3 origin, vec3 direction, vec3 sun) {
  Place place = place_at(planet, camera_altitude, origin);
  return ray_in_atmosphere(planet, place.h, dot(direction, place.up), dot(sun, place.up), dot(direction, sun));
}

// Thickness term of a white matte sphere's light: the view ray refracted at index 1.5, the signed distance to the
// surface summed at 0.1, 0.3, ... below 2.5 radii along it, thickness = max(0, -sum), s = strength (2.5/2)^3 /
// thickness, smoothstep(0, 2, s^0.6). It is a published form of the demo scene, whose strength is 16; its light has no
// source of its own. `cosine`: between the normal and the way back to the camera, 0 to 1.
// A sphere needs no coordinates of the points: along the refracted ray |p + t d|^2 = 1 - 2 t c + t^2, c the cosine
// inside.
real subsurface_thickness(real cosine) {
  const real kIndex = 1.5;
  const uint kPoints = 12u;
  real inside = sqrt(1.0 - max(1.0 - cosine * cosine, 0.0) / (kIndex * kIndex));
  real sum = 0.0;
  UNROLL for (uint i = 0u; i < kPoints; i++) {
    real t = 0.1 + 0.2 * real(i);
    sum = sum + sqrt(max(1.0 - 2.0 * t * inside + t * t, 0.0));
  }
  return max(real(kPoints) - sum, 0.0);  // less 1 each; in the loop compilers would move one after the other
}

// Share at this thickness; 1 without thickness, where s is infinite.
real subsurface_share(real thickness, real strength) {
  const real kReach = 2.5;
  real s = strength * (0.5 * kReach) * (0.5 * kReach) * (0.5 * kReach) / max(thickness, 1e-6);
  real x = clamp(0.5 * pow(s, 0.6), 0.0, 1.0);
  return x * x * (3.0 - 2.0 * x);
}

// Share that a sphere hides of an even hemisphere's irradiance at a surface outside of it; `to`: from there to its
// centre (Quilez, "Sphere ambient occlusion", 2006 and 2012, whose arc cosine is taken as an arc tangent).
real hidden_by_sphere(SphereData s, vec3 to, vec3 normal) {
  real far = max(length(to), s.radius * 1.0001);
  real cosine = dot(normal, to) / max(length(to), 1e-12);
  real h2 = (far / s.radius) * (far / s.radius);
  real part = 1.0 - h2 * cosine * cosine;
  if (part <= 0.0) {
    return max(cosine, 0.0) / h2;  // wholly above the surface's plane, or below
  }
  real sine = sqrt(max(1.0 - cosine * cosine, 1e-12));
  real x = -cosine * sqrt(h2 - 1.0) / sine;
  real angle = atan(sqrt(max(1.0 - x * x, 0.0)), x);
  real sum = (cosine * angle - sqrt(part * (h2 - 1.0))) / h2 + atan(sqrt(part), sqrt(h2 - 1.0));
  return clamp(sum / kPi, 0.0, 1.0);
}

// Mean radiance of what a surface sees of a matte white sphere, times pi and weighted as its irradiance is, for a beam
// of irradiance 1; `to`: from the surface to the sphere's centre, of a sphere wholly above the surface's plane. Were the
// whole part lit that can be seen, the irradiance would be the share hidden_by_sphere() of
//   m (sun . from the centre to the surface) + m2 (sun . the normal's part across `to`) / (normal . to)
// where m grows from 2/3 far away to 1 at the sphere (2/3 + k/2 - k^2/6 within 1.1 %), k = radius / distance, and m2 is
// k sqrt(1 - k) / 4 within 0.002 but close to the sphere. Far away half of a sphere is seen, of which the mean over the
// disc is known; at the sphere a point of it, where the cosine alone counts. Between them both are mixed by
// (1 - k)^(3/2), the one free number: against sums over spheres that is a tenth of the light off in the mean
// (SphereLight.IsThatOfAllItsPoints), where what holds far away is as far off as the light itself.
real lit_of_sphere(SphereData s, vec3 to, vec3 normal, vec3 sun) {
  real near = max(length(to), 1e-12);
  vec3 axis = to / near;
  real k = min(s.radius / near, 0.9999);
  real room = sqrt(1.0 - k);
  real m = 2.0 / 3.0 + k * (0.5 - k / 6.0);
  real facing = dot(normal, axis);
  real aside = dot(normal - axis * facing, sun) / max(facing, k);
  real c = clamp(-dot(axis, sun) + 0.25 * k * room / m * aside, -1.0, 1.0);
  real sine = sqrt(1.0 - c * c);
  real disc = (sine + atan(sine, -c) * c) / kPi;
  real wide = room * room * room;
  return m * (max(c, 0.0) * (1.0 - wide) + disc * wide);
}

// Irradiance of a surface by the sunlight that a mirror sphere throws there, for a beam of irradiance 1 and a sphere of
// albedo 1; `to`: from the surface to the sphere's centre. The sphere's point that throws it stands at the angle t from
// the way to the sun, the surface at phi, a distance d from the centre: light leaves at t to the normal as it comes, so
//   d sin(phi - 2 t) + r sin t = 0,
// by Newton's steps from where small angles have t. A beam that meets a mirror of radius r at that angle spreads as if
// from r cos t / 2 behind it, in the plane of the turn, and r / (2 cos t), across. No such light gets into the shadow.
real thrown_by_mirror(SphereData s, vec3 to, vec3 normal, vec3 sun) {
  real r = s.radius;
  real d = max(length(to), r * 1.0001);
  vec3 away = -to / max(length(to), 1e-12);
  real along = clamp(dot(away, sun), -1.0, 1.0);
  vec3 level = away - sun * along;
  real sine = length(level);
  real phi = atan(sine, along);
  real t = phi * d / (2.0 * d - r);
  UNROLL for (uint i = 0u; i < 3u; i++) {
    real sine_t = sin(t);
    real cosine_t = cos(t);
    real sine_2t = 2.0 * sine_t * cosine_t;
    real cosine_2t = 1.0 - 2.0 * sine_t * sine_t;
    real miss = d * (sine * cosine_2t - along * sine_2t) + r * sine_t;
    real slope = r * cosine_t - 2.0 * d * (along * cosine_2t + sine * sine_2t);
    t = clamp(t - miss / slope, 0.5 * phi, phi);
  }
  real c = cos(t);
  vec3 way = away * d - (sun * c + level * (sin(t) / max(sine, 1e-6))) * r;
  real far = max(length(way), 1e-4 * r);
  bool dark = c <= 0.0 || (along < 0.0 && d * sine < r);
  real facing = dark ? 0.0 : max(-dot(normal, way) / far, 0.0);
  c = max(c, 1e-3);
  return facing * 0.25 * r * r / ((far + 0.5 * r * c) * (far + 0.5 * r / c));
}
