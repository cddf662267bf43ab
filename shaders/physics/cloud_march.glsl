// A ray through a cloud's grid: where it crosses, and the light that it gathers there.

// The ray's crossings of a sphere round the planet's centre; none: from > to.
struct CloudCrossing {
  real from;
  real to;
};

CloudCrossing sphere_crossing(real ground_radius, real h, real mu, real altitude) {
  real r = ground_radius + h;
  real b = r * mu;
  real c = (h - altitude) * (2.0 * ground_radius + h + altitude);
  real q = b * b - c;
  CloudCrossing crossing;
  crossing.from = 1.0;
  crossing.to = 0.0;
  if (q > 0.0) {
    real far = b > 0.0 ? -b - sqrt(q) : -b + sqrt(q);
    real other = c / far;
    crossing.from = min(far, other);
    crossing.to = max(far, other);
  }
  return crossing;
}

// The two parts of a ray up to `end` between base and top.
struct CloudSpans {
  CloudCrossing first;
  CloudCrossing second;
};

CloudSpans cloud_spans(real ground_radius, CloudData c, real h, real mu, real end) {
  CloudCrossing above = sphere_crossing(ground_radius, h, mu, c.top);
  CloudCrossing below = sphere_crossing(ground_radius, h, mu, c.base);
  CloudSpans spans;
  spans.first.from = max(above.from, 0.0);
  spans.first.to = min(above.to, end);
  spans.second.from = 1.0;
  spans.second.to = 0.0;
  if (above.from > above.to) {
    return spans;
  }
  if (below.from < below.to && below.to > 0.0) {
    spans.first.to = min(below.from, end);
    spans.second.from = max(below.to, 0.0);
    spans.second.to = min(above.to, end);
  }
  return spans;
}

// A point of a ray from the camera in the grid's units. `direction`: x east, y up, z south.
vec3 cloud_place(real ground_radius, CloudData c, real h, vec3 direction, real t) {
  real r = ground_radius + h;
  real stretch = ground_radius * t / (r + t * direction.y);
  real q = t * (2.0 * r * direction.y + t);
  real altitude = h + q / (sqrt(max(r * r + q, 1e-30)) + r);
  return vec3((direction.x * stretch - c.west) / c.width, (-(direction.z * stretch) - c.south) / c.depth,
              (altitude - c.base) / (c.top - c.base));
}

bool inside_cloud_grid(CloudData c, vec3 place) {
  return c.repeats != 0u || (place.x > 0.0 && place.x < 1.0 && place.y > 0.0 && place.y < 1.0);
}

// What a place of the cloud sends toward the camera of light scattered more than once, per unit of scaled depth, for
// a sun of irradiance 1, and for a sky and a ground of radiance 1.
struct CloudSource {
  real sun;
  real sky;
  real ground;
};

// Light that a stretch of a ray gathers.
struct CloudGathered {
  vec3 once;  // of the sun's light scattered once
  real sun;
  real sky;
  real ground;
  real before;         // transmittance of the cloud before the stretch, and behind it
  real transmittance;
  real reach;          // sum of distances times light taken out
};

CloudGathered nothing_gathered(real transmittance) {
  CloudGathered g;
  g.once = vec3(0.0);
  g.sun = 0.0;
  g.sky = 0.0;
  g.ground = 0.0;
  g.before = transmittance;
  g.transmittance = transmittance;
  g.reach = 0.0;
  return g;
}

// What is left of the sun's light, the mean over a step by what the camera sees of each part: the depth toward the sun
// is taken as linear between the step's ends, all depths scaled.
real seen_sunlight(real depth, real near_sun, real far_sun) {
  real both = depth + far_sun - near_sun;
  real nearest = both < 0.0 ? far_sun + depth : near_sun;
  return exp(-nearest) * mean_transmittance(abs(both));
}

// Adds a step of scaled optical depth `depth` at distance t, whose ends have these scaled depths toward the sun; `phase`
// is what scatters sunlight once there, per unit of scaled depth. Light scattered more than once is left out.
CloudGathered with_cloud_step(CloudGathered g, vec3 phase, real near_sun, real far_sun, real depth, real t) {
  real taken = g.transmittance * depth * mean_transmittance(depth);
  g.once = g.once + phase * (g.transmittance * depth * seen_sunlight(depth, near_sun, far_sun));
  g.reach = g.reach + taken * t;
  g.transmittance = g.transmittance - taken;
  return g;
}

// Adds the light scattered more than once of a part that takes this share of all light from behind it.
CloudGathered with_cloud_source(CloudGathered g, CloudSource source, real taken) {
  g.sun = g.sun + taken * source.sun;
  g.sky = g.sky + taken * source.sky;
  g.ground = g.ground + taken * source.ground;
  return g;
}
