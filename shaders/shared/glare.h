// A point of the sun's disc as the camera sees it through the air, a source of glare; the same text in C++.
struct GlarePoint {
  vec3 direction;
  real far;         // of point 0, the sum of all: angle beyond which it replaces them, radians
  vec3 irradiance;  // at the camera
  real blur;        // the point's width, radians
};
