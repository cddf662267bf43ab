// Places of a march's steps. The air is densest at a ray's lowest point, so steps grow with the square of the distance
// from it, on both sides where the ray dips and rises again.

struct Step {
  real t;      // where the source is evaluated: the middle of the step
  real width;
};

// The edge at a share u of the steps on a leg of the given length that starts (rising) or ends (falling) at the lowest
// point.
real leg_edge(uint distribution, bool rising, real length_, real u) {
  if (distribution == kStepsUniform) {
    return length_ * u;
  }
  real v = 1.0 - u;
  return rising ? length_ * u * u : length_ * (1.0 - v * v);
}

// Number of steps, of n, before the lowest point.
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

// End of step i of n along a ray whose lowest point is at distance `falling` (<= 0: it rises from the start; >=
// length_: it falls to its end). Step 0 starts at 0, any other step at the end of the one before.
real step_end(uint distribution, real falling, real length_, uint before, uint i, uint n) {
  real first = 0.0;
  real leg = length_;
  real index = real(i);
  real one = 1.0 / real(n);  // a step's share; quotients that are the same for all steps
  bool rising = falling < length_;
  if (distribution != kStepsUniform && before < n && before > 0u) {
    rising = i >= before;
    first = rising ? falling : 0.0;
    leg = rising ? length_ - falling : falling;
    index = rising ? real(i - before) : real(i);
    real one_rising = 1.0 / real(n - before);
    real one_falling = 1.0 / real(before);
    one = rising ? one_rising : one_falling;
  }
  return first + leg_edge(distribution, rising, leg, (index + 1.0) * one);
}

Step step_between(real start, real end) {
  Step s;
  s.t = 0.5 * (start + end);
  s.width = end - start;
  return s;
}

// Step i alone. A loop over all steps should keep each step's end instead.
Step ray_step(uint distribution, real falling, real length_, uint before, uint i, uint n) {
  real start = i > 0u ? step_end(distribution, falling, length_, before, i - 1u, n) : 0.0;
  return step_between(start, step_end(distribution, falling, length_, before, i, n));
}
