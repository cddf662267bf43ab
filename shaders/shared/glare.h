// A point of the sun's disc as the camera sees it through the air, a source of glare; the same text in C++.
struct GlarePoint {
  vec3 direction;
  real far;         // of the first point, the sum of all: from this angle on it stands for them, radians
  vec3 irradiance;  // at the camera
  real blur;        // how wide the point is, radians
};
