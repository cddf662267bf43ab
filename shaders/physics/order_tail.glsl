// All orders after the last one computed, as a geometric series with the ratio of the last two; at most nine times it.
vec3 tail_factor(vec3 last, vec3 one_before) {
  vec3 ratio = min(last / max(one_before, vec3(1e-37)), vec3(0.9));
  return ratio / (vec3(1.0) - ratio);
}
