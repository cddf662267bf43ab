// Sunlight that mirrors throw on surfaces along a walk.

#include "core/methods/path_trace/walk_vertex.h"

namespace airlight {

using physics::vec3;

// An estimate of the share that clouds leave of sunlight on its way to the mirror and from there to the vertex.
double Walk::thrown_through_clouds(const TracedThings::Thrown& thrown, const Sunbeam& sun, Random& random) const {
  if (clouds_ == nullptr) {
    return 1.0;
  }
  State mirror;
  mirror.up = normalize(thrown.from);
  mirror.h = altitude_of_place(physics_, thrown.from);
  return through_clouds(mirror, sun, random) *
         clouds_->transmittance(thrown.from, thrown.direction * -1.0, thrown.distance, random);
}

// Adds the sunlight that mirrors throw on the surface at the vertex. What they throw into the air or by way of one
// another is left out.
void Walk::add_thrown(State& state, Random& random) const {
  if (things_ == nullptr || !state.at_ground || state.mirrors) {
    return;
  }
  const Sunbeam here = sunbeam(physics_, state.h, state.mu_sun);
  for (const TracedThings::Thrown& thrown :
       things_->thrown_on(state.place(physics_), seen_from(state, here), state.thing)) {
    const double h = altitude_of_place(physics_, thrown.from);
    const Sunbeam sun = sunbeam(physics_, h, dot(normalize(thrown.from), physics_.scene.sun.direction));
    const double mu = dot(state.up, thrown.direction);
    const vec3 beam = single_.sunlight_at(thrown.from, h, sun, thrown.mirror);
    const double facing = state.shares.cosine(dot(state.normal, thrown.direction)) * thrown.spread / std::numbers::pi;
    if (!(beam.x + beam.y + beam.z > 0.0) || !(facing > 0.0)) {
      continue;
    }
    const double share = thrown_through_clouds(thrown, sun, random);
    if (state.wide != nullptr) {
      const Columns columns = depth_.columns_along(state.h, mu, thrown.distance) + depth_.columns_to_top(h, sun.mu);
      const Wide mirror = state.wide->wavelengths().thing_albedo(*things_, thrown.from, thrown.mirror);
      state.wide->add_reflected(columns, mirror * state.wide_albedo, facing * sun.spread * share);
    } else {
      const vec3 arrives =
          beam * things_->albedo(thrown.from, thrown.mirror) * exp(-1.0 * depth_.along(state.h, mu, thrown.distance));
      state.sum = state.sum + state.carry * arrives * state.albedo * (facing * share);
    }
  }
}

}  // namespace airlight
