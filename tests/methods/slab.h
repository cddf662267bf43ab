#pragma once
// Radiance reflected and transmitted by a level, homogeneous, scalar slab, by adding and doubling of thin layers in
// Fourier modes of azimuth: an independent judge for a planet so large that it is flat.

#include <vector>

namespace airlight {

struct SlabCase {
  double optical_depth = 1.0;
  double single_scattering_albedo = 1.0;
  std::vector<double> moments;  // chi_l of the phase function: sum of (2l+1) chi_l P_l(cosine) / (4 pi)
  double ground_albedo = 0.0;
};

// Radiance for a sun of irradiance 1 (on a plane facing it) at zenith cosine nodes[sun].
class Slab {
 public:
  Slab(const SlabCase& slab, int nodes_per_hemisphere, int sun);

  const std::vector<double>& nodes() const { return nodes_; }  // zenith cosines, 0 to 1

  // Upward radiance at the top along zenith cosine nodes[i], and downward scattered radiance at the bottom. The azimuth
  // is counted from the sun's as the viewer sees it.
  double reflected(std::size_t i, double azimuth) const;
  double transmitted(std::size_t i, double azimuth) const;

  // Means over azimuth, and the quadrature's weights, for fluxes.
  double mean_reflected(std::size_t i) const { return reflected_.front()[i]; }
  double mean_transmitted(std::size_t i) const { return transmitted_.front()[i]; }
  const std::vector<double>& weights() const { return weights_; }

 private:
  std::vector<double> nodes_;
  std::vector<double> weights_;
  std::vector<std::vector<double>> reflected_;  // by mode, then node
  std::vector<std::vector<double>> transmitted_;
};

std::vector<double> rayleigh_moments();
std::vector<double> henyey_greenstein_moments(double g, int count);

}  // namespace airlight
