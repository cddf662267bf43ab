// Pixel -> view direction and back, in the preset's frame (x east, y up, -z north). Rays come from basis vectors, never
// from an inverted matrix at planet-centric coordinates.

struct ViewRay {
  vec3 direction;
  bool inside;  // false outside a fisheye's circle and in the corners of a cube's cross
};

vec3 direction_from_angles(real elevation, real azimuth) {
  real c = cos(elevation);
  return vec3(sin(azimuth) * c, sin(elevation), -cos(azimuth) * c);
}

ViewRay perspective_ray(CameraData camera, real x, real y) {
  real scale = tan(camera.half_fov) / (0.5 * real(camera.height));
  real u = (x - 0.5 * real(camera.width)) * scale;
  real v = (0.5 * real(camera.height) - y) * scale;
  ViewRay ray;
  ray.direction = normalize(camera.forward + camera.right * u + camera.up * v);
  ray.inside = true;
  return ray;
}

ViewRay equirectangular_ray(CameraData camera, real x, real y) {
  real elevation = kPi * (0.5 - y / real(camera.height));
  real azimuth = camera.azimuth + kPi * (2.0 * x / real(camera.width) - 1.0);
  ViewRay ray;
  ray.direction = direction_from_angles(elevation, azimuth);
  ray.inside = true;
  return ray;
}

// Equidistant: the angle from the axis grows linearly with the distance from the centre.
ViewRay fisheye_ray(CameraData camera, real x, real y) {
  real half_side = 0.5 * min(real(camera.width), real(camera.height));
  real u = (x - 0.5 * real(camera.width)) / half_side;
  real v = (0.5 * real(camera.height) - y) / half_side;
  real distance_from_centre = sqrt(u * u + v * v);
  real angle = distance_from_centre * camera.half_fov;
  real spread = distance_from_centre > 1e-6 ? sin(angle) / distance_from_centre : camera.half_fov;
  ViewRay ray;
  ray.direction = camera.forward * cos(angle) + (camera.right * u + camera.up * v) * spread;
  ray.inside = distance_from_centre <= 1.0;
  return ray;
}

ViewRay cube_ray(CameraData camera, real x, real y) {
  CubePoint point = cube_point_at(camera, x, y);
  ViewRay ray;
  ray.direction = normalize(from_camera(camera, cube_face_direction(point.face, point.u, point.v)));
  ray.inside = point.face != kNoFace;
  return ray;
}

ViewRay octahedral_ray(CameraData camera, real x, real y) {
  real u = 2.0 * x / real(camera.width) - 1.0;
  real v = 2.0 * y / real(camera.height) - 1.0;
  ViewRay ray;
  ray.direction = normalize(from_camera(camera, octahedral_direction(u, v)));
  ray.inside = true;
  return ray;
}

// x, y in pixels from the upper left corner; a pixel's centre is at a half.
ViewRay view_ray(CameraData camera, uint projection, real x, real y) {
  if (projection == kProjectionEquirectangular) {
    return equirectangular_ray(camera, x, y);
  }
  if (projection == kProjectionFisheye) {
    return fisheye_ray(camera, x, y);
  }
  if (projection == kProjectionCube) {
    return cube_ray(camera, x, y);
  }
  if (projection == kProjectionOctahedral) {
    return octahedral_ray(camera, x, y);
  }
  return perspective_ray(camera, x, y);
}

// The pixel coordinates that a direction falls on: the inverse of view_ray().
struct PixelPoint {
  real x;
  real y;
  bool in_front;  // false: behind a perspective camera
};

PixelPoint equirectangular_point(CameraData camera, vec3 direction) {
  real turn = (atan(direction.x, -direction.z) - camera.azimuth) / (2.0 * kPi) + 0.5;
  real elevation = atan(direction.y, sqrt(direction.x * direction.x + direction.z * direction.z));
  PixelPoint point;
  point.x = (turn - floor(turn)) * real(camera.width);
  point.y = (0.5 - elevation / kPi) * real(camera.height);
  point.in_front = true;
  return point;
}

