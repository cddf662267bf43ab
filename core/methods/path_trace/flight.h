#pragma once
// Where a ray meets the air or the ground next, at random. The choice follows a coarse picture of the air (a few dozen
// shells, linear between their edges), so that every ray collides; what the picture gets wrong is made good by the
// exact density of the choice, which the caller divides by. It steers samples and enters no result.

#include <optional>
#include <vector>

#include "core/methods/path_trace/guide.h"
#include "core/physics/physics.h"

namespace airlight {

// A ray's way through the shells.
struct FlightPlan {
  struct Panel {
    double start;    // km
    double width;    // km
    Channels enter;  // extinction at its start, 1/km
    Channels leave;  // extinction at its end, 1/km
    Channels plain;  // share of the light, scattered in it
    Channels share;  // what it is guessed to bring, on which the choice goes
  };
  std::vector<Panel> panels;
  Channels ground{};        // the same of the ground
  Channels total{};         // of all of them
  double length = 0.0;      // km
  bool on_terrain = false;  // what the ground's share stands for is terrain, above the ground
};

struct Collision {
  bool happens = false;  // false: nothing scatters and nothing reflects along the whole ray
  bool at_ground = false;
  double distance = 0.0;
  double density = 0.0;  // of choosing it: 1/km in the air, a probability on the ground
};

class Flight {
 public:
  Flight(physics::Physics& physics, const OpticalDepth& depth);

  // Shares by the light that the guide expects at each place. `sun_weight`: what direct sunlight counts there, 1 for
  // isotropic air; 0 where it is known without samples.
  // `terrain`: the albedo of what the ray ends on above the ground; null: nothing.
  void plan_guided(const physics::Physics::Ray& ray, double sun_weight, FlightPlan& plan,
                   const Channels* terrain = nullptr) const;

  // Shares by what collides and scatters alone.
  void plan_plain(const physics::Physics::Ray& ray, FlightPlan& plan, const Channels* terrain = nullptr) const;

  // `weight`: what each channel of the path carries. u in [0, 1).
  static Collision choose(const FlightPlan& plan, const Channels& weight, double u);

  // Altitudes at which some density is not smooth, with the ground and the top, ascending.
  std::vector<double> corners() const;

  // The shells, from the ground up.
  std::size_t shell_count() const { return shells_.size(); }
  std::size_t shell_of(double h) const;
  double shell_middle(std::size_t shell) const { return 0.5 * (edges_[shell] + edges_[shell + 1]); }

  // Vertical depth of scattering times its mean cosine, the largest of the channels: how thick peaked media are.
  double forward_depth() const { return forward_depth_; }

 private:
  struct Coefficients {
    Channels extinction;
    Channels scattering;
  };
  // Linear from low to high.
  struct Shell {
    Coefficients low;
    Coefficients high;
  };

  Coefficients at(double h) const;
  Channels asymmetry_at(double h) const;
  Coefficients between(std::size_t shell, double h) const;
  // What a shell may be: its vertical optical depth, and how far its density may bend, as a share of it.
  struct Thinness {
    double depth;
    double bend;
  };
  void divide(double low, double high, const Thinness& thin);
  class Planner;
  void follow(const physics::Physics::Ray& ray, Planner& planner, const Channels* terrain) const;

  physics::Physics& physics_;
  std::vector<double> edges_;
  std::vector<Shell> shells_;
  std::optional<Guide> guide_;
  double forward_depth_ = 0.0;
};

}  // namespace airlight
