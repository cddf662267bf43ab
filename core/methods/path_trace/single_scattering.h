#pragma once
// Sunlight that meets the air or the ground once, by adaptive quadrature along the ray: no noise, error 1e-6.

#include <atomic>
#include <cstdint>
#include <vector>

#include "core/methods/path_trace/adaptive_sum.h"
#include "core/methods/path_trace/optical_depth.h"
#include "core/methods/path_trace/sunbeam.h"
#include "core/methods/path_trace/things_trace.h"
#include "core/methods/path_trace/wavelengths.h"

namespace airlight {

// Each medium's density at altitude h.
Columns densities_at(physics::Physics& physics, double h);

// A ray in space, needed where the ground has maps or things stand.
struct Footing {
  physics::vec3 up;              // unit, where the ray begins, in the camera's frame
  physics::vec3 direction;       // unit
  double pixel = 0.0;            // angle that the ray represents
  ThingNumber thing = kNoThing;  // on which the ray ends
  double uneven = 0.0;           // what a filter adds to the phase function of dipoles, over kDipole
  physics::vec3 place{};         // where it meets the thing
};

// Radiance of the ground at `up`, sent back along `direction`, for a sun beam of this irradiance on a plane that faces
// it; by the ground's maps, else by the planet's albedo. Sunlight of irradiance 1 gives level ground `mu_sun`.
physics::vec3 ground_reflects(physics::Physics& physics, physics::vec3 up, physics::vec3 direction, double mu_sun,
                              physics::vec3 beam);
// The place itself, on terrain so far above it that the terrain's own slope does not hide the sun from it.
physics::vec3 off_thing(physics::vec3 place, ThingNumber thing);

// The ground's albedo at `up` for light from all directions.
physics::vec3 ground_albedo_at(physics::Physics& physics, physics::vec3 up);

class SingleScattering {
 public:
  SingleScattering(physics::Physics& physics, const OpticalDepth& depth,
                   std::vector<double> edges,              // altitudes at which the air is not smooth, km
                   const TracedThings* things = nullptr);  // must live as long as this

  // Radiance for a sun of irradiance 1, scattered once in the air or reflected once by the ground at the ray's end.
  physics::vec3 radiance(const physics::Physics::Ray& ray, const Footing& footing = {}) const;
  Wide radiance(const physics::Physics::Ray& ray, const Footing& footing, const Wavelengths& all) const;

  // Rays whose panels ran out before their radiance was known to 1e-6.
  std::uint64_t cut_rays() const { return cut_rays_; }

  // Direct sunlight at `place`, a vector from the planet's centre; zero also where a thing hides the sun.
  // `h`: its altitude as the formulas have it, `beam`: the sun there, `left`: the thing on which the place lies.
  physics::vec3 sunlight_at(physics::vec3 place, double h, const Sunbeam& beam, ThingNumber left = kNoThing) const;

  // Direct sunlight at altitude h on a plane that faces the sun; zero in the planet's shadow.
  physics::vec3 sunlight(double h, const Sunbeam& beam) const;

 private:
  struct Integrand;
  struct WideIntegrand;
  physics::vec3 scattered(double h, const physics::Physics::Phases& phases, double uneven) const;
  template <class Value, class F>
  Value along(const physics::Physics::Ray& ray, const Footing& footing, const F& f) const;
  std::vector<SmoothPart> smooth_parts(const physics::Physics::Ray& ray) const;
  std::vector<SmoothPart> lit_parts(const std::vector<SmoothPart>& smooth, const physics::Physics::Ray& ray,
                                    const Footing& footing) const;
  bool is_reached(const LitPoint& lit, const BentWay& way, double t) const;
  bool is_lit(physics::vec3 place, double h, const Sunbeam& beam, ThingNumber left = kNoThing) const;
  BentWay way_of(const physics::Physics::Ray& ray, const Footing& footing) const;
  double thing_cosine(const physics::Physics::Ray& ray, const Footing& footing, const Sunbeam& beam) const;
  physics::vec3 seen_thing(const physics::Physics::Ray& ray, const Footing& footing) const;
  physics::vec3 seen_ground(physics::Physics& physics, const physics::Physics::Ray& ray, const Footing& footing,
                            physics::vec3 beam, double mu_sun) const;

  physics::Physics& physics_;
  const OpticalDepth& depth_;
  std::vector<double> edges_;
  const TracedThings* things_;
  mutable std::atomic<std::uint64_t> cut_rays_ = 0;
};

}  // namespace airlight
