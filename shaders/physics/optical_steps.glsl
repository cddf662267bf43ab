// Steps by optical depth: each brings an equal share of what the ray's air shows of itself, 1 - exp(-optical depth) of
// the channels' mean. In thin air that is the optical depth; thick air is divided as far as it is seen through.

// A quarter of the shares goes by the quadratic rule: a vacuum, what lies behind thick air, and the thin heights that
// alone are lit in twilight keep their steps.
struct OpticalSteps {
  uint before;                 // panels before the lowest point
  real share[kOpticalPanels];  // of the steps, up to the end of each panel
};

OpticalSteps optical_steps(PlanetData planet, Ray ray, real falling) {
  OpticalSteps o;
  o.before = falling_steps(falling, ray.length_, kOpticalPanels);
  real through = 1.0;
  real sum = 0.0;
  real start = 0.0;
  for (uint k = 0u; k < kOpticalPanels; k++) {
    real end = step_end(kStepsQuadratic, falling, ray.length_, o.before, k, kOpticalPanels);
    Step s = step_between(start, end);
    start = end;
    vec3 extinction = extinction_at(point_on_ray(planet, ray, s.t).h);
    real depth = (extinction.x + extinction.y + extinction.z) * s.width / 3.0;
    real seen = depth * mean_transmittance(depth);
    sum = sum + through * seen;
    through = max(through - through * seen, 0.0);
    o.share[k] = sum;
  }
  real even = sum > 1e-30 ? 0.25 : 1.0;
  real scale = (1.0 - even) / max(sum, 1e-30);
  for (uint k = 0u; k < kOpticalPanels; k++) {
    o.share[k] = even * real(k + 1u) / real(kOpticalPanels) + scale * o.share[k];
  }
  return o;
}

// End of step i of n. Panels are searched by halves; inside one, steps go by the quadratic rule.
real optical_step_end(OpticalSteps o, real falling, real length_, uint i, uint n) {
  real wanted = real(i + 1u) / real(n);
  uint k = o.share[7] < wanted ? 8u : 0u;
  k = o.share[k + 3u] < wanted ? k + 4u : k;
  k = o.share[k + 1u] < wanted ? k + 2u : k;
  k = o.share[k] < wanted ? k + 1u : k;
  real low = k > 0u ? o.share[k - 1u] : 0.0;
  real part = clamp((wanted - low) / max(o.share[k] - low, 1e-30), 0.0, 1.0);
  real end = quadratic_position(falling, length_, o.before, real(k) + part, kOpticalPanels);
  return i + 1u < n ? end : length_;
}
