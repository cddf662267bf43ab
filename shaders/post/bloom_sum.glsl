// The sum of a texel of the bloom's grid, with what the picture's rows from `first_row` to before `end_row` add to it.
// The includer declares `picture`, those rows. A sum over bands equals the sum over the whole picture to the last bit:
// its terms come in the same order, and none is fused with another.
vec3 grid_sum(vec3 so_far, uvec2 texel, vec2 scale, uint width, uint first_row, uint end_row) {
  vec2 low = vec2(texel) * scale;
  vec2 high = low + scale;
  precise vec3 sum = so_far;
  for (uint y = max(uint(low.y), first_row); y < min(uint(ceil(high.y)), end_row); y++) {
    float wy = min(float(y + 1u), high.y) - max(float(y), low.y);
    for (uint x = uint(low.x); x < min(uint(ceil(high.x)), width); x++) {
      float wx = min(float(x + 1u), high.x) - max(float(x), low.x);
      sum += picture.values[(y - first_row) * width + x].rgb * (wx * wy);
    }
  }
  return sum;
}
