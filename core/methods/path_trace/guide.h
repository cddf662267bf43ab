#pragma once
// A rough guess of the light that meets a point, to send samples where the light is. It steers the choice of vertices,
// by whose density the estimate is divided, and enters no result: a bad guess costs samples, never truth.

#include <array>
#include <vector>

#include "core/methods/path_trace/optical_depth.h"

namespace airlight {

using Channels = std::array<double, 3>;

inline Channels channels_of(const physics::vec3& v) {
  return {v.x, v.y, v.z};
}

// The guide's model of a layer of the air.
struct GuideShell {
  double altitude;     // km
  Channels depth;      // vertical optical depth
  Channels scattered;  // share of extinction that is scattering
  Channels asymmetry;  // mean cosine of the scattering
};

class Guide {
 public:
  // Light that arrives, for a sun of irradiance 1, divided by the isotropic phase function.
  struct Light {
    Channels sun;  // direct
    Channels sky;  // scattered or reflected before
  };

  Guide(physics::Physics& physics, const OpticalDepth& depth, const std::vector<GuideShell>& shells);

  const Light& in_air(std::size_t shell, double mu_sun) const { return at(shell + 1, mu_sun); }

  // Light that ground of albedo 1 reflects, on the same scale.
  const Light& on_ground(double mu_sun) const { return at(0, mu_sun); }

 private:
  static constexpr int kNodes = 192;
  static double mu_of(int node);
  const Light& at(std::size_t row, double mu_sun) const;
  void fill_column(physics::Physics& physics, const OpticalDepth& depth, const std::vector<GuideShell>& shells,
                   int node);
  void add_orders(const std::vector<GuideShell>& shells, double albedo, int node, std::size_t channel);
  void spread(std::size_t row);

  std::vector<Light> rows_;  // kNodes each: the ground, then every shell
};

}  // namespace airlight
