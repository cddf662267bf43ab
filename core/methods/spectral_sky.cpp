#include "core/methods/spectral_sky.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <deque>
#include <mutex>
#include <numbers>

#include "core/methods/method.h"
#include "core/methods/scene_air.h"

namespace airlight {
namespace {

using physics::vec3;

constexpr physics::uint kViewSteps = 24;
constexpr physics::uint kSunSteps = 16;
// Of a change in the matrix against the samples' mean, where the directions are too alike to tell.
constexpr double kStiffness = 1e-4;

// What `auto` chooses among, in whole groups, and when it is content: a third of a percent of the samples, which the
// whole sky, scattered more than once, exceeds by little.
constexpr std::array<int, 4> kAutomaticWavelengths{3, 6, 12, 24};
constexpr double kEnough = 1.0 / 300.0;

using Columns = std::array<double, kMaxMedia>;  // density times length, km, by medium

// Coefficients of one wavelength.
struct Coefficients {
  Columns scattering{};
  Columns extinction{};
  Columns depolarization{};
  double albedo = 0.0;
  double nm = 0.0;
};

// The fine bands, then the nodes.
std::vector<Coefficients> coefficients_of(const SceneSpectra& spectra, const Nodes& nodes) {
  std::vector<Coefficients> all;
  const auto add = [&](double nm, auto value) {
    Coefficients c;
    c.nm = nm;
    for (std::size_t i = 0; i < spectra.media.size(); ++i) {
      c.scattering[i] = value(spectra.media[i].scattering);
      c.extinction[i] = c.scattering[i] + value(spectra.media[i].absorption);
      c.depolarization[i] = value(spectra.media[i].depolarization);
    }
    c.albedo = value(spectra.ground_albedo);
    all.push_back(c);
  };
  for (const WaveBand& band : fine_bands()) {
    add(0.5 * (band.low + band.high), [&](const Curve& curve) { return mean_over(curve, band.low, band.high); });
  }
  for (std::size_t k = 0; k < nodes.nm.size(); ++k) {
    add(nodes.nm[k], [&](const Curve& curve) { return at_node(curve, nodes, k); });
  }
  return all;
}

class SkySampler {
 public:
  SkySampler(const Scene& scene, const Nodes& nodes)
      : scene_(scene), p_(make_physics(scene)), coefficients_(coefficients_of(*scene.spectra, nodes)) {}

  // Empty where the ray misses the air, or nothing is lit.
  std::vector<double> sky(double mu, double azimuth) {
    const vec3& sun = p_.scene.sun.direction;
    const double nu = std::clamp(
        mu * sun.y + std::sqrt(std::max((1.0 - mu * mu) * (1.0 - sun.y * sun.y), 0.0)) * std::cos(azimuth), -1.0, 1.0);
    const auto ray = p_.ray_in_atmosphere(planet(), scene_.camera.altitude, mu, sun.y, nu);
    if (ray.length_ <= 0.0) {
      return {};
    }
    const std::vector<Columns> phases = phases_at(nu);
    std::vector<double> light(coefficients_.size());
    Columns before{};
    const auto plan = p_.plan_steps(planet(), ray, kViewSteps);
    for (physics::uint i = 0; i < kViewSteps; ++i) {
      const auto step = p_.planned_step(plan, i);
      if (step.width <= 0.0) {
        continue;
      }
      const auto point = p_.point_on_ray(planet(), ray, step.t);
      const Columns here = densities(point.h);
      if (!p_.meets_ground(planet(), point.h, point.mu_sun)) {
        add_scattered(light, here, before, to_top(point.h, point.mu_sun), phases, step.width);
      }
      for (std::size_t m = 0; m < p_.media; ++m) {
        before[m] += here[m] * step.width;
      }
    }
    if (ray.at_ground) {
      add_ground(light, before, p_.point_on_ray(planet(), ray, ray.length_).mu_sun);
    }
    return *std::max_element(light.begin(), light.end()) > 0.0 ? light : std::vector<double>();
  }

