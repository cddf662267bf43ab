// All orders after the last one computed, as a geometric series with the ratio of the last two, which is taken as
// `most` at most.
vec3 tail_factor(vec3 last, vec3 one_before, real most) {
  vec3 ratio = min(last / max(one_before, vec3(1e-37)), vec3(most));
  return ratio / (vec3(1.0) - ratio);
}
