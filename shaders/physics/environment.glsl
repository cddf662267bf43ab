// The two maps of the whole sphere that are cut: a cube's six faces and the octahedral map.
//
// A cube's axes are those that OpenEXR's latitude-longitude map of the same camera has: +Z to the camera's azimuth, +Y
// up, +X to the left. Faces stand in OpenEXR's order, +X -X +Y -Y +Z -Z, and are turned as its CubeMap functions turn
// them (ImfEnvmap.h). On a face u grows from -1 at the left to 1 at the right, v from -1 at the top to 1 at the bottom.
//
// The octahedral map: d / (|x| + |y| + |z|) seen from above, x to the right, the camera's azimuth up; the lower half of
// the octahedron is folded out into the corners.

const uint kNoFace = 6u;

struct CubePoint {
  uint face;
  real u;
  real v;
};

// Components of a direction to the right of, above and toward the camera's azimuth.
vec3 in_camera(CameraData camera, vec3 direction) {
  return vec3(dot(direction, camera.right), dot(direction, camera.up), dot(direction, camera.forward));
}

vec3 from_camera(CameraData camera, vec3 local) {
  return camera.right * local.x + camera.up * local.y + camera.forward * local.z;
}

// A point of the cube of side 2, in the axes of in_camera; not normalised.
vec3 cube_face_direction(uint face, real u, real v) {
  if (face == 0u) {
    return vec3(-1.0, -v, u);
  }
  if (face == 1u) {
    return vec3(1.0, -v, -u);
  }
  if (face == 2u) {
    return vec3(-u, 1.0, -v);
  }
  if (face == 3u) {
    return vec3(-u, -1.0, v);
  }
  if (face == 4u) {
    return vec3(u, -v, 1.0);
  }
  return vec3(-u, -v, -1.0);
}

// The component of `local` along a face's axis; a positive one means that the face is in front.
real cube_face_distance(uint face, vec3 local) {
  real along = face < 2u ? -local.x : (face < 4u ? local.y : local.z);
  return face == 0u || face == 2u || face == 4u ? along : -along;
}

// The point where a direction meets a face's plane, which may lie beyond the face. cube_face_distance must be positive.
CubePoint cube_face_point(uint face, vec3 local) {
  vec3 p = local / cube_face_distance(face, local);
  CubePoint point;
  point.face = face;
  point.v = face == 2u ? -p.z : (face == 3u ? p.z : -p.y);
  if (face < 2u) {
    point.u = face == 0u ? p.z : -p.z;
  } else {
    point.u = face == 4u ? p.x : -p.x;
  }
  return point;
}

uint cube_face_of(vec3 local) {
  real x = abs(local.x);
  real y = abs(local.y);
  real z = abs(local.z);
  if (x >= y && x >= z) {
    return local.x < 0.0 ? 0u : 1u;
  }
  if (y >= z) {
    return local.y > 0.0 ? 2u : 3u;
  }
  return local.z > 0.0 ? 4u : 5u;
}

// Pixels along a face's side.
real cube_side(CameraData camera) {
  if (camera.cube_layout == kCubeStrip) {
    return real(camera.height);
  }
  return camera.cube_layout == kCubeCross ? real(camera.width) / 3.0 : real(camera.width);
}

// A face's place in the picture, in sides from the upper left corner. In the cross the poles' faces and the one behind
// are turned by 180 degrees, so that they go on where their neighbour ends.
struct CubeCell {
  real column;
  real row;
  bool turned;
};

CubeCell cube_cell(CameraData camera, uint face) {
  CubeCell cell;
  cell.column = camera.cube_layout == kCubeStrip ? real(face) : 0.0;
  cell.row = camera.cube_layout == kCubeStack ? real(face) : 0.0;
  cell.turned = false;
  if (camera.cube_layout == kCubeCross) {
    cell.column = face == 0u ? 0.0 : (face == 1u ? 2.0 : 1.0);
    cell.row = face == 2u ? 0.0 : (face == 3u ? 2.0 : (face == 5u ? 3.0 : 1.0));
    cell.turned = face == 2u || face == 3u || face == 5u;
  }
  return cell;
}

// The face at a place given in sides; kNoFace in a cross's corners.
uint cube_face_at(CameraData camera, real column, real row) {
  if (camera.cube_layout != kCubeCross) {
    return uint(clamp(camera.cube_layout == kCubeStrip ? column : row, 0.0, 5.0));
  }
  if (row == 1.0) {
    return column == 0.0 ? 0u : (column == 1.0 ? 4u : 1u);
  }
  if (column != 1.0) {
    return kNoFace;
  }
  return row == 0.0 ? 2u : (row == 2.0 ? 3u : 5u);
}

// x, y in pixels from the upper left corner.
CubePoint cube_point_at(CameraData camera, real x, real y) {
  real side = cube_side(camera);
  real column = floor(clamp(x, 0.5, real(camera.width) - 0.5) / side);
  real row = floor(clamp(y, 0.5, real(camera.height) - 0.5) / side);
  CubePoint point;
  point.face = cube_face_at(camera, column, row);
  real turn = point.face != kNoFace && cube_cell(camera, point.face).turned ? -1.0 : 1.0;
  point.u = turn * (2.0 * (x / side - column) - 1.0);
  point.v = turn * (2.0 * (y / side - row) - 1.0);
  return point;
}

vec2 cube_pixel(CameraData camera, CubePoint point) {
  CubeCell cell = cube_cell(camera, point.face);
  real turn = cell.turned ? -1.0 : 1.0;
  real side = cube_side(camera);
  vec2 pixel;
  pixel.x = (cell.column + 0.5 + 0.5 * turn * point.u) * side;
  pixel.y = (cell.row + 0.5 + 0.5 * turn * point.v) * side;
  return pixel;
}

// Takes the square from -1 to 1, v growing downward, to a point of the octahedron |x| + |y| + |z| = 1 in the axes of
// in_camera; not normalised.
vec3 octahedral_direction(real u, real v) {
  real x = abs(u);
  real z = abs(v);
  real y = 1.0 - x - z;
  if (y < 0.0) {
    x = 1.0 - abs(v);
    z = 1.0 - abs(u);
  }
  return vec3(u < 0.0 ? -x : x, y, v < 0.0 ? z : -z);
}

// The square's point for a direction continued over the octahedron's face of these signs, which may lie beyond the
// face. dot(signs, local) must be positive.
vec2 octahedral_point(vec3 local, vec3 signs) {
  vec3 p = local / dot(signs, local);
  real x = signs.x * p.x;
  real z = signs.z * p.z;
  vec2 point;
  point.x = signs.x * (signs.y > 0.0 ? x : 1.0 - z);
  point.y = -signs.z * (signs.y > 0.0 ? z : 1.0 - x);
  return point;
}

vec3 octant_of(vec3 local) {
  return vec3(local.x < 0.0 ? -1.0 : 1.0, local.y < 0.0 ? -1.0 : 1.0, local.z < 0.0 ? -1.0 : 1.0);
}
