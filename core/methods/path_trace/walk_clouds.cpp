// Walks among clouds: flights end at drops by null collisions, and the sun is looked for through the forward peak.

#include <algorithm>

#include "core/methods/path_trace/walk_vertex.h"

namespace airlight {

using physics::uint;
using physics::vec3;

// Ends the ray where it meets a cloud's drop before the thing.
void Walk::meet_clouds(const BentWay& way, physics::Physics::Ray& ray, std::optional<TracedThings::Met>& met,
                       Random& random) const {
  if (clouds_ == nullptr || !(ray.length_ > 0.0)) {
    return;
  }
  way.chords(ray.length_, clouds_->highest(), [&](const BentWay::Chord& chord) {
    const auto drop = clouds_->collide(chord.from, chord.direction, chord.length, random);
    if (drop) {
      const double distance = way.on_ray(chord, drop->distance);
      met = TracedThings::Met{distance, thing_of_cloud(drop->cloud), chord.from + chord.direction * drop->distance};
      ray.length_ = distance;
      ray.at_ground = false;
    }
    return drop.has_value();
  });
}

// An estimate of the sunlight's share that passes the clouds on its way to the vertex, times `sun_share`.
double Walk::through_clouds(const State& state, const Sunbeam& sun, Random& random) const {
  constexpr double kFar = 1e5;  // km
  const vec3 to_sun = seen_from(state, sun);
  const double mu = dot(state.up, to_sun);
  const physics::Physics::Ray ray = physics_.ray_in_atmosphere(physics_.scene.planet, state.h, mu, mu, 1.0);
  const BentWay way(physics_, state.place(physics_), state.up, to_sun, ray);
  double share = state.sun_share;
  way.chords(physics_.refraction ? ray.length_ : kFar, clouds_->highest(), [&](const BentWay::Chord& chord) {
    share *= clouds_->transmittance(chord.from, chord.direction, chord.length, random);
    return share <= 0.0;
  });
  return share;
}

uint Walk::first_cloud() const {
  return physics_.medium_count() - static_cast<uint>(clouds_ == nullptr ? 0 : clouds_->count());
}

// Density of directions by the clouds' phase functions around the sun, 1/sr.
double Walk::toward_sun(const vec3& direction) const {
  const double nu = std::clamp(dot(direction, physics_.scene.sun.direction), -1.0, 1.0);
  double sum = 0.0;
  for (uint i = first_cloud(); i < physics_.medium_count(); ++i) {
    sum += phases_.density(i, nu, physics_.medium_phase(i, nu));
  }
  return sum / clouds_->count();
}

// The sun's light that the next vertex scatters straight on: directions around the sun find it, those of the path
// hardly ever. Both share it by the balance heuristic (Veach and Guibas 1995).
void Walk::look_toward_sun(State& state, const Lobes& lobes, Random& random) const {
  const uint cloud = first_cloud() + static_cast<uint>(random.uniform() * clouds_->count());
  const double nu = phases_.sample(cloud, random.uniform(), random);
  const Choice choice = lobes.judge(around(physics_.scene.sun.direction, nu, random.uniform()));
  const double density = choice.density + toward_sun(choice.direction);
  if (!(density > 0.0) || !(std::max({choice.scattered.x, choice.scattered.y, choice.scattered.z}) > 0.0)) {
    return;
  }
  State probe = state;
  std::optional<WidePath> wide;
  if (state.wide != nullptr) {
    probe.wide = &wide.emplace(*state.wide);
  }
  probe.sun_share = 1.0;
  set_out(probe, choice, density);
  take_off(probe, std::nullopt, random, *state.aside);
  if (fly(probe, *state.aside, random.uniform())) {
    add_sunlight(probe, random);
  }
  state.sum = probe.sum;
  if (wide) {
    state.wide->take_sum(*wide);
  }
}

// Along the first ray, which ends at another drop each time. False where there is no vertex.
bool Walk::fly_among_clouds(State& state, const WalkStart& start, WalkNumbers& numbers, FlightPlan& plan) const {
  physics::Physics::Ray ray = start.ray;
  const BentWay way(physics_, true_place(physics_, start.up, ray.h), start.up, start.direction, ray);
  std::optional<TracedThings::Met> met;
  if (start.plan.thing != kNoThing) {
    met = TracedThings::Met{ray.length_, start.plan.thing, way.at(ray.length_).place};
  }
  meet_clouds(way, ray, met, numbers.random());
  plan_flight(ray, met, std::nullopt, plan);
  return fly(state, plan, numbers.next());
}

Walk::Left Walk::follow(const WalkStart& start, WalkNumbers& numbers, FlightPlan& plan,
                        const std::function<void(vec3 place, double share)>& lost) const {
  constexpr double kFaint = 0.01;  // less is dropped or raised to this, by chance
  State state;
  state.h = start.ray.h;
  state.up = start.up;
  state.direction = start.direction;
  state.axis = start.axis;
  const auto left = [&] { return Left{state.place(physics_), state.direction, state.carry.x}; };
  bool met = fly_among_clouds(state, start, numbers, plan);
  for (int order = 1; met && order < kMostScatterings; ++order) {
    const double before = state.carry.x;
    double scattered = 0.0;
    for (uint i = 0; i < physics_.medium_count(); ++i) {
      scattered += state.scattering[i].x;
    }
    lost(state.place(physics_), before * (1.0 - scattered));
    if (state.carry.x < kFaint) {
      if (!(numbers.random().uniform() * kFaint < state.carry.x)) {
        return {left().place, state.direction, 0.0};
      }
      state.carry = vec3(kFaint);
    }
    if (!turn(state, false, numbers, plan)) {
      return {left().place, state.direction, 0.0};
    }
    met = fly(state, plan, numbers.next());
  }
  return left();
}

}  // namespace airlight
