#pragma once
// The part of GLSL's vectors and built-ins that shaders/physics may use, on double.

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace airlight::physics {

using real = double;
using uint = unsigned int;

struct vec2 {
  real x = 0.0, y = 0.0;
};

struct vec3 {
  real x = 0.0, y = 0.0, z = 0.0;
  vec3() = default;
  explicit vec3(real a) : x(a), y(a), z(a) {}
  vec3(real a, real b, real c) : x(a), y(b), z(c) {}
};

// GLSL's v[c].
inline real channel(const vec3& v, std::size_t c) {
  return c == 0 ? v.x : c == 1 ? v.y : v.z;
}

inline real channel_mean(const vec3& v) {
  return (v.x + v.y + v.z) / 3.0;
}

inline vec3 operator+(vec3 a, vec3 b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline vec3 operator-(vec3 a, vec3 b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline vec3 operator-(vec3 a) {
  return {-a.x, -a.y, -a.z};
}
inline vec3 operator*(vec3 a, vec3 b) {
  return {a.x * b.x, a.y * b.y, a.z * b.z};
}
inline vec3 operator*(vec3 a, real b) {
  return {a.x * b, a.y * b, a.z * b};
}
inline vec3 operator*(real a, vec3 b) {
  return b * a;
}
inline vec3 operator/(vec3 a, vec3 b) {
  return {a.x / b.x, a.y / b.y, a.z / b.z};
}
inline vec3 operator/(vec3 a, real b) {
  return {a.x / b, a.y / b, a.z / b};
}

using std::cos, std::exp, std::floor, std::log, std::pow, std::sin, std::sqrt, std::tan;

inline real inversesqrt(real x) {
  return 1.0 / std::sqrt(x);
}
inline real atan(real y, real x) {
  return std::atan2(y, x);
}
inline real abs(real x) {
  return std::fabs(x);
}
inline real min(real a, real b) {
  return std::min(a, b);
}
inline uint min(uint a, uint b) {
  return std::min(a, b);
}
inline real max(real a, real b) {
  return std::max(a, b);
}
inline real clamp(real x, real a, real b) {
  return std::min(std::max(x, a), b);
}
inline vec3 exp(vec3 a) {
  return {std::exp(a.x), std::exp(a.y), std::exp(a.z)};
}
inline vec3 log(vec3 a) {
  return {std::log(a.x), std::log(a.y), std::log(a.z)};
}
inline vec3 max(vec3 a, vec3 b) {
  return {max(a.x, b.x), max(a.y, b.y), max(a.z, b.z)};
}
inline vec3 min(vec3 a, vec3 b) {
  return {min(a.x, b.x), min(a.y, b.y), min(a.z, b.z)};
}
inline real dot(vec3 a, vec3 b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline vec3 cross(vec3 a, vec3 b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline real length(vec3 a) {
  return std::sqrt(dot(a, a));
}
inline vec3 normalize(vec3 a) {
  return a / length(a);
}

}  // namespace airlight::physics
