#include "core/scene/density_column.h"

#include <algorithm>
#include <vector>

#include "core/physics/physics.h"

namespace airlight {
namespace {

// The formulas of shaders/physics/medium.glsl for one medium.
class OneMedium {
 public:
  explicit OneMedium(const Density& density) {
    medium_.scale_height = density.scale_height;
    medium_.center = density.center;
    medium_.half_width = density.half_width;
    medium_.below = density.below;
    medium_.layer_count = static_cast<physics::uint>(std::min<std::size_t>(density.layers.size(), kMaxDensityLayers));
    for (physics::uint i = 0; i < medium_.layer_count; ++i) {
      formulas_.scene.layers[i] = {density.layers[i].altitude, density.layers[i].density};
    }
    // The shaders' codes are in the order of the names.
    static_assert(static_cast<physics::uint>(DensityProfile::exponential) == physics::kDensityExponential &&
                  static_cast<physics::uint>(DensityProfile::tent) == physics::kDensityTent &&
                  static_cast<physics::uint>(DensityProfile::lorentzian) == physics::kDensityLorentzian &&
                  static_cast<physics::uint>(DensityProfile::constant) == physics::kDensityConstant &&
                  static_cast<physics::uint>(DensityProfile::layers) == physics::kDensityLayers &&
                  static_cast<physics::uint>(DensityProfile::height_fog) == physics::kDensityHeightFog);
    profile_ = static_cast<physics::uint>(density.profile);
  }

  double at(double h) { return formulas_.density(profile_, medium_, h); }

 private:
  physics::Physics formulas_;
  physics::MediumData medium_{};
  physics::uint profile_ = 0;
};

}  // namespace

double density_column(const Density& density, double top) {
  // Where the density or its slope jumps, and the smooth parts in even pieces of at most a quarter of a scale.
  std::vector<double> edges{0.0, top};
  double scale = top / 8.0;
  if (density.profile == DensityProfile::exponential || density.profile == DensityProfile::lorentzian ||
      density.profile == DensityProfile::height_fog) {
    scale = std::min(scale, 0.25 * density.scale_height);
  }
  if (density.profile == DensityProfile::tent || density.profile == DensityProfile::lorentzian) {
    scale = std::min(scale, 0.25 * density.half_width);
    edges.insert(edges.end(),
                 {density.center - density.half_width, density.center, density.center + density.half_width});
  }
  if (density.profile == DensityProfile::constant || density.profile == DensityProfile::height_fog) {
    edges.push_back(density.below);
  }
  for (const DensityLayer& layer : density.layers) {
    edges.push_back(layer.altitude);
  }
  std::ranges::sort(edges);
  OneMedium medium(density);
  double sum = 0.0;
  for (std::size_t k = 1; k < edges.size(); ++k) {
    const double low = std::clamp(edges[k - 1], 0.0, top);
    const double high = std::clamp(edges[k], 0.0, top);
    const int pieces = static_cast<int>(std::clamp((high - low) / scale + 1.0, 1.0, 1000.0));
    const double width = (high - low) / pieces;
    // Gauss and Legendre's two points, inside of each piece: a jump at its end is not met.
    for (int i = 0; i < pieces && width > 0.0; ++i) {
      const double middle = low + (i + 0.5) * width;
      const double away = 0.28867513459481287 * width;
      sum += 0.5 * width * (medium.at(middle - away) + medium.at(middle + away));
    }
  }
  return sum;
}

}  // namespace airlight
