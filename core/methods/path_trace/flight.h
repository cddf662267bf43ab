#pragma once
// The place where a ray next meets the air or the ground, at random. The choice follows a coarse model of the air (a
// few dozen shells, linear between their edges), so that every ray collides. The caller divides by the exact density of
// the choice, which corrects the model's errors. The model steers samples and enters no result.

#include <optional>
#include <vector>

#include "core/methods/path_trace/guide.h"
#include "core/methods/path_trace/things_trace.h"
#include "core/physics/physics.h"

namespace airlight {

// A ray's way through the shells.
struct FlightPlan {
  struct Panel {
    double start;    // km
    double width;    // km
    Channels enter;  // extinction at its start, 1/km
    Channels leave;  // extinction at its end, 1/km
    Channels plain;  // share of the light that is scattered in it
    Channels share;  // expected contribution, by which the choice is made
  };
  std::vector<Panel> panels;
  Channels ground{};             // `share` of the ground
  Channels total{};              // over all panels and the ground
  double length = 0.0;           // km
  ThingNumber thing = kNoThing;  // to which the ground's share belongs, above the ground
  physics::vec3 place{};         // where the ray meets it
};

struct Collision {
  bool happens = false;  // false: nothing scatters and nothing reflects along the whole ray
  bool at_ground = false;
  double distance = 0.0;
  double density = 0.0;  // of the choice: 1/km in the air, a probability on the ground
};

class Flight {
 public:
  Flight(physics::Physics& physics, const OpticalDepth& depth);

  // Shares by the light that the guide expects at each place. `sun_weight`: weight of direct sunlight there, 1 for
  // isotropic air; 0 where sunlight is known without samples. `thing`: albedo of the thing at the ray's end above the
  // ground; null: none.
  void plan_guided(const physics::Physics::Ray& ray, double sun_weight, FlightPlan& plan,
                   const Channels* thing = nullptr) const;

  // Shares by extinction and scattering alone.
  void plan_plain(const physics::Physics::Ray& ray, FlightPlan& plan, const Channels* thing = nullptr) const;

  // `weight`: the light that each channel of the path carries. u in [0, 1).
  static Collision choose(const FlightPlan& plan, const Channels& weight, double u);

  // Altitudes at which some density is not smooth, with the ground and the top, ascending.
  std::vector<double> corners() const;

  // The shells, from the ground up.
  std::size_t shell_count() const { return shells_.size(); }
  std::size_t shell_of(double h) const;
  double shell_middle(std::size_t shell) const { return 0.5 * (edges_[shell] + edges_[shell + 1]); }

  // Vertical depth of scattering times its mean cosine, in the channel with the most: the thickness of peaked media.
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
  // Limits for a shell: its vertical optical depth, and the bend of its density, as a share of it.
  struct Thinness {
    double depth;
    double bend;
  };
  void divide(double low, double high, const Thinness& thin);
  class Planner;
  void follow(const physics::Physics::Ray& ray, Planner& planner, const Channels* thing) const;

  physics::Physics& physics_;
  std::vector<double> edges_;
  std::vector<Shell> shells_;
  std::optional<Guide> guide_;
  double forward_depth_ = 0.0;
};

}  // namespace airlight
