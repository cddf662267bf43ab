#include "core/methods/spectral_sky.h"

#include <algorithm>
#include <cassert>
#include <deque>
#include <mutex>

#include "core/methods/method.h"
#include "core/methods/sampled_sky.h"
#include "core/methods/scene_air.h"
#include "core/spectra/reflectance.h"

namespace airlight {
namespace {

// Weight of a change in the matrix against the samples' mean, for directions too alike to determine the matrix.
constexpr double kStiffness = 1e-4;

// `auto` chooses the first of these, in whole groups, whose error over the samples is at most kEnough. The error over
// the whole sky, scattered more than once, is little more.
constexpr std::array<int, 4> kAutomaticWavelengths{3, 6, 12, 24};
constexpr double kEnough = 0.004;

// `primaries`: the reflectances that make up the colours of maps.
Scene group_scene(const Scene& scene, const Nodes& nodes, const std::array<std::size_t, 3>& at,
                  const std::array<Curve, 3>& primaries) {
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
    if (group.terrain) {
      group.terrain->albedo[c] = at_node(spectra.terrain_albedo, nodes, at[c]);
      for (std::size_t j = 0; j < 3 && !group.terrain->albedo_map.empty(); ++j) {
        group.terrain->mix[c][j] = at_node(primaries[j], nodes, at[c]);
      }
    }
    group.sun.irradiance[c] = spectra.irradiance;
  }
  group.spectra.reset();
  return group;
}

// Wavelengths and matrix of a scene, with all parts of the scene that they depend on.
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
    if (spectra.wavelengths == kFineBands) {
      nodes = nodes_for(kFineBands);
      matrix = nearest_matrix(nodes, colours);
      return;
    }
    SampledSky sky(scene, colours);
    if (spectra.wavelengths != 0) {
      fit(sky, colours, spectra.wavelengths);
      return;
    }
    for (const int count : kAutomaticWavelengths) {
      if (fit(sky, colours, count) <= kEnough) {
        return;
      }
    }
  }

 private:
  // Returns the remaining error of the samples.
  double fit(SampledSky& sky, const BandColours& colours, int count) {
    nodes = nodes_for(count);
    const std::vector<ColouredSpectrum> samples = sky.at(nodes);
    matrix = lit_matrix(fitted_matrix(samples, universal_matrix(nodes, colours), sun, kStiffness),
                        nearest_matrix(nodes, colours));
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

SpectralScene in_groups(const Scene& scene, SpectralScene made) {
  RenderSettings render = scene.render;
  if (const SkyMethod* method = find_method(render.method); method->settle != nullptr) {
    method->settle(render, scene, air_of(scene));
  }
  const std::size_t count = made.nodes.nm.size();
  const bool has_map = scene.terrain && !scene.terrain->albedo_map.empty();
  const auto primaries =
      has_map ? reflectances_of_primaries(scene.spectra->sun, scene.spectra->white) : std::array<Curve, 3>();
  for (std::size_t first = 0; first < count; first += 3) {
    const std::array<std::size_t, 3> at{first, std::min(first + 1, count - 1), std::min(first + 2, count - 1)};
    WavelengthGroup group{group_scene(scene, made.nodes, at, primaries), {}};
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
