#pragma once
// A scene ready to be traced: one estimate of a direction's radiance at a time, all for a sun of irradiance 1.

#include <cstdint>
#include <optional>
#include <vector>

#include "core/air/air.h"
#include "core/methods/path_trace/walk.h"
#include "core/scene/scene.h"

namespace airlight {

// One of the rays whose weighted mean is a pixel.
struct SampledRay {
  physics::vec3 direction;
  double share = 1.0;
  double pixel = 0.0;  // angle that it stands for
};

class PathTracer {
 public:
  // `wall`: View::wall, or infinity. `all`: null for a scene of three channels; else its wavelengths, whose steering()
  // is the scene: radiance is then in the picture's colours. Must live as long as this.
  PathTracer(const Air& air, const Scene& scene, const Wavelengths* all, std::uint64_t seed, int max_orders,
             double wall);
  PathTracer(const PathTracer&) = delete;
  PathTracer& operator=(const PathTracer&) = delete;

  // `pixel`: angle that the ray stands for, over which a map of the ground is averaged.
  WalkStart start(physics::vec3 direction, double pixel = 0.0) const {
    WalkStart start = walk_.start(direction, wall_);
    start.pixel = pixel;
    return start;
  }

  // The first order: exact.
  physics::vec3 single(const WalkStart& start) const;

  // Whether there are further orders to sample.
  bool has_higher_orders() const { return max_orders_ != 1; }

  // The higher orders: mean of kBatch samples, one independent estimate. `scratch` is overwritten.
  physics::vec3 batch(const WalkStart& start, std::uint64_t pixel, std::uint64_t batch, FlightPlan& scratch) const;

  // Paths and rays that were cut short because they would never have ended.
  std::uint64_t cut_paths() const { return walk_.cut_paths(); }
  std::uint64_t cut_rays() const { return single_.cut_rays(); }

  // From the camera to the ray's end, 1 where it misses the air; of wavelengths, the colour of sunlight behind it.
  physics::vec3 transmittance(const WalkStart& start) const;

  physics::vec3 direction(double elevation, double azimuth) const {
    return physics_.direction_from_angles(elevation, azimuth);
  }

  // The rays of a pixel: its centre's, several at the planet's edge (shaders/physics/horizon.glsl), none outside a
  // fisheye's circle.
  std::vector<SampledRay> pixel_rays(int x, int y) const;

 private:
  double pixel_angle(int x, int y) const;
  bool holds_terrain_edge(int x, int y) const;
  physics::vec3 view(double x, double y) const;

  mutable physics::Physics physics_;  // GLSL's functions know no const; none of them writes
  OpticalDepth depth_;
  Flight flight_;
  SkyGuide guide_;
  std::optional<TracedTerrain> terrain_;
  SingleScattering single_;
  Walk walk_;
  const Wavelengths* all_;
  std::uint64_t seed_;
  int max_orders_;
  double wall_;
  std::uint32_t projection_;
};

}  // namespace airlight
