// The sun's or the moon's disc in a pixel, seen through the air, each sample hidden by the planet on its own.
// The includer defines before it: scene, seen_transmittance(), bending_along(), bool disc_is_hidden(vec3 direction) (planet apart),
// bool disc_is_lit(): the disc is a ball by another's light, else it shines by itself and darkens toward its limb;
// bool disc_is_covered(): another disc stands before it.

// The moon's surface follows the law of Lommel and Seeliger: radiance goes by mu0 / (mu0 + mu), cosines of the light's
// and the view's angle with the normal. Over the disc its mean is
//   1/2 (1 - sin(a/2) tan(a/2) log(cot(a/4)))   at the phase a (Lester, McCall and Tatum 1979).
// This is the inverse, by which the disc sends as much light as its irradiance says.
real lit_ball_scale(real phase) {
  real half_phase = 0.5 * phase;
  real slope = tan(half_phase);
  real faded = phase > 0.0 ? sin(half_phase) * slope * log(1.0 / tan(0.5 * half_phase)) : 0.0;
  return 2.0 / (1.0 - faded);
}

// Radiance of a lit ball over the mean of its disc.
real lit_profile(SunData ball, vec3 direction) {
  vec3 chord = direction - ball.direction;
  // Across the line of sight; the cosine of so small an angle has no digits left.
  vec3 off = (chord + ball.direction * (0.5 * dot(chord, chord))) / sin(ball.angular_radius);
  real square = dot(off, off);
  real mu = sqrt(max(1.0 - square, 0.0));
  real mu_lit = max(dot(off - ball.direction * mu, ball.lit_from), 0.0);
  real lit = mu_lit / max(mu_lit + mu, 1e-6);
  return square < 1.0 ? ball.lit_scale * lit + ball.earthshine : 0.0;
}

// Radiance of the disc over that at its centre, or, of a lit ball, over the mean.
real profile_of_disc(SunData sun, vec3 direction) {
  if (disc_is_covered() && length(direction - sun.lit_from) < sun.lit_scale) {
    return 0.0;
  }
  return disc_is_lit() ? lit_profile(sun, direction) : disc_profile(sun, length(direction - sun.direction));
}

// The direction turned down by a small angle.
vec3 lowered(vec3 direction, real angle) {
  real level = sqrt(max(direction.x * direction.x + direction.z * direction.z, 1e-12));
  real s = sin(angle);
  real c = cos(angle);
  real scale = c + direction.y / level * s;
  return vec3(direction.x * scale, direction.y * c - level * s, direction.z * scale);
}

real bent_profile(vec3 direction, real angle) {
  return profile_of_disc(scene.sun, lowered(direction, angle));
}

// Of each channel: the air bends colours by different angles.
vec3 seen_profile(vec3 direction, Ray ray) {
  if (!bends_light()) {
    return vec3(profile_of_disc(scene.sun, direction));
  }
  vec3 bent = scene.sun.dispersion * (ray.length_ < 0.0 ? 0.0 : bending_along(scene.planet, ray.h, ray.mu));
  return vec3(bent_profile(direction, bent.x), bent_profile(direction, bent.y), bent_profile(direction, bent.z));
}

// Radiance of the disc at the camera, in this direction.
vec3 disc_radiance(vec3 direction) {
  Ray ray = ray_in_atmosphere(scene.planet, scene.camera.altitude, direction.y, scene.sun.direction.y, 1.0);
  vec3 profile = seen_profile(direction, ray);
  vec3 through = ray.length_ < 0.0 ? vec3(1.0) : seen_transmittance(scene.planet, ray.h, ray.mu);
  return ray.at_ground || disc_is_hidden(direction) ? vec3(0.0) : scene.sun.disc_radiance * through * profile;
}

// Solid angle of the pixel around this point, by two points a side: exact for a cubic density.
real pixel_solid_angle(uint projection, real x, real y) {
  const real offset = 0.28867513;
  real sum = 0.0;
  for (uint i = 0u; i < 4u; i++) {
    real dx = i % 2u == 0u ? -offset : offset;
    real dy = i < 2u ? -offset : offset;
    sum += solid_angle_density(scene.camera, projection, x + dx, y + dy);
  }
  return 0.25 * sum;
}

// The disc's bounding box in pixels, which may reach beyond a round picture's seam, and the number of samples in a
// pixel, across and down.
struct DiscBox {
  vec2 low;
  vec2 high;
  uint across;
  uint down;
};

// Mean radiance of the disc over the pixel with this centre. It is integrated over the part of the pixel that lies in
// the box, by solid angle: a disc far smaller than a pixel keeps its energy, one far larger its edge.
vec3 disc_in_pixel(uint projection, real x, real y, DiscBox box) {
  bool inside = view_ray(scene.camera, projection, x, y).inside;
  if (projection == kProjectionEquirectangular) {
    // The column as near to the disc as whole turns allow.
    real around = real(scene.camera.width);
    x += floor((0.5 * (box.low.x + box.high.x) - x) / around + 0.5) * around;
  }
  real left = max(x - 0.5, box.low.x);
  real top = max(y - 0.5, box.low.y);
  real width = min(x + 0.5, box.high.x) - left;
  real height = min(y + 0.5, box.high.y) - top;
  // The loop may run no turn, in place of a branch: a branch not taken still runs, masked, on a software device.
  uint turns = width > 0.0 && height > 0.0 && inside ? box.across * box.down : 0u;
  vec3 sum = vec3(0.0);
  for (uint i = 0u; i < turns; i++) {
    real at_x = left + width * ((real(i % box.across) + 0.5) / real(box.across));
    real at_y = top + height * ((real(i / box.across) + 0.5) / real(box.down));
    sum = sum + disc_radiance(view_ray(scene.camera, projection, at_x, at_y).direction) *
                    solid_angle_density(scene.camera, projection, at_x, at_y);
  }
  real sample_area = width * height / real(box.across * box.down);
  return turns == 0u ? vec3(0.0) : sum * (sample_area / pixel_solid_angle(projection, x, y));
}
