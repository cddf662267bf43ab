#include "core/composite/camera.h"

#include <Eigen/LU>
#include <cmath>

#include "core/base/error.h"
#include "core/physics/vector.h"

namespace airlight::composite {
namespace {

using physics::vec3;
using Row = Eigen::RowVector4d;
using SquareOfRows = Eigen::Matrix<double, 4, 4, Eigen::RowMajor>;

SquareOfRows square(const Matrix& matrix) {
  return Eigen::Map<const SquareOfRows>(matrix.data());
}

// None for a matrix without an inverse, or with a value that is not a number.
std::optional<SquareOfRows> inverse(const Matrix& matrix) {
  Eigen::FullPivLU<SquareOfRows> factors(square(matrix));
  factors.setThreshold(1e-300);  // units and lenses may be far apart
  const bool there = square(matrix).allFinite() && factors.isInvertible();
  return there ? std::optional<SquareOfRows>(factors.inverse()) : std::nullopt;
}

// Converts into the preset's frame: x east, y up, -z north.
vec3 in_preset(const vec3& v, UpAxis up) {
  return up == UpAxis::y ? v : vec3{v.x, v.z, -v.y};
}

struct Place {
  vec3 position;
  vec3 right;
  vec3 up;
  vec3 forward;
};

FileCamera angles_of(const Place& place, double unit_km) {
  FileCamera camera;
  const vec3& f = place.forward;
  const double level = std::hypot(f.x, f.z);
  camera.altitude = place.position.y * unit_km;
  camera.pitch = std::atan2(f.y, level);
  if (level > 1e-6) {
    camera.azimuth = std::atan2(f.x, -f.z);
  } else {
    // When the camera looks straight up or down, the direction of the picture's upper edge gives the azimuth.
    camera.azimuth = f.y > 0.0 ? std::atan2(-place.up.x, place.up.z) : std::atan2(place.up.x, -place.up.z);
  }
  const double sin_azimuth = std::sin(camera.azimuth);
  const double cos_azimuth = std::cos(camera.azimuth);
  const vec3 right{cos_azimuth, 0.0, sin_azimuth};
  const vec3 up{-sin_azimuth * std::sin(camera.pitch), std::cos(camera.pitch), cos_azimuth * std::sin(camera.pitch)};
  camera.roll = std::atan2(-physics::dot(place.right, up), physics::dot(place.right, right));
  return camera;
}

FileCamera from_world_to_camera(const std::string& file, const Matrix& matrix, UpAxis up, double unit_km) {
  const std::optional<SquareOfRows> back = inverse(matrix);
  if (!back) {
    throw InputError(file + ": its worldToCamera cannot be inverted; give the camera by the preset (--camera preset)");
  }
  const auto direction = [&](double x, double y, double z) {
    const Row d = Row(x, y, z, 0.0) * *back;
    return physics::normalize(in_preset({d[0], d[1], d[2]}, up));
  };
  Place place;
  const Row at = Row(0.0, 0.0, 0.0, 1.0) * *back;
  place.position = in_preset({at[0], at[1], at[2]}, up);
  place.right = direction(1.0, 0.0, 0.0);
  place.up = direction(0.0, 1.0, 0.0);
  const vec3 behind = direction(0.0, 0.0, 1.0);
  const vec3 across = physics::cross(place.right, place.up);
  place.forward = physics::dot(across, behind) > 0.0 ? behind * -1.0 : behind;
  return angles_of(place, unit_km);
}

FileCamera from_world_to_ndc(const std::string& file, const Matrix& matrix, UpAxis up, double unit_km) {
  const std::optional<SquareOfRows> back = inverse(matrix);
  if (!back) {
    throw InputError(file + ": its worldToNDC cannot be inverted; give the camera by the preset (--camera preset)");
  }
  // The camera's place is the point without an image: it is mapped to (0, 0, z, 0).
  const Row centre = Row(0.0, 0.0, 1.0, 0.0) * *back;
  if (!(std::abs(centre[3]) > 1e-12 * (std::abs(centre[0]) + std::abs(centre[1]) + std::abs(centre[2])))) {
    throw InputError(file + ": its worldToNDC is no perspective; give the camera by the preset (--camera preset)");
  }
  const vec3 position{centre[0] / centre[3], centre[1] / centre[3], centre[2] / centre[3]};
  const auto toward = [&](double x, double y) {
    const Row p = Row(x, y, 0.5, 1.0) * *back;
    vec3 d = physics::normalize(vec3{p[0] / p[3], p[1] / p[3], p[2] / p[3]} - position);
    // In front of the camera the image's last coordinate is positive.
    const double w = (Row(position.x + d.x, position.y + d.y, position.z + d.z, 1.0) * square(matrix))[3];
    return in_preset(w < 0.0 ? d * -1.0 : d, up);
  };
  Place place;
  place.position = in_preset(position, up);
  place.forward = toward(0.0, 0.0);
  const vec3 top = toward(0.0, 1.0);
  const vec3 bottom = toward(0.0, -1.0);
  const double above = std::acos(std::min(physics::dot(place.forward, top), 1.0));
  const double below = std::acos(std::min(physics::dot(place.forward, bottom), 1.0));
  const double left = physics::dot(place.forward, toward(-1.0, 0.0));
  const double right = physics::dot(place.forward, toward(1.0, 0.0));
  if (std::abs(above - below) > 1e-4 || std::abs(left - right) > 1e-4) {
    throw InputError(file + ": its camera's lens is shifted, which airlight has not; render without lens shift");
  }
  place.up = physics::normalize(top - bottom);
  place.right = physics::normalize(toward(1.0, 0.0) - toward(-1.0, 0.0));
  FileCamera camera = angles_of(place, unit_km);
  camera.vertical_fov = above + below;
  return camera;
}

}  // namespace

FileCamera camera_of(const std::string& file, const std::optional<Matrix>& world_to_camera,
                     const std::optional<Matrix>& world_to_ndc, UpAxis up, double unit_km) {
  if (world_to_ndc) {
    return from_world_to_ndc(file, *world_to_ndc, up, unit_km);
  }
  if (world_to_camera) {
    return from_world_to_camera(file, *world_to_camera, up, unit_km);
  }
  throw InputError(file + ": says nothing of its camera (neither worldToNDC nor worldToCamera); use --camera preset");
}

}  // namespace airlight::composite
