#include "core/scene/cloud_layer.h"

#include <algorithm>
#include <cmath>

#include "core/scene/density_column.h"
#include "core/scene/json_format.h"
#include "core/spectra/drops.h"

namespace airlight {
namespace {

constexpr double kEdge = 0.02;  // of the height, over which an even layer begins and ends
constexpr int kPieces = 12;     // of straight density, of a layer that thins out

void blame_layer(const Section& section, std::string_view key, const std::string& message) {
  const PresetValue* value = section.find(key);
  section.complain(key, value == nullptr ? section.context() : *value, message);
}

// From base to top; a layer that stands on the ground has no lower edge.
Density layer_density(double base, double top, double scale_height) {
  Density density;
  density.profile = DensityProfile::layers;
  const double edge = kEdge * (top - base);
  const double low = base > 0.0 ? base + edge : 0.0;
  if (base > 0.0) {
    density.layers.push_back({base, 0.0});
  }
  const int pieces = scale_height > 0.0 ? kPieces : 1;
  const double high = top - edge;
  for (int k = 0; k <= pieces; ++k) {
    const double h = low + (high - low) * k / pieces;
    density.layers.push_back({h, scale_height > 0.0 ? std::exp(-(h - low) / scale_height) : 1.0});
  }
  density.layers.push_back({top, 0.0});
  return density;
}

// Straight up, from base to top.
double read_depth(const Section& section) {
  const PresetValue* depth = section.find("optical_depth");
  const PresetValue* water = section.find("water_g_per_m2");
  if (depth != nullptr && water != nullptr) {
    section.complain("water_g_per_m2", *water, "`optical_depth` says the same in another way; give one of the two");
  }
  if (depth == nullptr && water == nullptr) {
    blame_layer(section, "optical_depth", "missing for \"layer\"; give it or water_g_per_m2");
    return 0.0;
  }
  constexpr double kGramsOverKm = 1e-3;  // g/m3 that are 1 g/m2 over a km
  return depth != nullptr
             ? section.number("optical_depth")
             : drop_extinction(section.number("water_g_per_m2") * kGramsOverKm, section.number("effective_radius_um"));
}

}  // namespace

Medium read_cloud_layer(const Section& section, const Planet& planet, const Cloud& matter) {
  Medium medium;
  const std::size_t before = section.problems().count();
  const double base = section.number("base_km");
  const double top = section.number("top_km");
  const bool sound = section.problems().count() == before;
  const double depth = read_depth(section);
  if (!sound) {
    return medium;  // defaults stand for what is wrong
  }
  if (!(top > base)) {
    blame_layer(section, "top_km",
                format_number(top) + " km is not above base_km, " + format_number(base) +
                    " km; lower the base or raise the top");
    return medium;
  }
  if (top > planet.atmosphere_height) {
    blame_layer(section, "top_km",
                "the cloud reaches from " + format_number(base) + " to " + format_number(top) +
                    " km; expected within the air, 0 to planet.atmosphere_height_km, " +
                    format_number(planet.atmosphere_height));
  }
  const double scale_height = section.find("scale_height_km") == nullptr ? 0.0 : section.number("scale_height_km");
  medium.density = layer_density(base, top, scale_height);
  const double extinction = depth / column_km(medium.density, planet.atmosphere_height);
  medium.scattering.fill(matter.single_scattering_albedo * extinction);
  medium.absorption.fill((1.0 - matter.single_scattering_albedo) * extinction);
  medium.phase = PhaseFunction::henyey_greenstein;
  medium.phase_g = matter.phase_g;
  if (matter.phase == CloudPhase::drops) {
    medium.phase = PhaseFunction::table;
    medium.effective_radius = matter.effective_radius;
    medium.phase_table = drops_phase(matter.effective_radius);
    medium.phase_wavelengths = kDropChannels;
  }
  return medium;
}

}  // namespace airlight