  // The sun itself; empty where the planet hides it.
  std::vector<double> sun() {
    const double mu = p_.scene.sun.direction.y;
    const auto ray = p_.ray_in_atmosphere(planet(), scene_.camera.altitude, mu, mu, 1.0);
    if (ray.at_ground || ray.length_ <= 0.0) {
      return {};
    }
    std::vector<double> light(coefficients_.size());
    const Columns columns = to_top(ray.h, ray.mu);
    for (std::size_t w = 0; w < light.size(); ++w) {
      light[w] = through(coefficients_[w], columns, {});
    }
    return light;
  }

  // What part of light that meets the air is scattered again, from the ground straight up.
  std::vector<double> again() {
    const Columns columns = to_top(0.0, 1.0);
    std::vector<double> share;
    for (const Coefficients& c : coefficients_) {
      double depth = 0.0;
      for (std::size_t m = 0; m < p_.media; ++m) {
        depth += c.scattering[m] * columns[m];
      }
      share.push_back(-std::expm1(-depth));
    }
    return share;
  }

  double horizon() { return p_.horizon_mu(planet(), scene_.camera.altitude); }
  // Zenith cosine of a line that touches the sphere at this altitude, from a camera above it.
  double tangent(double altitude) {
    const double ratio =
        (scene_.planet.ground_radius + altitude) / (scene_.planet.ground_radius + scene_.camera.altitude);
    return -std::sqrt(std::max(1.0 - ratio * ratio, 0.0));
  }

 private:
  const physics::PlanetData& planet() const { return p_.scene.planet; }

  Columns densities(double h) {
    Columns d{};
    for (physics::uint i = 0; i < p_.media; ++i) {
      d[i] = p_.density(p_.density_profile(i), p_.scene.media[i], h);
    }
    return d;
  }

  Columns to_top(double h, double mu) {
    physics::Physics::Ray ray{h, mu, mu, 1.0, p_.distance_to_top(planet(), h, mu), false};
    const double falling = -(scene_.planet.ground_radius + h) * mu;
    const physics::uint before = p_.falling_steps(falling, ray.length_, kSunSteps);
    Columns sum{};
    double start = 0.0;
    for (physics::uint i = 0; i < kSunSteps; ++i) {
      const double end = p_.step_end(physics::kStepsQuadratic, falling, ray.length_, before, i, kSunSteps);
      const auto step = p_.step_between(start, end);
      start = end;
      const Columns here = densities(p_.point_on_ray(planet(), ray, step.t).h);
      for (std::size_t m = 0; m < p_.media; ++m) {
        sum[m] += here[m] * step.width;
      }
    }
    return sum;
  }

  // By wavelength, then by medium.
  std::vector<Columns> phases_at(double nu) {
    const physics::Physics::Phases plain = p_.phases(nu);
    const double degrees = std::atan2(std::sqrt((1.0 - nu) * (1.0 + nu)), nu) * 180.0 / std::numbers::pi;
    std::vector<Columns> all(coefficients_.size());
    for (std::size_t w = 0; w < all.size(); ++w) {
      for (std::size_t i = 0; i < p_.media; ++i) {
        const Medium& medium = scene_.media[i];
        if (medium.phase == PhaseFunction::table) {
          all[w][i] = phase_at(medium.phase_table, coefficients_[w].nm, degrees);
        } else if (medium.phase == PhaseFunction::rayleigh) {
          all[w][i] = p_.phase_depolarized(vec3(coefficients_[w].depolarization[i]), nu).x;
        } else {
          all[w][i] = plain.of[i].x;
        }
      }
    }
    return all;
  }

  double through(const Coefficients& c, const Columns& a, const Columns& b) const {
    double depth = 0.0;
    for (std::size_t m = 0; m < p_.media; ++m) {
      depth += c.extinction[m] * (a[m] + b[m]);
    }
    return std::exp(-depth);
  }

  void add_scattered(std::vector<double>& light, const Columns& here, const Columns& before, const Columns& to_sun,
                     const std::vector<Columns>& phases, double width) {
    for (std::size_t w = 0; w < light.size(); ++w) {
      const Coefficients& c = coefficients_[w];
      double source = 0.0;
      double depth = 0.0;
      for (std::size_t m = 0; m < p_.media; ++m) {
        source += c.scattering[m] * here[m] * phases[w][m];
        depth += c.extinction[m] * here[m] * width;
      }
      light[w] += source * width * p_.mean_transmittance(depth) * through(c, before, to_sun);
    }
  }

