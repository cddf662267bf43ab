#pragma once
// Light of all higher orders, by random walks from the camera in which the sun lights each vertex.

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>

#include "core/methods/path_trace/cloud_trace.h"
#include "core/methods/path_trace/flight.h"
#include "core/methods/path_trace/phase_sampling.h"
#include "core/methods/path_trace/random.h"
#include "core/methods/path_trace/single_scattering.h"
#include "core/methods/path_trace/sky_guide.h"
#include "core/methods/path_trace/wavelengths.h"

namespace airlight {

// A camera ray, prepared for many walks.
struct WalkStart {
  physics::vec3 up;         // unit, away from the planet's centre, where the ray enters the air
  physics::vec3 direction;  // unit
  physics::Physics::Ray ray;
  FlightPlan plan;
  double pixel = 0.0;                   // angle that the ray represents
  physics::vec3 weight{1.0, 1.0, 1.0};  // of its light: of mirrors and the air before them
  Wide wide_weight = Wide(1.0);
  physics::vec3 axis{};  // across the ray
  double q = 0.0;        // how much Q by this axis counts: 1 behind a filter
};

class Walk {
 public:
  // `max_orders`: most scatterings and reflections of a path; 0: kMostScatterings. With `clouds` the formulas' last
  // media are theirs.
  Walk(physics::Physics& physics, const OpticalDepth& depth, const SingleScattering& single, const Flight& flight,
       const SkyGuide& guide, int max_orders, const TracedThings* things = nullptr,
       const TracedClouds* clouds = nullptr);

  // A ray from the camera; `wall`: distance at which a black wall ends it, km.
  WalkStart start(physics::vec3 direction, double wall) const;
  // A ray from any place in the air, a vector from the planet's centre in the camera's frame, km.
  WalkStart start_at(physics::vec3 place, physics::vec3 direction) const;
  // The ray that a mirror makes of one that ends on it; nothing where the ray does not. `all`: null for three channels.
  std::optional<WalkStart> mirrored(const WalkStart& from, const Wavelengths* all) const;

  // One estimate of the radiance after two or more scatterings or reflections, for a sun of irradiance 1; with clouds,
  // after one or more. `plan` is scratch memory.
  physics::vec3 sample(const WalkStart& start, WalkNumbers& numbers, FlightPlan& plan) const;
  // One estimate at all wavelengths, added to the path's sum.
  void sample(const WalkStart& start, WalkNumbers& numbers, FlightPlan& plan, WidePath& wide) const;

  // Light itself, followed from where it starts until nothing is in its way: the last place and direction, and the
  // share that is left. `lost`: is told what each place absorbs. Only among clouds, and in three channels.
  struct Left {
    physics::vec3 place;
    physics::vec3 direction;
    double share = 0.0;
  };
  Left follow(const WalkStart& start, WalkNumbers& numbers, FlightPlan& plan,
              const std::function<void(physics::vec3 place, double share)>& lost) const;

  // Number of paths that ended after kMostScatterings without a limit from the user.
  std::uint64_t cut_paths() const { return cut_paths_; }
  static constexpr int kMostScatterings = 5000;

 private:
  struct State;
  struct Choice;
  class Lobes;
  void walk(State& state, const WalkStart& start, WalkNumbers& numbers, FlightPlan& plan) const;
  bool fly(State& state, const FlightPlan& plan, double u) const;
  void turn_by(State& state, double bent) const;
  physics::vec3 seen_from(const State& state, const Sunbeam& beam) const;
  physics::vec3 from_sun(const State& state, Random& random) const;
  void add_from_sun(const State& state, Random& random) const;
  bool far_from_sunlight(const State& state) const;
  void add_sunlight(State& state, Random& random) const;
  double thrown_through_clouds(const TracedThings::Thrown& thrown, const Sunbeam& sun, Random& random) const;
  void add_thrown(State& state, Random& random) const;
  double through_clouds(const State& state, const Sunbeam& sun, Random& random) const;
  void meet_clouds(const BentWay& way, physics::Physics::Ray& ray, std::optional<TracedThings::Met>& met,
                   Random& random) const;
  physics::uint first_cloud() const;
  double toward_sun(const physics::vec3& direction) const;
  void set_out(State& state, const Choice& choice, double density) const;
  void look_toward_sun(State& state, const Lobes& lobes, Random& random) const;
  bool fly_among_clouds(State& state, const WalkStart& start, WalkNumbers& numbers, FlightPlan& plan) const;
  double seen_length(const physics::Physics::Ray& ray) const;
  std::optional<TracedThings::Met> cut_at_things(const BentWay& way, ThingNumber left,
                                                 physics::Physics::Ray& ray) const;
  void plan_flight(const physics::Physics::Ray& ray, const std::optional<TracedThings::Met>& met,
                   std::optional<double> sun_weight, FlightPlan& plan) const;
  void stand_on_surface(State& state) const;
  bool turn(State& state, bool guided, WalkNumbers& numbers, FlightPlan& plan) const;
  void reflect(State& state, bool guided, Random& random, FlightPlan& plan) const;
  void take_off(const State& state, std::optional<double> sun_weight, Random& random, FlightPlan& plan) const;

  physics::Physics& physics_;
  const OpticalDepth& depth_;
  const SingleScattering& single_;
  const Flight& flight_;
  const SkyGuide& guide_;
  PhaseSampler phases_;
  const TracedThings* things_;
  const TracedClouds* clouds_;
  int max_orders_;
  int guided_orders_;
  mutable std::atomic<std::uint64_t> cut_paths_ = 0;
};

}  // namespace airlight
