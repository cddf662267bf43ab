#pragma once
// The light of a scene scattered once, in a few dozen directions, by which wavelengths and their matrix are judged.

#include <array>
#include <vector>

#include "core/air/air.h"
#include "core/physics/physics.h"
#include "core/scene/scene.h"

namespace airlight {

// Spectra, over the sun's, of sunlight scattered once or reflected by the ground, in a few dozen directions around the
// camera, and of the sun seen through the air; then the same light scattered once more. Rays are walked once, by the
// same steps for all wavelengths. The scene must have spectra and outlive this.
class SampledSky {
 public:
  SampledSky(const Scene& scene, const Air& air, const BandColours& colours);

  // Spectra at the nodes, and their colours by all fine bands.
  std::vector<ColouredSpectrum> at(const Nodes& nodes);

 private:
  using Columns = std::array<double, kMaxMedia>;  // density times length, km, by medium
  using Spectrum = std::vector<double>;

  // Coefficients of one wavelength.
  struct Coefficients {
    double nm = 0.0;
    Columns scattering{};
    Columns extinction{};
    Columns depolarization{};
    double albedo = 0.0;
    double light = 1.0;  // over the sun's
  };

  // A lit part of a ray.
  struct LitStep {
    Columns here{};
    Columns passed{};  // from the sun to the step and on to the camera
  };

  struct Walk {
    double nu = 0.0;
    std::vector<LitStep> steps;
    double ground_cosine = 0.0;  // of the sun, where the ray ends on lit ground; else 0
    Columns by_ground{};         // from the sun to the ground and on to the camera
  };

  template <typename Value>
  Coefficients coefficients(double nm, Value value) const;
  std::vector<double> zenith_cosines();
  double tangent(double altitude) const;
  Columns densities(double h);
  Columns to_top(double h, double mu);
  Walk walk(double mu, double azimuth);
  void walk_to_sun();
  Columns phases(double nu, const Coefficients& c);
  double depth(const Coefficients& c, const Columns& columns) const;
  double radiance(const Walk& walk, const Coefficients& c);
  std::vector<Spectrum> spectra(const std::vector<Coefficients>& wavelengths);

  const physics::PlanetData& planet() const { return p_.scene.planet; }

  const Scene& scene_;
  physics::Physics p_;
  std::vector<Walk> walks_;
  bool sees_sun_ = false;
  Columns to_sun_{};          // from the camera
  Columns vertical_{};        // from the ground straight up
  std::vector<Rgb> colours_;  // of the spectra, by the fine bands; black where nothing is lit
};

}  // namespace airlight
