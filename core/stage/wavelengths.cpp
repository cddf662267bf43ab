#include "core/stage/wavelengths.h"

#include <algorithm>
#include <cassert>

#include "core/scene/thing_kinds.h"
#include "core/spectra/data.h"
#include "core/spectra/reflectance.h"
#include "core/stage/sampled_sky.h"

namespace airlight {
namespace {

// Weight of a change in the matrix against the samples' mean, for directions too alike to determine the matrix.
constexpr double kStiffness = 1e-4;

// `auto` chooses the first of these, in whole groups, whose error over the samples is small enough. The error over the
// whole sky, scattered more than once, is little more.
constexpr std::array<int, 4> kAutomaticWavelengths{3, 6, 12, 24};
constexpr double kEnough = 0.004;
// Light of clouds is 2 to 9 % off in the mean by any wavelengths, and each group of these marches through them.
constexpr double kEnoughAmongClouds = 0.02;
// Light of terrain and spheres is 2 to 4 % off, and each group of wavelengths looks for them anew. Maps of colour are
// no part of the samples, and ask for more wavelengths.
constexpr double kEnoughAmongThings = 0.01;

double enough_for(const Scene& scene) {
  if (scene.render.method != "orders") {
    return kEnough;
  }
  const bool maps =
      (scene.terrain && !scene.terrain->albedo_map.empty()) || (scene.ground && !scene.ground->albedo_map.empty());
  const bool things = !maps && (scene.terrain || has_bodies(scene));
  return !scene.clouds.empty() ? kEnoughAmongClouds : things ? kEnoughAmongThings : kEnough;
}

// Fits nodes and matrix to the samples. Returns the error that remains.
double fit(ColourBasis& basis, SampledSky& sky, const BandColours& colours, int count) {
  basis.nodes = nodes_for(count);
  const std::vector<ColouredSpectrum> samples = sky.at(basis.nodes);
  basis.matrix = lit_matrix(fitted_matrix(samples, universal_matrix(basis.nodes, colours), basis.sun, kStiffness),
                            nearest_matrix(basis.nodes, colours));
  return mean_error(basis.matrix, samples);
}

}  // namespace

FitInputs::FitInputs(const Scene& scene, bool by_schlick)
    : media(scene.media),
      planet(scene.planet),
      spectra(*scene.spectra),
      schlick(by_schlick),
      sun_elevation(scene.sun.elevation),
      altitude(scene.camera.altitude),
      enough(enough_for(scene)) {}

ColourBasis fitted_basis(const Scene& scene, const Air& air) {
  assert(scene.spectra);
  const SceneSpectra& spectra = *scene.spectra;
  const BandColours colours = band_colours(spectra.sun, spectra.white);
  ColourBasis basis{.nodes = {}, .matrix = {}, .sun = sun_colour(colours)};
  if (spectra.wavelengths == kFineBands) {
    basis.nodes = nodes_for(kFineBands);
    basis.matrix = nearest_matrix(basis.nodes, colours);
    return basis;
  }
  SampledSky sky(scene, air, colours);
  if (spectra.wavelengths != 0) {
    fit(basis, sky, colours, spectra.wavelengths);
    return basis;
  }
  const double enough = enough_for(scene);
  for (const int count : kAutomaticWavelengths) {
    if (fit(basis, sky, colours, count) <= enough) {
      break;
    }
  }
  return basis;
}

ColourBasis basis_at(const SceneSpectra& spectra, const Nodes& nodes) {
  return {nodes, cell_matrix(nodes, spectra.sun, spectra.white), sun_colour(band_colours(spectra.sun, spectra.white))};
}

PartScenes::PartScenes(const Scene& scene, const ColourBasis& basis) : scene_(scene), basis_(basis) {
  if ((scene.terrain && !scene.terrain->albedo_map.empty()) || (scene.ground && !scene.ground->albedo_map.empty())) {
    primaries_ = reflectances_of_primaries(scene.spectra->sun, scene.spectra->white);
  }
}

std::array<std::size_t, 3> PartScenes::nodes(std::size_t part) const {
  const std::size_t last = basis_.nodes.nm.size() - 1;
  return {3 * part, std::min(3 * part + 1, last), std::min(3 * part + 2, last)};
}

std::array<Rgb, 3> PartScenes::colours(std::size_t part) const {
  std::array<Rgb, 3> colours{};
  for (std::size_t c = 0; c < 3 && 3 * part + c < basis_.nodes.nm.size(); ++c) {
    colours[c] = basis_.matrix[3 * part + c];
  }
  return colours;
}

Scene PartScenes::scene(std::size_t part) const {
  const Nodes& nodes = basis_.nodes;
  const std::array<std::size_t, 3> at = this->nodes(part);
  Scene group = scene_;
  const SceneSpectra& spectra = *scene_.spectra;
  for_each_spectral_value(group, [&](SpectralValue& value) {
    for (std::size_t c = 0; c < 3; ++c) {
      value[c] = at_node(value.curve, nodes, at[c]);
    }
  });
  for (std::size_t c = 0; c < 3; ++c) {
    for (Medium& medium : group.media) {
      medium.phase_wavelengths[c] = nodes.nm[at[c]];
    }
    if (group.planet.refraction) {
      group.planet.refraction->dispersion[c] = air_dispersion(nodes.nm[at[c]]);
    }
    for (std::size_t j = 0; j < 3 && group.terrain && !group.terrain->albedo_map.empty(); ++j) {
      group.terrain->mix[c][j] = at_node(primaries_[j], nodes, at[c]);
    }
    for (std::size_t j = 0; j < 3 && group.ground && !group.ground->albedo_map.empty(); ++j) {
      group.ground->mix[c][j] = at_node(primaries_[j], nodes, at[c]);
    }
    group.sun.irradiance[c] = spectra.irradiance * (spectra.light ? at_node(*spectra.light, nodes, at[c]) : 1.0);
    if (group.moon) {
      group.moon->irradiance[c] = spectra.irradiance * at_node(group.moon->over_sun, nodes, at[c]);
    }
  }
  group.spectra.reset();
  group.night_sky.reset();  // ready_part() puts it in
  group.stars.reset();
  return group;
}

}  // namespace airlight
