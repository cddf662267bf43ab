// What all passes over a picture's clouds are told.
layout(push_constant, scalar) uniform Push {
  uint width;
  uint height;
  uint vectors;     // of each listed direction
  float step;       // km, the shortest
  float step_rise;  // of the step over the distance
};
