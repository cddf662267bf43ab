#pragma once
// Directions by the media's phase functions.

#include <array>
#include <vector>

#include "core/methods/path_trace/random.h"
#include "core/physics/physics.h"

namespace airlight {

// Draws scattering angles of each medium and tells the density of its draws.
class PhaseSampler {
 public:
  explicit PhaseSampler(physics::Physics& physics);

  // Cosine of the scattering angle, distributed as 2 pi density(medium, nu). u in [0, 1); `random` gives further
  // numbers where a function has no closed inverse.
  double sample(physics::uint medium, double u, Random& random) const;

  // 1/sr: `phase`, the medium's at nu, where it is a formula that all channels share; else close to the channels' mean.
  double density(physics::uint medium, double nu, physics::vec3 phase) const;

  // The same by the mean of the channels' own functions with these weights, of which some is above 0: a path whose
  // weights are these keeps their sum.
  double sample_by(const std::array<double, 3>& weights, physics::uint medium, double u, Random& random) const;
  double density_by(const std::array<double, 3>& weights, physics::uint medium, double nu, physics::vec3 phase) const;

  // Of molecules, the mean over the channels of Physics::dipole_share().
  double dipole_share(physics::uint medium) const;

  // Whether the medium scatters mostly forward, or mostly back.
  bool is_peaked(physics::uint medium) const;

 private:
  // The way to draw from a phase function by table: first an interval, then a cosine evenly within it.
  struct Table {
    std::vector<double> ends;  // of the intervals' shares, summed
    std::vector<double> shares;
    double draw_cosine(double u) const;
  };
  // The interval at a cosine, and the integral of 2 pi over its cosines.
  struct Interval {
    std::size_t index;
    double width;
  };
  Interval interval_at(double nu) const;

  physics::Physics& physics_;
  std::vector<std::array<Table, 4>> tables_;  // by medium: of the channels, of their mean; empty without a table
};

// The unit vector at cosine nu from `axis`, `turn` in [0, 1) of a full turn around it.
physics::vec3 around(physics::vec3 axis, double nu, double turn);

}  // namespace airlight
