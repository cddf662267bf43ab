#include "core/stage/sampled_sky.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "core/air/scene_block.h"
#include "core/scene/angle.h"

namespace airlight {
namespace {

using physics::vec3;

constexpr physics::uint kViewSteps = 24;
constexpr physics::uint kSunSteps = 16;

}  // namespace

// `value` returns a curve's value at this wavelength.
template <typename Value>
SampledSky::Coefficients SampledSky::coefficients(double nm, Value value) const {
  const SceneSpectra& curves = *scene_.spectra;
  Coefficients c{.nm = nm, .albedo = value(scene_.planet.ground_albedo.curve)};
  c.light = curves.light ? value(*curves.light) : 1.0;
  for (std::size_t i = 0; i < scene_.media.size(); ++i) {
    c.scattering[i] = value(scene_.media[i].scattering.curve);
    c.extinction[i] = c.scattering[i] + value(scene_.media[i].absorption.curve);
    c.depolarization[i] = value(scene_.media[i].depolarization.curve);
  }
  return c;
}

// Zenith cosines that the camera's picture may show: sky and ground; from space the disc and the limb.
std::vector<double> SampledSky::zenith_cosines() {
  const double top = scene_.planet.atmosphere_height;
  const double horizon = p_.horizon_mu(planet(), scene_.camera.altitude);
  std::vector<double> mus;
  if (scene_.camera.altitude <= top) {
    for (const double degrees : {0.5, 2.0, 6.0, 14.0, 30.0, 55.0, 85.0}) {
      mus.push_back(std::max(std::sin(degrees * kDegree), horizon));
    }
    for (const double share : {0.02, 0.1, 0.5}) {
      mus.push_back(horizon - share * (1.0 + horizon));
    }
    return mus;
  }
  for (const double share : {0.02, 0.1, 0.25, 0.5}) {
    mus.push_back(tangent(share * top));
  }
  for (const double share : {0.02, 0.1, 0.3, 0.6, 1.0}) {
    mus.push_back(horizon - share * (1.0 + horizon));
  }
  return mus;
}

// Zenith cosine of a line that touches the sphere at this altitude, from a camera above it.
double SampledSky::tangent(double altitude) const {
  const double ratio =
      (scene_.planet.ground_radius + altitude) / (scene_.planet.ground_radius + scene_.camera.altitude);
  return -std::sqrt(std::max(1.0 - ratio * ratio, 0.0));
}

SampledSky::Columns SampledSky::densities(double h) {
  Columns d{};
  for (physics::uint i = 0; i < p_.media; ++i) {
    d[i] = p_.density(p_.density_profile(i), p_.scene.media[i], h);
  }
  return d;
}

SampledSky::Columns SampledSky::to_top(double h, double mu) {
  const physics::Physics::Ray ray{h, mu, mu, 1.0, p_.distance_to_top(planet(), h, mu), false, 0.0, false};
  const double falling = -(scene_.planet.ground_radius + h) * mu;
  const physics::uint before = p_.falling_steps(falling, ray.length_, kSunSteps);
  Columns columns{};
  double start = 0.0;
  for (physics::uint i = 0; i < kSunSteps; ++i) {
    const double end = p_.step_end(physics::kStepsQuadratic, falling, ray.length_, before, i, kSunSteps);
    const auto step = p_.step_between(start, end);
    start = end;
    const Columns here = densities(p_.point_on_ray(planet(), ray, step.t).h);
    for (physics::uint m = 0; m < p_.media; ++m) {
      columns[m] += here[m] * step.width;
    }
  }
  return columns;
}

SampledSky::Walk SampledSky::walk(double mu, double azimuth) {
  const vec3& sun = p_.scene.sun.direction;
  Walk walk;
  walk.nu = std::clamp(
      mu * sun.y + std::sqrt(std::max((1.0 - mu * mu) * (1.0 - sun.y * sun.y), 0.0)) * std::cos(azimuth), -1.0, 1.0);
  const auto ray = p_.ray_in_atmosphere(planet(), scene_.camera.altitude, mu, sun.y, walk.nu);
  if (ray.length_ <= 0.0) {
    return walk;
  }
  Columns before{};
  const auto from_sun = [&](double h, double mu_sun) {
    Columns columns = to_top(h, mu_sun);
    for (physics::uint m = 0; m < p_.media; ++m) {
      columns[m] += before[m];
    }
    return columns;
  };
  const auto plan = p_.plan_steps(planet(), ray, kViewSteps);
  for (physics::uint i = 0; i < kViewSteps; ++i) {
    const auto step = p_.planned_step(plan, i);
    if (step.width <= 0.0) {
      continue;
    }
    const auto point = p_.point_on_ray(planet(), ray, step.t);
    Columns here = densities(point.h);
    for (physics::uint m = 0; m < p_.media; ++m) {
      here[m] *= step.width;
    }
    if (!p_.meets_ground(planet(), point.h, point.mu_sun)) {
      walk.steps.push_back({here, from_sun(point.h, point.mu_sun)});
    }
    for (physics::uint m = 0; m < p_.media; ++m) {
      before[m] += here[m];
    }
  }
  if (ray.at_ground) {
    walk.ground_cosine = std::max(p_.point_on_ray(planet(), ray, ray.length_).mu_sun, 0.0);
    walk.by_ground = from_sun(0.0, walk.ground_cosine);
  }
  return walk;
}

void SampledSky::walk_to_sun() {
  const double mu = p_.scene.sun.direction.y;
  const auto ray = p_.ray_in_atmosphere(planet(), scene_.camera.altitude, mu, mu, 1.0);
  sees_sun_ = !ray.at_ground && ray.length_ > 0.0;
  if (sees_sun_) {
    to_sun_ = to_top(ray.h, ray.mu);
  }
}

SampledSky::Columns SampledSky::phases(double nu, const Coefficients& c) {
  const double degrees = std::atan2(std::sqrt((1.0 - nu) * (1.0 + nu)), nu) / kDegree;
  Columns phases{};
  for (physics::uint i = 0; i < p_.media; ++i) {
    const Medium& medium = scene_.media[i];
    if (medium.phase == PhaseFunction::table) {
      phases[i] = phase_at(medium.phase_table, c.nm, degrees);
    } else if (medium.phase == PhaseFunction::rayleigh) {
      phases[i] = p_.phase_depolarized(vec3(c.depolarization[i]), nu).x;
    } else {
      phases[i] = p_.medium_phase(i, nu).x;
    }
  }
  return phases;
}

double SampledSky::depth(const Coefficients& c, const Columns& columns) const {
  double depth = 0.0;
  for (physics::uint m = 0; m < p_.media; ++m) {
    depth += c.extinction[m] * columns[m];
  }
  return depth;
}

double SampledSky::radiance(const Walk& walk, const Coefficients& c) {
  Columns scattered = phases(walk.nu, c);
  for (physics::uint m = 0; m < p_.media; ++m) {
    scattered[m] *= c.scattering[m];
  }
  double light = 0.0;
  for (const LitStep& step : walk.steps) {
    double source = 0.0;
    for (physics::uint m = 0; m < p_.media; ++m) {
      source += scattered[m] * step.here[m];
    }
    light += source * p_.mean_transmittance(depth(c, step.here)) * std::exp(-depth(c, step.passed));
  }
  if (walk.ground_cosine > 0.0) {
    light += c.albedo * walk.ground_cosine / std::numbers::pi * std::exp(-depth(c, walk.by_ground));
  }
  return light;
}

// In order: each direction's light scattered once, the sun, then all of these scattered once more.
std::vector<SampledSky::Spectrum> SampledSky::spectra(const std::vector<Coefficients>& wavelengths) {
  std::vector<Spectrum> all;
  for (const Walk& walk : walks_) {
    Spectrum& light = all.emplace_back();
    for (const Coefficients& c : wavelengths) {
      light.push_back(c.light * radiance(walk, c));
    }
  }
  if (sees_sun_) {
    Spectrum& sun = all.emplace_back();
    for (const Coefficients& c : wavelengths) {
      sun.push_back(c.light * std::exp(-depth(c, to_sun_)));
    }
  }
  const std::size_t once = all.size();
  for (std::size_t i = 0; i < once; ++i) {
    Spectrum again = all[i];
    for (std::size_t w = 0; w < wavelengths.size(); ++w) {
      double scattering = 0.0;
      for (physics::uint m = 0; m < p_.media; ++m) {
        scattering += wavelengths[w].scattering[m] * vertical_[m];
      }
      again[w] *= -std::expm1(-scattering);
    }
    all.push_back(std::move(again));
  }
  return all;
}

SampledSky::SampledSky(const Scene& scene, const Air& air, const BandColours& colours)
    : scene_(scene), p_(formulas_of(air, scene)) {
  for (const double mu : zenith_cosines()) {
    for (const double azimuth : {0.0, 40.0, 100.0, 180.0}) {
      if (Walk found = walk(mu, azimuth * kDegree); !found.steps.empty() || found.ground_cosine > 0.0) {
        walks_.push_back(std::move(found));
      }
    }
  }
  walk_to_sun();
  vertical_ = to_top(0.0, 1.0);
  std::vector<Coefficients> wavelengths;
  for (const WaveBand& band : fine_bands()) {
    wavelengths.push_back(coefficients(0.5 * (band.low + band.high),
                                       [&](const Curve& curve) { return mean_over(curve, band.low, band.high); }));
  }
  for (const Spectrum& light : spectra(wavelengths)) {
    std::array<double, kFineBands> fine{};
    std::ranges::copy(light, fine.begin());
    colours_.push_back(colour_of(colours, fine));
  }
}

std::vector<ColouredSpectrum> SampledSky::at(const Nodes& nodes) {
  std::vector<Coefficients> wavelengths;
  for (std::size_t k = 0; k < nodes.nm.size(); ++k) {
    wavelengths.push_back(coefficients(nodes.nm[k], [&](const Curve& curve) { return at_node(curve, nodes, k); }));
  }
  const std::vector<Spectrum> light = spectra(wavelengths);
  std::vector<ColouredSpectrum> samples;
  for (std::size_t i = 0; i < light.size(); ++i) {
    // Nothing scatters there, or so little that no float holds it: the square of its inverse would be no number.
    constexpr double kLeast = 1e-36;
    if (std::ranges::any_of(colours_[i], [](double channel) { return std::abs(channel) > kLeast; })) {
      samples.push_back({light[i], colours_[i]});
    }
  }
  return samples;
}

}  // namespace airlight