PixelPoint map_point(CameraData camera, uint projection, vec3 direction) {
  vec3 local = in_camera(camera, direction);
  PixelPoint point;
  point.in_front = true;
  if (projection == kProjectionCube) {
    vec2 pixel = cube_pixel(camera, cube_face_point(cube_face_of(local), local));
    point.x = pixel.x;
    point.y = pixel.y;
    return point;
  }
  vec2 square = octahedral_point(local, octant_of(local));
  point.x = (0.5 + 0.5 * square.x) * real(camera.width);
  point.y = (0.5 + 0.5 * square.y) * real(camera.height);
  return point;
}

PixelPoint pixel_of(CameraData camera, uint projection, vec3 direction) {
  if (projection == kProjectionEquirectangular) {
    return equirectangular_point(camera, direction);
  }
  if (projection == kProjectionCube || projection == kProjectionOctahedral) {
    return map_point(camera, projection, direction);
  }
  real along = dot(direction, camera.forward);
  real x = dot(direction, camera.right);
  real y = dot(direction, camera.up);
  real scale;
  PixelPoint point;
  point.in_front = true;
  if (projection == kProjectionFisheye) {
    real off_axis = sqrt(x * x + y * y);
    real half_side = 0.5 * min(real(camera.width), real(camera.height));
    scale = atan(off_axis, along) / camera.half_fov * half_side / max(off_axis, 1e-12);
  } else {
    point.in_front = along > 1e-6;
    scale = 0.5 * real(camera.height) / tan(camera.half_fov) / max(along, 1e-6);
  }
  point.x = 0.5 * real(camera.width) + x * scale;
  point.y = 0.5 * real(camera.height) - y * scale;
  return point;
}

// The cube map and the octahedral map project planes centrally. An area at the point p of a plane with normal n,
// n.p = 1, spans 1/|p|^3 of itself as solid angle; areas on the octahedron |x| + |y| + |z| = 1 are those of the map.
real map_solid_angle_density(CameraData camera, uint projection, real x, real y) {
  vec3 p;
  real pixel;
  if (projection == kProjectionCube) {
    CubePoint point = cube_point_at(camera, x, y);
    p = cube_face_direction(point.face, point.u, point.v);
    pixel = 4.0 / (cube_side(camera) * cube_side(camera));
  } else {
    p = octahedral_direction(2.0 * x / real(camera.width) - 1.0, 2.0 * y / real(camera.height) - 1.0);
    pixel = 4.0 / (real(camera.width) * real(camera.height));
  }
  real square = dot(p, p);
  return pixel / (square * sqrt(square));
}

// Solid angle per square pixel at a point of the picture, sr.
real solid_angle_density(CameraData camera, uint projection, real x, real y) {
  if (projection == kProjectionEquirectangular) {
    real pixels = real(camera.width) * real(camera.height);
    return 2.0 * kPi * kPi / pixels * cos(kPi * (0.5 - y / real(camera.height)));
  }
  if (projection == kProjectionCube || projection == kProjectionOctahedral) {
    return map_solid_angle_density(camera, projection, x, y);
  }
  real u = x - 0.5 * real(camera.width);
  real v = y - 0.5 * real(camera.height);
  if (projection == kProjectionFisheye) {
    real pixel = 2.0 * camera.half_fov / min(real(camera.width), real(camera.height));
    real angle = sqrt(u * u + v * v) * pixel;
    return pixel * pixel * (angle > 1e-4 ? sin(angle) / angle : 1.0);
  }
  real pixel = 2.0 * tan(camera.half_fov) / real(camera.height);
  real slope = 1.0 + (u * u + v * v) * pixel * pixel;
  return pixel * pixel / (slope * sqrt(slope));
}
