// Where a cloud's grid stands. A place is seen from the planet's centre on the plane that touches the ground under the
// camera (the gnomonic projection): straight rays are straight lines on it. Its third coordinate is the altitude, so
// that a level cloud goes round the planet.

// Least cosine of the angle from the camera's vertical at which a cloud stands: the plane is stretched beyond.
const real kCloudHorizon = 0.25;

// km toward east and north, of a unit vector up in the camera's frame (x east, y up, z south) with up.y > 0.
vec2 cloud_plane(real ground_radius, vec3 up) {
  real scale = ground_radius / up.y;
  return vec2(up.x * scale, -(up.z * scale));
}
