#pragma once
// What the eye at a path's start makes of polarised light at its end. Light of Stokes parameters (I, Q, U) that enters
// a path is seen as the path's weight times I + q Q + u U: q and u depend on the path's vertices, and each molecule
// changes them. Q and U refer to the axis, across the path.

#include <algorithm>
#include <cmath>

#include "core/physics/physics.h"

namespace airlight {

// A turn of the path from one direction into another.
struct Bend {
  double nu;      // cosine of the scattering angle
  double cosine;  // of twice the angle from the axis to the plane of scattering
  double sine;
  physics::vec3 axis;  // behind the turn, in the plane of scattering
};

// Any unit vector across a unit vector.
inline physics::vec3 some_axis(const physics::vec3& direction) {
  const bool steep = std::abs(direction.y) > 0.9;
  return normalize(cross(direction, steep ? physics::vec3(1.0, 0.0, 0.0) : physics::vec3(0.0, 1.0, 0.0)));
}

// `axis`: across `from`. Unit vectors.
inline Bend bend_of(const physics::vec3& from, const physics::vec3& to, const physics::vec3& axis) {
  Bend bend;
  bend.nu = std::clamp(dot(from, to), -1.0, 1.0);
  physics::vec3 normal = cross(from, to);
  const double size = length(normal);
  normal = size > 1e-9 ? normal / size : cross(from, axis);
  const physics::vec3 before = cross(normal, from);
  const double c = dot(axis, before);
  const double s = dot(cross(from, axis), before);
  bend.cosine = c * c - s * s;
  bend.sine = 2.0 * c * s;
  bend.axis = cross(normal, to);
  return bend;
}

// 0 where there is nothing to be shared.
inline double share_of(double part, double whole) {
  return whole > 0.0 ? part / whole : 0.0;
}
inline physics::vec3 share_of(const physics::vec3& part, const physics::vec3& whole) {
  return {share_of(part.x, whole.x), share_of(part.y, whole.y), share_of(part.z, whole.z)};
}

// Value: one number for each channel or wavelength; share_of() must know it.
template <class Value>
struct Analyser {
  Value q{};
  Value u{};

  // Q in the plane of the turn.
  Value in_plane(const Bend& bend) const { return q * bend.cosine + u * bend.sine; }

  // What unpolarised light that comes out of the turn counts, beyond the phase functions: negative in the plane.
  // `dipoles`: their coefficient here, as of Physics::dipole_scattering().
  Value correction(const Bend& bend, const Value& dipoles) const {
    return dipoles * in_plane(bend) * (bend.nu * bend.nu - 1.0);
  }

  // Takes the turn; `scattered`: all that the media scatter into it, the correction included; not 0 where dipoles are.
  void turn(const Bend& bend, const Value& dipoles, const Value& scattered) {
    const Value plane = in_plane(bend);
    const Value across = u * bend.cosine - q * bend.sine;
    const double nu = bend.nu;
    const Value share = share_of(dipoles, scattered);
    q = share * (plane * (1.0 + nu * nu) + Value(nu * nu - 1.0));
    u = share * across * (2.0 * nu);
  }

  // Matt surfaces take in all light alike.
  void forget() {
    q = Value(0.0);
    u = Value(0.0);
  }
};

}  // namespace airlight
