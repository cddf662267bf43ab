#include "core/composite/camera.h"

#include <cmath>
#include <utility>

#include "core/error.h"
#include "core/physics/vector.h"

namespace airlight::composite {
namespace {

using physics::vec3;
using Row = std::array<double, 4>;

Row times(const Row& v, const Matrix& m) {
  Row out{};
  for (std::size_t j = 0; j < 4; ++j) {
    for (std::size_t i = 0; i < 4; ++i) {
      out[j] += v[i] * m[4 * i + j];
    }
  }
  return out;
}

// The inverse by Gauss and Jordan, with the greatest pivot of each column.
std::optional<Matrix> inverse(Matrix m) {
  Matrix out{};
  for (std::size_t i = 0; i < 4; ++i) {
    out[5 * i] = 1.0;
  }
  for (std::size_t k = 0; k < 4; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k + 1; i < 4; ++i) {
      pivot = std::abs(m[4 * i + k]) > std::abs(m[4 * pivot + k]) ? i : pivot;
    }
    const double value = m[4 * pivot + k];
    if (!(std::abs(value) > 1e-300) || !std::isfinite(value)) {
      return std::nullopt;
    }
    for (std::size_t j = 0; j < 4; ++j) {
      std::swap(m[4 * k + j], m[4 * pivot + j]);
      std::swap(out[4 * k + j], out[4 * pivot + j]);
    }
    for (std::size_t j = 0; j < 4; ++j) {
      m[4 * k + j] /= value;
      out[4 * k + j] /= value;
    }
    for (std::size_t i = 0; i < 4; ++i) {
      const double factor = i == k ? 0.0 : m[4 * i + k];
      for (std::size_t j = 0; j < 4; ++j) {
        m[4 * i + j] -= factor * m[4 * k + j];
        out[4 * i + j] -= factor * out[4 * k + j];
      }
    }
  }
  return out;
}

// Into the preset's frame: x east, y up, -z north.
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
    // Straight up or down, where the picture's upper edge looks tells the azimuth.
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
  const std::optional<Matrix> back = inverse(matrix);
  if (!back) {
    throw InputError(file + ": its worldToCamera cannot be inverted; give the camera by the preset (--camera preset)");
  }
  const auto direction = [&](double x, double y, double z) {
    const Row d = times({x, y, z, 0.0}, *back);
    return physics::normalize(in_preset({d[0], d[1], d[2]}, up));
  };
  Place place;
  const Row at = times({0.0, 0.0, 0.0, 1.0}, *back);
  place.position = in_preset({at[0], at[1], at[2]}, up);
  place.right = direction(1.0, 0.0, 0.0);
  place.up = direction(0.0, 1.0, 0.0);
  const vec3 behind = direction(0.0, 0.0, 1.0);
  const vec3 across{place.right.y * place.up.z - place.right.z * place.up.y,
                    place.right.z * place.up.x - place.right.x * place.up.z,
                    place.right.x * place.up.y - place.right.y * place.up.x};
  place.forward = physics::dot(across, behind) > 0.0 ? behind * -1.0 : behind;
  return angles_of(place, unit_km);
}

FileCamera from_world_to_ndc(const std::string& file, const Matrix& matrix, UpAxis up, double unit_km) {
  const std::optional<Matrix> back = inverse(matrix);
  if (!back) {
    throw InputError(file + ": its worldToNDC cannot be inverted; give the camera by the preset (--camera preset)");
  }
  // The camera's place is what has no image: it goes to (0, 0, z, 0).
  const Row centre = times({0.0, 0.0, 1.0, 0.0}, *back);
  if (!(std::abs(centre[3]) > 1e-12 * (std::abs(centre[0]) + std::abs(centre[1]) + std::abs(centre[2])))) {
    throw InputError(file + ": its worldToNDC is no perspective; give the camera by the preset (--camera preset)");
  }
  const vec3 position{centre[0] / centre[3], centre[1] / centre[3], centre[2] / centre[3]};
  const auto toward = [&](double x, double y) {
    const Row p = times({x, y, 0.5, 1.0}, *back);
    vec3 d = physics::normalize(vec3{p[0] / p[3], p[1] / p[3], p[2] / p[3]} - position);
    // In front of the camera the image's last coordinate is positive.
    const double w = times({position.x + d.x, position.y + d.y, position.z + d.z, 1.0}, matrix)[3];
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
