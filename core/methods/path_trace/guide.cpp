#include "core/methods/path_trace/guide.h"

#include <algorithm>
#include <cmath>

#include "core/scene/angle.h"

namespace airlight {

using physics::vec3;

namespace {

// Nodes stand closest where the sun is near the horizon: x = mu / (|mu| + kBend).
constexpr double kBend = 0.1;
constexpr double kSide = 1.0 / (1.0 + kBend);

// Twilight fades by about this factor while the sun sinks by one degree.
constexpr double kFadePerDegree = 0.3;

// Mean slant of diffuse light: its path through a level shell over the shell's height.
constexpr double kSlant = 1.66;

// Lower limit of every guess, so that every choice remains possible.
constexpr double kLeast = 1e-9;

Channels channels(vec3 v) {
  return {v.x, v.y, v.z};
}

}  // namespace

double Guide::mu_of(int node) {
  const double x = kSide * (2.0 * node / (kNodes - 1) - 1.0);
  return std::clamp(kBend * x / (1.0 - std::abs(x)), -1.0, 1.0);
}

Guide::Guide(physics::Physics& physics, const OpticalDepth& depth, const std::vector<GuideShell>& shells)
    : rows_((shells.size() + 1) * kNodes) {
  for (int node = 0; node < kNodes; ++node) {
    fill_column(physics, depth, shells, node);
  }
  for (std::size_t row = 0; row <= shells.size(); ++row) {
    spread(row);
  }
}

// Fills in direct sunlight at every altitude of a vertical, on which the sun has the same elevation everywhere, and the
// light of all orders.
void Guide::fill_column(physics::Physics& physics, const OpticalDepth& depth, const std::vector<GuideShell>& shells,
                        int node) {
  const double mu = mu_of(node);
  const physics::PlanetData& planet = physics.scene.planet;
  const auto sunlight = [&](double h) {
    const double seen = physics.lifted_sun(h, mu);
    return physics.meets_ground(planet, h, seen) ? Channels{} : channels(exp(-depth.to_top(h, seen)));
  };
  const auto light = [&](std::size_t row) -> Light& { return rows_[row * kNodes + static_cast<std::size_t>(node)]; };
  const Channels on_ground = sunlight(0.0);
  for (std::size_t c = 0; c < 3; ++c) {
    // A Lambertian plane sends 4 mu / (4 pi) back where isotropic air sends 1 / (4 pi).
    light(0).sun[c] = 4.0 * std::max(mu, 0.0) * on_ground[c];
  }
  for (std::size_t k = 0; k < shells.size(); ++k) {
    light(k + 1).sun = sunlight(shells[k].altitude);
  }
  for (std::size_t c = 0; c < 3; ++c) {
    add_orders(shells, channels(planet.ground_albedo)[c], node, c);
  }
}

// Light of all orders by two streams, up and down, shell by shell. From the ground up: the light that everything below
// a shell's top sends up, and its reflectance. Then from the top down: the downward light.
void Guide::add_orders(const std::vector<GuideShell>& shells, double albedo, int node, std::size_t c) {
  const auto light = [&](std::size_t row) -> Light& { return rows_[row * kNodes + static_cast<std::size_t>(node)]; };
  struct Layer {
    double reflects, passes, up, down;  // for light that enters; for sunlight scattered inside
    double below_reflects, below_sends;
  };
  std::vector<Layer> layers;
  double reflects = albedo;
  double sends = albedo * 0.25 * light(0).sun[c];
  for (std::size_t k = 0; k < shells.size(); ++k) {
    const double scatters = shells[k].depth[c] * shells[k].scattered[c];
    const double back = kSlant * scatters * 0.5 * (1.0 - shells[k].asymmetry[c]);
    const double kept = std::exp(-kSlant * (shells[k].depth[c] - scatters));
    const double source = light(k + 1).sun[c] * shells[k].scattered[c] * -std::expm1(-shells[k].depth[c]);
    const Layer layer{kept * back / (1.0 + back), kept / (1.0 + back), 0.5 * source, 0.5 * source, reflects, sends};
    layers.push_back(layer);
    const double again = 1.0 / (1.0 - layer.reflects * reflects);
    sends = layer.up + layer.passes * (sends + reflects * layer.down) * again;
    reflects = layer.reflects + layer.passes * layer.passes * reflects * again;
  }
  double falls = 0.0;
  double rises = sends;
  for (std::size_t k = shells.size(); k-- > 0;) {
    const Layer& layer = layers[k];
    const double above = falls + rises;
    falls = (layer.passes * falls + layer.down + layer.reflects * layer.below_sends) /
            (1.0 - layer.reflects * layer.below_reflects);
    rises = layer.below_reflects * falls + layer.below_sends;
    // Twice the flux over both half spheres: as much as a sun that scatters isotropically.
    light(k + 1).sky[c] = above + falls + rises;
  }
  light(0).sky[c] = 4.0 * falls;
}

// Light also comes from the side where the sun is higher.
void Guide::spread(std::size_t row) {
  for (int node = kNodes - 2; node >= 0; --node) {
    const double degrees = (std::asin(mu_of(node + 1)) - std::asin(mu_of(node))) / kDegree;
    const double fade = std::pow(kFadePerDegree, degrees);
    for (std::size_t c = 0; c < 3; ++c) {
      const double beside = rows_[row * kNodes + static_cast<std::size_t>(node) + 1].sky[c];
      double& sky = rows_[row * kNodes + static_cast<std::size_t>(node)].sky[c];
      sky = std::max({sky, beside * fade, kLeast});
    }
  }
}

const Guide::Light& Guide::at(std::size_t row, double mu_sun) const {
  const double x = mu_sun / (std::abs(mu_sun) + kBend);
  const auto node = static_cast<int>(0.5 * (x / kSide + 1.0) * (kNodes - 1) + 0.5);
  return rows_[row * kNodes + static_cast<std::size_t>(std::clamp(node, 0, kNodes - 1))];
}

}  // namespace airlight