  void add_ground(std::vector<double>& light, const Columns& before, double mu_sun) {
    if (mu_sun <= 0.0) {
      return;
    }
    const Columns to_sun = to_top(0.0, mu_sun);
    for (std::size_t w = 0; w < light.size(); ++w) {
      light[w] += coefficients_[w].albedo * mu_sun / std::numbers::pi * through(coefficients_[w], before, to_sun);
    }
  }

  const Scene& scene_;
  physics::Physics p_;
  std::vector<Coefficients> coefficients_;
};

// Zenith cosines that the camera's picture may hold light from: sky and ground, or from space the disc and the limb.
std::vector<double> zenith_cosines(SkySampler& sampler, const Scene& scene) {
  const double top = scene.planet.atmosphere_height;
  std::vector<double> mus;
  if (scene.camera.altitude <= top) {
    const double horizon = sampler.horizon();
    for (const double degrees : {0.5, 2.0, 6.0, 14.0, 30.0, 55.0, 85.0}) {
      mus.push_back(std::max(std::sin(degrees * std::numbers::pi / 180.0), horizon));
    }
    for (const double share : {0.02, 0.1, 0.5}) {
      mus.push_back(horizon - share * (1.0 + horizon));
    }
    return mus;
  }
  for (const double share : {0.02, 0.1, 0.25, 0.5}) {
    mus.push_back(sampler.tangent(share * top));
  }
  for (const double share : {0.02, 0.1, 0.3, 0.6, 1.0}) {
    mus.push_back(sampler.horizon() - share * (1.0 + sampler.horizon()));
  }
  return mus;
}

ColouredSpectrum coloured(const std::vector<double>& light, const BandColours& colours) {
  ColouredSpectrum sample;
  std::array<double, kFineBands> fine{};
  std::copy_n(light.begin(), kFineBands, fine.begin());
  sample.at_nodes.assign(light.begin() + kFineBands, light.end());
  sample.colour = colour_of(colours, fine);
  return sample;
}

Scene group_scene(const Scene& scene, const Nodes& nodes, const std::array<std::size_t, 3>& at, double irradiance) {
  Scene group = scene;
  const SceneSpectra& spectra = *scene.spectra;
  for (std::size_t c = 0; c < 3; ++c) {
    for (std::size_t i = 0; i < group.media.size(); ++i) {
      group.media[i].scattering[c] = at_node(spectra.media[i].scattering, nodes, at[c]);
      group.media[i].absorption[c] = at_node(spectra.media[i].absorption, nodes, at[c]);
      group.media[i].depolarization[c] = at_node(spectra.media[i].depolarization, nodes, at[c]);
      group.media[i].phase_wavelengths[c] = nodes.nm[at[c]];
    }
    group.planet.ground_albedo[c] = at_node(spectra.ground_albedo, nodes, at[c]);
    for (std::size_t i = 0; i < group.spheres.size(); ++i) {
      group.spheres[i].albedo[c] = at_node(spectra.spheres[i], nodes, at[c]);
    }
    group.sun.irradiance[c] = irradiance;
  }
  group.spectra.reset();
  return group;
}

// Wavelengths and matrix of a scene, and all of the scene that they depend on.
struct Fit {
  std::vector<Medium> media;
  Planet planet;
  SceneSpectra spectra;
  bool schlick = false;  // phase functions
  double sun_elevation = 0.0;
  double altitude = 0.0;

  Nodes nodes;
  ColourMatrix matrix;
  Rgb sun{};

  explicit Fit(const Scene& scene)
      : media(scene.media),
        planet(scene.planet),
        spectra(*scene.spectra),
        schlick(air_options(scene.render).schlick),
        sun_elevation(scene.sun.elevation),
        altitude(scene.camera.altitude) {}

  bool is_for(const Fit& other) const {
    return media == other.media && planet == other.planet && spectra == other.spectra && schlick == other.schlick &&
           sun_elevation == other.sun_elevation && altitude == other.altitude;
  }

  void make(const Scene& scene) {
    const BandColours colours = band_colours(spectra.sun, spectra.white);
    sun = sun_colour(colours);
    if (spectra.wavelengths != 0) {
      make(scene, colours, spectra.wavelengths);
      return;
    }
    for (const int count : kAutomaticWavelengths) {
      if (make(scene, colours, count) <= kEnough) {
        return;
      }
    }
  }

