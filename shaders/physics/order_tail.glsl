// Factor from the last computed order to the sum of it and all later ones: a geometric series with the ratio of the
// last two, limited to `most`.
vec3 tail_factor(vec3 last, vec3 one_before, real most) {
  vec3 ratio = min(last / max(one_before, vec3(1e-37)), vec3(most));
  return ratio / (vec3(1.0) - ratio);
}
