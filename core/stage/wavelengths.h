#pragma once
// The wavelengths of a scene with spectra, the matrix that makes colours of them, and the scene in three of them.

#include <array>
#include <cstddef>
#include <vector>

#include "core/air/air.h"
#include "core/scene/scene.h"

namespace airlight {

struct ColourBasis {
  Nodes nodes;
  ColourMatrix matrix;
  Rgb sun{};  // the colour of sunlight above the air, for an irradiance of 1
};

// Everything that a fitted basis depends on.
struct FitInputs {
  std::vector<Medium> media;
  Planet planet;
  SceneSpectra spectra;
  bool schlick = false;  // phase functions
  double sun_elevation = 0.0;
  double altitude = 0.0;
  double enough = 0.0;  // the error at which automatic wavelengths are enough

  FitInputs() = default;
  FitInputs(const Scene& scene, bool by_schlick);
  bool operator==(const FitInputs&) const = default;
};

// The scene's wavelengths, with a matrix fitted to its sampled sky. Automatic ones are the fewest, in whole groups,
// whose matrix renders that sky to 0.4 %, by `orders` to 1 % among terrain and spheres without maps of
// colour and to 2 % among fields of clouds, of which it is further off. The scene must have spectra; `air`: of its
// three channels.
ColourBasis fitted_basis(const Scene& scene, const Air& air);

// The same at given wavelengths. The matrix is that of their cells (cell_matrix), close to the truth where they are
// dense.
ColourBasis basis_at(const SceneSpectra& spectra, const Nodes& nodes);

// The scene in three wavelengths of a basis at a time, without spectra.
class PartScenes {
 public:
  PartScenes(const Scene& scene, const ColourBasis& basis);

  std::size_t count() const { return (basis_.nodes.nm.size() + 2) / 3; }
  // A part that the wavelengths do not fill has the last one again, in channels that add no colour.
  std::array<std::size_t, 3> nodes(std::size_t part) const;
  std::array<Rgb, 3> colours(std::size_t part) const;
  Scene scene(std::size_t part) const;

 private:
  const Scene& scene_;
  const ColourBasis& basis_;
  std::array<Curve, 3> primaries_;  // reflectances that make up the colours of maps
};

}  // namespace airlight
