// What a pixel of a picture with clouds shows of things, as the pass over them leaves it to the pass over the clouds.
struct ThingsSeen {
  vec3 light;       // the part of the pixel's light that comes from directions of things, of surface and air before it
  float share;      // of the pixel
  float distance_;  // mean of the things there, km
};
