#include <algorithm>
#include <map>

#include "core/base/text.h"
#include "core/scene/density_column.h"
#include "core/scene/json_format.h"
#include "core/scene/json_text.h"
#include "core/scene/phase_reader.h"
#include "core/scene/printable.h"
#include "core/scene/readers.h"

namespace airlight {
namespace {

// One [altitude, density] pair after the one before it.
void read_layer(const Site& layers, std::size_t index, std::vector<DensityLayer>& out) {
  const PresetValue& value = std::get<PresetArray>(layers.value.data)[index];
  const std::string pointer = pointer_below(layers.pointer, std::to_string(index));
  const auto* pair = std::get_if<PresetArray>(&value.data);
  if (pair == nullptr || pair->size() != 2) {
    layers.problems.add(value, pointer, quoted(value) + " is not a layer; expected [altitude_km, density]");
    return;
  }
  const Rule altitude{.key = {}, .range = kLayerAltitude, .unit = "km"};
  DensityLayer layer;
  read_number({layers.problems, (*pair)[0], pointer_below(pointer, "0"), altitude}, layer.altitude);
  read_number({layers.problems, (*pair)[1], pointer_below(pointer, "1"), layers.rule}, layer.density);
  if (!out.empty() && layer.altitude <= out.back().altitude) {
    layers.problems.add((*pair)[0], pointer_below(pointer, "0"),
                        format_number(layer.altitude) + " is not above the layer before it (" +
                            format_number(out.back().altitude) + " km); expected ascending altitudes");
  }
  out.push_back(layer);
}

std::vector<DensityLayer> read_layers(const Section& density) {
  const PresetValue* value = density.value_of("layers");
  if (value == nullptr) {
    return {};
  }
  const Site site = density.site("layers", *value);
  const auto* array = std::get_if<PresetArray>(&value->data);
  if (array == nullptr || array->empty()) {
    site.complain((array == nullptr ? quoted(*value) + " is not an array" : "empty") + "; expected " +
                  expectation(site.rule));
    return {};
  }
  std::vector<DensityLayer> layers;
  for (std::size_t i = 0; i < array->size(); ++i) {
    read_layer(site, i, layers);
  }
  return layers;
}

Density read_density(const Section& medium) {
  Section section = medium.child("density");
  section.refuse_unknown_keys();
  const auto profile = section.choice("profile");
  Density density;
  if (!profile) {
    return density;
  }
  section.choose(kProfileNames[*profile]);
  section.fill(density);
  if (density.profile == DensityProfile::layers) {
    density.layers = read_layers(section);
  }
  return density;
}

Medium read_medium(const Section& section, double top) {
  section.refuse_unknown_keys();
  Medium medium;
  section.fill(medium);
  medium.density = read_density(section);
  medium.absorption = section.curves().read(section, "absorption_per_km", density_column(medium.density, top));
  read_phase(section.child("phase"), medium);
  return medium;
}

// Refuses opaque media by their optical depth; called only where all their numbers are within their ranges.
void refuse_opaque(const PresetArray& array, const std::vector<Medium>& media, double top, Problems& problems) {
  for (std::size_t i = 0; i < media.size(); ++i) {
    const double column = column_km(media[i].density, top);
    double depth = optical_depth_of(media[i], top);
    for (const WaveBand& band : fine_bands()) {
      const double here = mean_over(media[i].scattering.curve, band.low, band.high) +
                          mean_over(media[i].absorption.curve, band.low, band.high);
      depth = std::max(depth, here * column);
    }
    if (depth > kMostOpticalDepth) {
      problems.add(array[i], "/media/" + std::to_string(i),
                   "its vertical optical depth is " + rounded(depth, 3) + "; expected at most " +
                       format_number(kMostOpticalDepth) + ": lower its coefficients, its density or its height");
    }
  }
}

}  // namespace

std::vector<Medium> read_media(const Section& root, const Planet& planet) {
  const PresetValue* value = root.find("media");
  if (value == nullptr) {
    root.problems().add(root.context(), "/media",
                        "missing; expected an array of 1 to 8 media: write \"media\": [...] or build on a preset that "
                        "has it, e.g. \"extends\": \"earth\"");
    return {};
  }
  const PresetArray* array = root.list("media", *value, "media");
  if (array == nullptr) {
    return {};
  }
  std::vector<Medium> media;
  std::map<std::string, std::size_t, std::less<>> seen;
  std::size_t layer_count = 0;
  for (std::size_t i = 0; i < array->size(); ++i) {
    const Section section = root.element("media", *array, i);
    media.push_back(read_medium(section, planet.atmosphere_height));
    const std::string& name = media.back().name;
    const auto [first, is_new] = seen.emplace(name, i);
    if (!name.empty() && !is_new) {
      section.complain("name", *section.find("name"),
                       quoted_text(name) + " is taken by /media/" + std::to_string(first->second) +
                           "; expected a name of its own for each medium");
    }
    layer_count += media.back().density.layers.size();
  }
  if (layer_count > static_cast<std::size_t>(kMaxDensityLayers)) {
    root.complain("media", *value,
                  std::to_string(layer_count) + " density layers in all; expected at most " +
                      std::to_string(kMaxDensityLayers) + " over all media");
  }
  if (!root.problems().any()) {
    refuse_opaque(*array, media, planet.atmosphere_height, root.problems());
  }
  return media;
}

}  // namespace airlight
