#pragma once
// Optical depth along any ray of the air by Gauss quadrature of each medium's density, in double. The error is at most
// 1e-7 of the medium's depth, far below the noise of any number of samples.

#include <array>
#include <vector>

#include "core/physics/gauss.h"
#include "core/physics/physics.h"
#include "core/scene/density_profiles.h"

namespace airlight {

// A number for each medium: its density times length, km at density 1; or its density at a place.
using Columns = std::array<double, physics::kMaxMedia>;

inline Columns operator+(Columns a, const Columns& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    a[i] += b[i];
  }
  return a;
}

class OpticalDepth {
 public:
  // `physics` is only read (its functions are GLSL's, which have no const) and must outlive this.
  explicit OpticalDepth(physics::Physics& physics);

  // Optical depth from altitude h along zenith cosine mu over a distance that stays inside the atmosphere and above the
  // ground.
  physics::vec3 along(double h, double mu, double distance) const;

  // Optical depth to the top of the atmosphere; the ground must not be in the way.
  physics::vec3 to_top(double h, double mu) const;

  // Optical depth of such columns.
  physics::vec3 through(const Columns& columns) const;

  // Columns of the media that extinguish, along the same ways.
  Columns columns_along(double h, double mu, double distance) const;
  Columns columns_to_top(double h, double mu) const;

 private:
  using Shape = DensityShape;

  // An altitude range in which one medium's density is analytic.
  struct Piece {
    Shape shape;
    physics::uint index;  // of the medium
    physics::uint profile;
    physics::MediumData medium;
    physics::vec3 extinction;  // at density 1
    double low;                // km
    double high;               // km
  };

  // A ray that climbs from its start to its end.
  struct Climb {
    double h;
    double r;
    double r_mu;  // r times the zenith cosine at the start, >= 0
    double length;
    double h_end;
  };

  void add_pieces(physics::uint i);
  void add_piece(Shape shape, physics::uint i, physics::MediumData medium, double low, double high);
  template <class Visit>
  void for_each_climb(double h, double mu, double distance, const Visit& visit) const;
  template <class Visit>
  void for_each_climb_to_top(double h, double mu, const Visit& visit) const;
  Climb climb(double h, double mu, double length, double h_end) const;
  physics::vec3 depth_of(const Climb& path) const;
  Columns columns_of(const Climb& path) const;
  double column(const Piece& piece, const Climb& climb) const;
  double panel(const Piece& piece, const Climb& climb, double from, double to) const;
  const GaussRule& rule_for(const Piece& piece, double r, double length, double fall) const;

  physics::Physics& physics_;
  std::vector<Piece> pieces_;
  std::vector<GaussRule> plain_;    // by number of nodes
  std::vector<GaussRule> falling_;  // by number of nodes
};

}  // namespace airlight
