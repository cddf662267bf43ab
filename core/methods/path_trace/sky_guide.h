#pragma once
// A rough density over the directions that a point's light comes from: the horizon more than the zenith, the sun's side
// more than the other, the ground by its albedo. Like the guide it steers and enters no result.

#include <array>
#include <mutex>
#include <vector>

#include "core/methods/path_trace/flight.h"

namespace airlight {

// Directions at a place: its vertical and the sun's azimuth.
struct SkyFrame {
  SkyFrame(physics::Physics& physics, double h, physics::vec3 up, bool at_ground);

  double h;
  double horizon;  // zenith cosine of the horizon
  double mu_sun;
  bool at_ground;
  physics::vec3 up;
  physics::vec3 toward_sun;  // horizontal
};

class SkyGuide {
 public:
  SkyGuide(physics::Physics& physics, const Flight& flight);

  // u, turn in [0, 1); `weight`: the light that each channel of the path carries.
  physics::vec3 draw_direction(const SkyFrame& frame, const Channels& weight, double u, double turn) const;

  // The density of directions from draw_direction(), 1/sr.
  double density(const SkyFrame& frame, const Channels& weight, physics::vec3 direction) const;

 private:
  static constexpr std::size_t kAbove = 16;  // bins of zenith cosine above the horizon
  static constexpr std::size_t kBelow = 8;
  static constexpr std::size_t kAround = 6;  // bins of azimuth from the sun's, which serve both sides
  static constexpr std::size_t kSuns = 16;   // zenith angles of the sun

  // Shares of the directions for one altitude, one sun and one channel.
  struct Sky {
    std::array<double, kAbove + kBelow> rows;                         // of each zenith bin, sum 1
    std::array<std::array<double, kAround>, kAbove + kBelow> shares;  // of each azimuth bin within it, sum 1
  };

  static double edge(double horizon, std::size_t row);
  const std::array<Sky, 3>& skies(const SkyFrame& frame) const;
  void fill(std::size_t place, std::size_t sun) const;

  physics::Physics& physics_;
  const Flight& flight_;
  double first_sun_;  // zenith angle, rad
  double sun_step_;
  // One for each place (the shells, then the ground) and sun, three channels each. The thread that first needs an entry
  // fills it; every thread would fill it equally.
  mutable std::vector<std::array<Sky, 3>> skies_;
  mutable std::vector<std::once_flag> filled_;
};

}  // namespace airlight
