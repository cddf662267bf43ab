// Where the steps of a march stand. The air is densest at a ray's lowest point, so steps grow with the square of the
// distance from it, on both sides where the ray dips and rises again.

struct Step {
  real t;      // where the source is evaluated: the middle of the step
  real width;
};

// Edge i of n on a leg of the given length that starts (rising) or ends (falling) at the lowest point.
real leg_edge(uint distribution, bool rising, real length_, real i, real n) {
  real u = i / n;
  if (distribution == kStepsUniform) {
    return length_ * u;
  }
  real v = 1.0 - u;
  return rising ? length_ * u * u : length_ * (1.0 - v * v);
}

// How many of n steps lie before the lowest point.
uint falling_steps(real falling, real length_, uint n) {
  if (falling <= 0.0) {
    return 0u;
  }
  if (falling >= length_ || n < 2u) {
    return n;
  }
  real share = sqrt(falling) / (sqrt(falling) + sqrt(length_ - falling));
  real count = floor(share * real(n) + 0.5);
  return uint(clamp(count, 1.0, real(n) - 1.0));
}

// Step i of n along a ray whose lowest point is at distance `falling` (<= 0: it rises from the start; >= length_: it
// falls to its end).
Step ray_step(uint distribution, real falling, real length_, uint before, uint i, uint n) {
  Step s;
  real first = 0.0;
  real leg = length_;
  real index = real(i);
  real count = real(n);
  bool rising = falling < length_;
  if (distribution != kStepsUniform && before < n && before > 0u) {
    rising = i >= before;
    first = rising ? falling : 0.0;
    leg = rising ? length_ - falling : falling;
    index = rising ? real(i - before) : real(i);
    count = rising ? real(n - before) : real(before);
  }
  real a = leg_edge(distribution, rising, leg, index, count);
  real b = leg_edge(distribution, rising, leg, index + 1.0, count);
  s.t = first + 0.5 * (a + b);
  s.width = b - a;
  return s;
}
