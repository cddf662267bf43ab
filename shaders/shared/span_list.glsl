// Rays of the picture, each through a pixel's centre up to a distance, one thread per ray. Whole rows of the picture:
// one word per pixel, its distance, infinite where nothing is. A list: two words per ray, its pixel (column in the
// lower half, row in the upper) and its distance.
// The includer defines:
//   uint span_columns, span_count;  threads per row, also of a list; threads in all
//   uint first_row;                 the picture's row that whole rows begin with

layout(constant_id = 29) const uint kWholeRows = 0u;
layout(std430, set = 0, binding = 8) readonly buffer Spans { uint words[]; } spans;

const uint kNothing = 0x7F800000u;  // infinity

struct Span {
  uint index;
  vec2 place;  // in pixels from the upper left corner
  float distance_;
  bool is_there;
};

Span span_of(uvec2 thread) {
  Span span;
  span.index = thread.y * span_columns + thread.x;
  span.is_there = thread.x < span_columns && span.index < span_count;
  uint i = span.is_there ? span.index : 0u;
  uvec2 pixel = uvec2(thread.x, thread.y + first_row);
  uint word = spans.words[kWholeRows != 0u ? i : 2u * i + 1u];
  if (kWholeRows == 0u) {
    uint packed = spans.words[2u * i];
    pixel = uvec2(packed & 0xFFFFu, packed >> 16);
  }
  span.place = vec2(pixel) + 0.5;
  span.distance_ = uintBitsToFloat(word);
  return span;
}

bool nothing_there(Span span) { return floatBitsToUint(span.distance_) == kNothing; }
