// The pass over the pixels that hold stars, a list in which no pixel stands twice.
// The includer defines before it: bool disc_is_hidden(vec3 direction): a thing stands before it
layout(local_size_x = 64) in;
layout(constant_id = 4) const uint kProjection = 0u;
// The pixel's number in the tile, and its stars' radiance above the air. Floats hold numbers up to 2^24 exactly, and a
// tile has fewer pixels.
layout(scalar, set = 0, binding = 5) readonly buffer Stars { vec4 values[]; } stars;
layout(scalar, set = 0, binding = 9) buffer Radiance { vec4 values[]; } radiance_out;
layout(push_constant, scalar) uniform Push {
  uint count;
  uint width;  // of the tile
};

void main() {
  uint i = gl_GlobalInvocationID.x;
  if (i >= count) {
    return;
  }
  vec4 star = stars.values[i];
  uint pixel = uint(star.x);
  vec2 at = vec2(float(pixel % width + scene.tile.x), float(pixel / width + scene.tile.y)) + 0.5;
  vec3 direction = view_ray(scene.camera, kProjection, at.x, at.y).direction;
  vec3 through = disc_is_hidden(direction) ? vec3(0.0) : transmittance_from_space(direction);
  radiance_out.values[pixel] += vec4(star.yzw * through, 0.0);
}
