#pragma once
// Light of all higher orders, by random walks from the camera in which the sun lights each vertex.

#include <atomic>
#include <cstdint>
#include <optional>

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
  double pixel = 0.0;  // angle that the ray represents
};

class Walk {
 public:
  // `max_orders`: most scatterings and reflections of a path; 0: kMostScatterings.
  Walk(physics::Physics& physics, const OpticalDepth& depth, const SingleScattering& single, const Flight& flight,
       const SkyGuide& guide, int max_orders, const TracedTerrain* terrain = nullptr);

  // `wall`: distance at which a black wall ends the ray, km.
  WalkStart start(physics::vec3 direction, double wall) const;

  // One estimate of the radiance after two or more scatterings or reflections, for a sun of irradiance 1. `plan` is
  // scratch memory.
  physics::vec3 sample(const WalkStart& start, WalkNumbers& numbers, FlightPlan& plan) const;
  // One estimate at all wavelengths, added to the path's sum.
  void sample(const WalkStart& start, WalkNumbers& numbers, FlightPlan& plan, WidePath& wide) const;

  // Number of paths that ended after kMostScatterings without a limit from the user.
  std::uint64_t cut_paths() const { return cut_paths_; }
  static constexpr int kMostScatterings = 10000;

 private:
  struct State;
  class Lobes;
  void walk(State& state, const WalkStart& start, WalkNumbers& numbers, FlightPlan& plan) const;
  bool fly(State& state, const FlightPlan& plan, double u) const;
  physics::vec3 from_sun(const State& state) const;
  void add_from_sun(const State& state) const;
  double seen_length(const physics::Physics::Ray& ray) const;
  std::optional<Channels> cut_at_terrain(physics::vec3 place, physics::vec3 direction,
                                         physics::Physics::Ray& ray) const;
  bool turn(State& state, bool guided, WalkNumbers& numbers, FlightPlan& plan) const;

  physics::Physics& physics_;
  const OpticalDepth& depth_;
  const SingleScattering& single_;
  const Flight& flight_;
  const SkyGuide& guide_;
  PhaseSampler phases_;
  const TracedTerrain* terrain_;
  int max_orders_;
  int guided_orders_;
  mutable std::atomic<std::uint64_t> cut_paths_ = 0;
};

}  // namespace airlight
