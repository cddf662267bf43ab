// The sun's light on its way through the shell between a cloud's base and top, and where the air's light that a cloud
// shades is summed up.

// Length of the way toward the sun from altitude h within the shell, km. From above the base a low sun's ray may fall
// through the shell, and rise through it once more.
real way_through_shell(real ground_radius, CloudData c, real h, real mu_sun) {
  CloudCrossing top = sphere_crossing(ground_radius, h, mu_sun, c.top);
  CloudCrossing base = sphere_crossing(ground_radius, h, mu_sun, c.base);
  real inside = top.from > top.to ? 0.0 : max(top.to, 0.0) - max(top.from, 0.0);
  real below = base.from > base.to ? 0.0 : max(base.to, 0.0) - max(base.from, 0.0);
  return max(inside - below, 0.0);
}

// Rows of the table of a field's mean optical depth, even in the logarithm of the shell's thickness over the way.
const real kLeastCloudSlope = 0.005;

real cloud_mean_row(real slope) {
  return (1.0 - log(clamp(slope, kLeastCloudSlope, 1.0)) / log(kLeastCloudSlope)) * real(kCloudMeanRows - 1u);
}

real cloud_mean_slope(real row) { return exp(log(kLeastCloudSlope) * (1.0 - row / real(kCloudMeanRows - 1u))); }

// Share of a ray's slices up to the distance where it leaves the shell upward: beyond it the air is shaded by a sun near
// the horizon alone.
const real kShadedSlices = 0.8;

// Distances of a ray, km, over which slices of shaded air are spread.
struct ShadedWay {
  real from;   // where it falls below the cloud's top: a slice ends there, and the next ones are the finer the nearer
  real reach;  // where it rises above the top
  real length_;
};

// Distance of the slice coordinate z, 0 to 1.
real shaded_distance(ShadedWay way, real z) {
  real near = min(z / kShadedSlices, 1.0);
  real far = max(z - kShadedSlices, 0.0) / (1.0 - kShadedSlices);
  return way.from + (way.reach - way.from) * near * near + (way.length_ - way.reach) * far * far;
}

// Its inverse; 0 before the way's `from`.
real shaded_coordinate(ShadedWay way, real t) {
  real near = sqrt(clamp((t - way.from) / max(way.reach - way.from, 1e-9), 0.0, 1.0));
  real far = sqrt(clamp((t - way.reach) / max(way.length_ - way.reach, 1e-9), 0.0, 1.0));
  return kShadedSlices * near + (1.0 - kShadedSlices) * far;
}

// Of a ray of this length. One that stays above the cloud's top has both at its lowest point, as one that touches the
// top has.
ShadedWay shaded_way(real ground_radius, CloudData c, real h, real mu, real length_) {
  CloudCrossing top = sphere_crossing(ground_radius, h, mu, c.top);
  bool misses = top.from > top.to;
  real lowest = -(ground_radius + h) * mu;
  ShadedWay way;
  way.from = clamp(misses ? lowest : top.from, 0.0, length_);
  way.reach = clamp(misses ? lowest : top.to, 0.0, length_);
  way.length_ = length_;
  return way;
}
