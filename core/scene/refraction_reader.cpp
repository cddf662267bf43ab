#include <algorithm>
#include <string>

#include "core/base/text.h"
#include "core/scene/density_profiles.h"
#include "core/scene/json_format.h"
#include "core/scene/readers.h"
#include "core/scene/refractive_index.h"
#include "core/spectra/colour.h"
#include "core/spectra/data.h"

namespace airlight {
namespace {

// Whether there is one.
bool read_profile(const Section& planet, const Section& section, const std::vector<Medium>& media,
                  Refraction& refraction) {
  const PresetValue* medium = section.find("medium");
  const PresetValue* height = section.find("scale_height_km");
  if (medium != nullptr && height != nullptr && medium->inherited != height->inherited) {
    (medium->inherited ? medium : height) = nullptr;  // a preset's own says more than what it extends
  }
  if ((medium == nullptr) == (height == nullptr)) {
    planet.complain("refraction", *planet.find("refraction"),
                    "expected exactly one of medium and scale_height_km, by which n - 1 falls with altitude");
    return false;
  }
  if (medium == nullptr) {
    refraction.density.scale_height = section.number("scale_height_km");
    return refraction.density.scale_height > 0.0;
  }
  if (media.empty()) {  // of which the reader of the media tells
    return false;
  }
  const std::string name = section.text("medium");
  const auto found = std::ranges::find(media, name, &Medium::name);
  if (found == media.end()) {
    std::string names;
    for (const Medium& m : media) {
      names += (names.empty() ? "" : ", ") + m.name;
    }
    section.complain("medium", *medium,
                     "no medium has this name; expected one of " + names + ", or scale_height_km in its place");
  } else if (profile_row(found->density.profile).ends_abruptly) {
    section.complain("medium", *medium, "its density ends at once; expected a medium that thins out smoothly");
  } else {
    refraction.medium = name;
    refraction.density = found->density;
    return true;
  }
  return false;
}

// Refuses air in which a ray could circle the planet.
void refuse_ducts(const Section& planet, const Planet& on) {
  constexpr double kLeast = 0.05;
  constexpr int kPlaces = 200;
  RefractiveIndex index(on);
  for (int i = 0; i <= kPlaces; ++i) {
    const double u = static_cast<double>(i) / kPlaces;
    const double h = on.atmosphere_height * u * u;
    if (const double k = index.curvature(h); !(k > kLeast)) {
      planet.complain("refraction", *planet.find("refraction"),
                      "a level ray at " + format_number(h) + " km is bent by " + rounded(1.0 - k, 3) +
                          " of the planet's curvature; expected at most 0.95: give a smaller n_minus_1 or a greater "
                          "scale height");
      return;
    }
  }
}

}  // namespace

std::optional<Refraction> read_refraction(const Section& planet, const Planet& on, const std::vector<Medium>& media) {
  if (planet.find("refraction") == nullptr) {
    return std::nullopt;
  }
  const Section section = planet.child("refraction");
  section.refuse_unknown_keys();
  Refraction refraction;
  section.fill(refraction);
  const bool falls = read_profile(planet, section, media, refraction);
  // Red, green and blue are taken at the wavelengths that stand for them in a scene of spectra.
  const Nodes nodes = nodes_for(3);
  for (std::size_t c = 0; c < 3; ++c) {
    refraction.dispersion[c] = air_dispersion(nodes.nm[2 - c]);
  }
  if (falls) {
    Planet bending = on;
    bending.refraction = refraction;
    refuse_ducts(planet, bending);
  }
  return refraction.n_minus_1 > 0.0 ? std::optional(refraction) : std::nullopt;
}

}  // namespace airlight
