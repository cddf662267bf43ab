// The pixel of a thread of a pass that may run over the pixels at the planet's edge alone (horizon_pixels.glsl).

uvec2 pixel_of_thread(uvec2 thread, uint width) {
  if (kEdges != kEdgesListed) {
    return thread;
  }
  return uvec2(directions.values[thread.y * width + thread.x].xy + 0.5);
}

// Whether the thread's pixel only fills up the list, being in it once already.
bool repeats_pixel(uvec2 thread, uint width) {
  return kEdges == kEdgesListed && directions.values[thread.y * width + thread.x].z > 0.5;
}