  // Returns what is left of the samples' errors.
  double make(const Scene& scene, const BandColours& colours, int count) {
    nodes = nodes_for(count);
    const ColourMatrix plain = nearest_matrix(nodes, colours);
    if (count == kFineBands) {
      matrix = plain;
      return 0.0;
    }
    const std::vector<ColouredSpectrum> samples = sampled_sky(scene, nodes, colours);
    matrix = lit_matrix(fitted_matrix(samples, universal_matrix(nodes, colours), sun, kStiffness), plain);
    return mean_error(matrix, samples);
  }
};

// The latest first.
Fit fit_of(const Scene& scene) {
  constexpr std::size_t kRemembered = 8;
  static std::mutex mutex;
  static std::deque<Fit> made;
  Fit fit(scene);
  {
    const std::lock_guard lock(mutex);
    const auto found = std::ranges::find_if(made, [&](const Fit& other) { return other.is_for(fit); });
    if (found != made.end()) {
      return *found;
    }
  }
  fit.make(scene);
  const std::lock_guard lock(mutex);
  made.push_front(fit);
  if (made.size() > kRemembered) {
    made.pop_back();
  }
  return fit;
}

}  // namespace

std::vector<ColouredSpectrum> sampled_sky(const Scene& scene, const Nodes& nodes, const BandColours& colours) {
  SkySampler sampler(scene, nodes);
  std::vector<ColouredSpectrum> samples;
  std::vector<std::vector<double>> once;
  const auto add = [&](const std::vector<double>& light) {
    if (!light.empty()) {
      once.push_back(light);
      samples.push_back(coloured(light, colours));
    }
  };
  for (const double mu : zenith_cosines(sampler, scene)) {
    for (const double azimuth : {0.0, 40.0, 100.0, 180.0}) {
      add(sampler.sky(mu, azimuth * std::numbers::pi / 180.0));
    }
  }
  add(sampler.sun());
  const std::vector<double> again = sampler.again();
  for (std::vector<double>& light : once) {
    for (std::size_t w = 0; w < light.size(); ++w) {
      light[w] *= again[w];
    }
    samples.push_back(coloured(light, colours));
  }
  return samples;
}

namespace {

SpectralScene in_groups(const Scene& scene, SpectralScene made) {
  RenderSettings render = scene.render;
  if (const SkyMethod* method = find_method(render.method); method->settle != nullptr) {
    method->settle(render, scene, air_of(scene));
  }
  const std::size_t count = made.nodes.nm.size();
  for (std::size_t first = 0; first < count; first += 3) {
    const std::array<std::size_t, 3> at{first, std::min(first + 1, count - 1), std::min(first + 2, count - 1)};
    WavelengthGroup group{group_scene(scene, made.nodes, at, scene.spectra->irradiance), {}};
    group.scene.render = render;
    for (std::size_t c = 0; c < 3 && first + c < count; ++c) {
      group.colours[c] = made.matrix[first + c];
    }
    made.groups.push_back(std::move(group));
  }
  return made;
}

}  // namespace

SpectralScene spectral_scene(const Scene& scene) {
  assert(scene.spectra);
  const Fit fit = fit_of(scene);
  return in_groups(scene, {fit.nodes, fit.matrix, fit.sun, {}});
}

SpectralScene spectral_scene_at(const Scene& scene, const Nodes& nodes) {
  assert(scene.spectra);
  const BandColours colours = band_colours(scene.spectra->sun, scene.spectra->white);
  const ColourMatrix matrix = cell_matrix(nodes, scene.spectra->sun, scene.spectra->white);
  return in_groups(scene, {nodes, matrix, sun_colour(colours), {}});
}

std::array<Rgb, 3> over_the_sun(std::array<Rgb, 3> colours, const Rgb& sun) {
  for (Rgb& colour : colours) {
    for (std::size_t c = 0; c < 3; ++c) {
      colour[c] /= sun[c];
    }
  }
  return colours;
}

std::uint32_t scattering_media(const SpectralScene& spectral) {
  std::uint32_t bits = 0;
  for (const WavelengthGroup& group : spectral.groups) {
    bits |= air_of(group.scene).scattering_media();
  }
  return bits;
}

}  // namespace airlight
