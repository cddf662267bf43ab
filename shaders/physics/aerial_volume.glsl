// The air up to things, tabulated over view directions (sky_table.glsl) and distances along each: the aerial volume.
// Gathered light starts at 0 and grows with distance, so the table holds two quantities that do not: the mean
// extinction up to a slice, and the light gathered over 1 - transmittance, which is the mean source function. Both have
// a limit at the camera. Together they give no light at the camera and all of the ray's light at its end.

// Slices stand as steps do, evenly over the root of the distance from the ray's lowest point, where air is densest.
real lowest_distance(PlanetData planet, Ray ray) {
  return clamp(-(planet.ground_radius + ray.h) * ray.mu, 0.0, max(ray.length_, 0.0));
}

// Distance along the ray to the slice coordinate z, which goes from 0 to 1 over the whole ray.
real slice_distance(PlanetData planet, Ray ray, real z) {
  real lowest = lowest_distance(planet, ray);
  real near = path_coordinate(lowest, 0.0);
  real far = path_coordinate(lowest, max(ray.length_, 0.0));
  return clamp(path_distance(lowest, near + (far - near) * z), 0.0, max(ray.length_, 0.0));
}

real slice_coordinate(PlanetData planet, Ray ray, real distance_) {
  real lowest = lowest_distance(planet, ray);
  real near = path_coordinate(lowest, 0.0);
  real far = path_coordinate(lowest, max(ray.length_, 0.0));
  return clamp((path_coordinate(lowest, distance_) - near) / max(far - near, 1e-12), 0.0, 1.0);
}

// Number of steps up to a thing, as dense as `steps` steps from a ray's lowest point to the top of the air. A ray
// through all of the air takes `steps`; no ray takes less than `fewest`.
uint steps_up_to(PlanetData planet, Ray ray, real distance_, uint fewest, uint steps) {
  real lowest = lowest_distance(planet, ray);
  real all = ray.at_ground ? ray.length_ + distance_to_top(planet, ray.h, -ray.mu) : ray.length_ - lowest;
  real before = min(lowest, distance_);
  real share = (sqrt(before) + sqrt(max(distance_ - before, 0.0))) / sqrt(max(all, 1e-12));
  return uint(clamp(ceil(real(steps) * share - 1e-3), min(real(fewest), real(steps)), real(steps)));
}

// 1 - transmittance of an optical depth, without loss of digits.
vec3 gathered_share(vec3 depth) {
  SegmentTransfer segment = segment_transfer(depth);
  return depth * segment.mean;
}
