// Steps split where a ray's light has a kink: at the planet's shadow and at the lowest point.

// Steps uniform in s = +-sqrt(distance from the lowest point). Up to three intervals have steps of their own, so that
// no shadow's edge and no lowest point lies inside a step. Fewer than three steps are not split.
struct StepPlan {
  real lowest;  // distance of the ray's lowest point
  real s0;      // ends of the intervals
  real s1;
  real s2;
  real s3;
  uint n1;  // steps up to s1
  uint n2;  // steps up to s2
  uint n;
};

real path_coordinate(real lowest, real t) { return t < lowest ? -sqrt(lowest - t) : sqrt(t - lowest); }

real path_distance(real lowest, real s) { return lowest + (s < 0.0 ? -s * s : s * s); }

StepPlan plan_steps(PlanetData planet, Ray ray, uint n) {
  ShadowCrossings shadow = shadow_crossings(planet, ray);
  StepPlan plan;
  plan.lowest = clamp(-(planet.ground_radius + ray.h) * ray.mu, 0.0, ray.length_);
  real first = shadow.first;
  real second = shadow.second;
  // A lowest point on the ray takes the place of a crossing that does not exist.
  if (second >= ray.length_ && plan.lowest > 0.0 && plan.lowest < ray.length_) {
    second = max(first, plan.lowest);
    first = min(first, plan.lowest);
  }
  if (n < 3u) {
    first = ray.length_;
    second = ray.length_;
  }
  plan.s0 = path_coordinate(plan.lowest, 0.0);
  plan.s1 = path_coordinate(plan.lowest, first);
  plan.s2 = path_coordinate(plan.lowest, second);
  plan.s3 = path_coordinate(plan.lowest, ray.length_);
  // An interval that is not empty gets at least one step.
  uint in_second = plan.s2 > plan.s1 ? 1u : 0u;
  uint in_third = plan.s3 > plan.s2 ? 1u : 0u;
  real scale = real(n) / max(plan.s3 - plan.s0, 1e-12);
  plan.n = n;
  plan.n1 = uint(clamp(floor((plan.s1 - plan.s0) * scale + 0.5), 1.0, real(n - in_second - in_third)));
  plan.n2 = uint(clamp(floor((plan.s2 - plan.s0) * scale + 0.5), real(plan.n1 + in_second), real(n - in_third)));
  return plan;
}

Step planned_step(StepPlan plan, uint i) {
  bool one = i < plan.n1;
  bool two = i < plan.n2;
  real low = one ? plan.s0 : two ? plan.s1 : plan.s2;
  real high = one ? plan.s1 : two ? plan.s2 : plan.s3;
  real from = real(one ? 0u : two ? plan.n1 : plan.n2);
  real to = real(one ? plan.n1 : two ? plan.n2 : plan.n);
  real width = (high - low) / max(to - from, 1.0);
  real a = path_distance(plan.lowest, low + (real(i) - from) * width);
  real b = path_distance(plan.lowest, low + (real(i) - from + 1.0) * width);
  Step s;
  s.t = 0.5 * (a + b);
  s.width = b - a;
  return s;
}
