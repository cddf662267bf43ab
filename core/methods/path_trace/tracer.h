#pragma once
// A scene prepared for tracing: one estimate of a direction's radiance at a time, for a sun of irradiance 1.

#include <cstdint>
#include <optional>
#include <vector>

#include "core/methods/path_trace/walk.h"
#include "core/scene/scene.h"

namespace airlight {

// One of the rays whose weighted mean is a pixel.
struct SampledRay {
  physics::vec3 direction;
  double share = 1.0;
  double pixel = 0.0;  // angle that the ray represents
};

class PathTracer {
 public:
  // `wall`: View::wall, or infinity. `all`: null for three channels; else the wavelengths whose steering() the part is,
  // and radiance is in the picture's colours. `all` must outlive this.
  PathTracer(const Part& part, const Wavelengths* all, std::uint64_t seed, int max_orders, double wall);
  PathTracer(const PathTracer&) = delete;
  PathTracer& operator=(const PathTracer&) = delete;

  // A ray from mirror to mirror, whose light is the sum of its parts'. `pixel`: angle that the ray represents, over
  // which a map of the ground is averaged.
  using Chain = std::vector<WalkStart>;
  Chain start(physics::vec3 direction, double pixel = 0.0) const;

  // The first order, which is exact; nothing among clouds, where it is sampled as the others.
  physics::vec3 single(const Chain& chain) const;

  // Whether there are orders to sample.
  bool has_higher_orders() const { return max_orders_ != 1 || !clouds_.none(); }

  // The higher orders: mean of kBatch samples, one independent estimate. `scratch` is overwritten.
  physics::vec3 batch(const Chain& chain, std::uint64_t pixel, std::uint64_t batch, FlightPlan& scratch) const;

  // One estimate of the radiance that arrives at a place (as Walk::start_at() takes it) against `direction`, for a sun
  // of irradiance 1. Only among clouds, and in three channels.
  physics::vec3 arriving(physics::vec3 place, physics::vec3 direction, WalkNumbers& numbers,
                         FlightPlan& scratch) const {
    return walk_.sample(walk_.start_at(place, direction), numbers, scratch);
  }
  // Light that sets out there in that direction, as Walk::follow() has it.
  Walk::Left follow(physics::vec3 place, physics::vec3 direction, WalkNumbers& numbers, FlightPlan& scratch,
                    const std::function<void(physics::vec3 place, double share)>& lost) const {
    return walk_.follow(walk_.start_at(place, direction), numbers, scratch, lost);
  }
  const TracedClouds& clouds() const { return clouds_; }

  // Number of paths and of rays that were cut short because they would not have ended.
  std::uint64_t cut_paths() const { return walk_.cut_paths(); }
  std::uint64_t cut_rays() const { return single_.cut_rays(); }

  // From the camera to the end of the chain's first part, 1 where it misses the air; with wavelengths, the colour of
  // sunlight behind the air.
  physics::vec3 transmittance(const Chain& chain) const;

  physics::vec3 direction(double elevation, double azimuth) const {
    return physics_.direction_from_angles(elevation, azimuth);
  }

  // The rays of a pixel: its centre's; several at the planet's edge (shaders/physics/horizon.glsl); none outside a
  // fisheye's circle.
  std::vector<SampledRay> pixel_rays(int x, int y) const;

 private:
  double pixel_angle(int x, int y) const;
  bool holds_edge(int x, int y) const;
  BentWay way_of(const WalkStart& start) const;
  // What a corner of a pixel sees: the nearest thing, infinitely far where there is none, and whether the sun shines
  // where the ray ends.
  struct Corner {
    TracedThings::Met met;
    bool lit = true;
  };
  Corner corner(physics::vec3 direction) const;
  Corner bent_corner(physics::vec3 direction) const;
  physics::vec3 view(double x, double y) const;

  mutable physics::Physics physics_;  // never written; GLSL's functions have no const
  OpticalDepth depth_;
  Flight flight_;
  SkyGuide guide_;
  TracedThings things_;
  TracedClouds clouds_;
  SingleScattering single_;
  Walk walk_;
  const Wavelengths* all_;
  std::uint64_t seed_;
  int max_orders_;
  double wall_;
  std::uint32_t projection_;
};

}  // namespace airlight
