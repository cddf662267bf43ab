#include "core/methods/march_steps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string>

#include "core/physics/physics.h"
#include "core/scene/density_profiles.h"
#include "core/scene/parameters.h"

namespace airlight {
namespace {

constexpr std::string_view kAutomatic = "auto";
// In the order of the codes physics::kStepsUniform, ...; the last stands for none of them.
constexpr std::array<std::string_view, 4> kDistributions{"uniform", "quadratic", "gauss-legendre", kAutomatic};

constexpr std::string_view kWhere =
    "where the steps along the view ray stand: evenly; dense toward the ray's lowest point; or two Gauss-Legendre "
    "nodes "
    "a panel, panels split at the planet's shadow";

double mean(const Spectrum& s) {
  return std::accumulate(s.begin(), s.end(), 0.0) / static_cast<double>(s.size());
}

double extinction(const Medium& medium) {
  return mean(medium.scattering) + mean(medium.absorption);
}

// Whether no medium of account has an edge or a kink: a panel of two nodes resolves neither. The kinks of ozone by
// layers do not matter.
bool is_smooth(const Air& air) {
  constexpr double kScattering = 0.01;  // vertical optical depths
  constexpr double kAbsorption = 0.1;
  for (std::size_t i = 0; i < air.media().size(); ++i) {
    const Medium& medium = air.media()[i];
    const bool smooth = profile_row(medium.density.profile).is_smooth();
    const double amount = air.column().amount[i];
    if (!smooth && (amount * *std::ranges::max_element(medium.scattering) > kScattering ||
                    amount * *std::ranges::max_element(medium.absorption) > kAbsorption)) {
      return false;
    }
  }
  return true;
}

// Optical depth of a ray as long as a level one from the ground, through air everywhere as dense as at its densest;
// mean of the channels.
double level_depth(const Air& air) {
  double most = 0.0;
  for (const Column::PerMedium& density : air.column().density) {
    double here = 0.0;
    for (std::size_t i = 0; i < air.media().size(); ++i) {
      here += density[i] * extinction(air.media()[i]);
    }
    most = std::max(most, here);
  }
  const Planet& planet = air.planet();
  return most * std::sqrt(planet.atmosphere_height * (2.0 * planet.ground_radius + planet.atmosphere_height));
}

// Whether all visible ground lies in daylight: in dusk light falls by a factor within a panel.
bool sees_day_alone(const Scene& scene) {
  const double radius = scene.planet.ground_radius;
  const double h = std::max(scene.camera.altitude, 0.0);
  return scene.sun.elevation >= std::atan2(std::sqrt(h * (2.0 * radius + h)), radius);
}

// Whether a tenth of the air or more is above the camera: from higher up, rays graze air that is thin next to a panel.
bool is_below_the_air(const Part& part) {
  constexpr double kShareAbove = 0.1;
  const Column& column = part.air.column();
  const auto above = std::ranges::lower_bound(column.edges, part.scene.camera.altitude);
  if (above == column.edges.end()) {
    return false;
  }
  const double all = column.depth.back();
  return all - column.depth[static_cast<std::size_t>(above - column.edges.begin())] >= kShareAbove * all;
}

// The number of nodes, two a panel, that gives the first panel of a level ray an optical depth of at most 1.1; panels
// grow with the square of their number. At least 14 nodes; none where they would cost as much as the usual steps.
int panel_nodes_for(const Part& part) {
  constexpr double kFewestPanels = 7.0;
  constexpr double kMostPanels = 12.0;
  constexpr double kPanelDepth = 1.1;
  if (!is_smooth(part.air) || !sees_day_alone(part.scene) || !is_below_the_air(part)) {
    return 0;
  }
  const double panels = std::max(std::ceil(std::sqrt(level_depth(part.air) / kPanelDepth)), kFewestPanels);
  return panels <= kMostPanels ? 2 * static_cast<int>(panels) : 0;
}

}  // namespace

ParameterInfo steps_parameter(int default_steps) {
  return parameter::whole_number("steps", 1, 4096, default_steps, "steps along the view ray");
}

ParameterInfo automatic_steps_parameter() {
  return parameter::whole_number("steps", 0, 4096, 0,
                                 "steps along the view ray; 0: 32, or with an automatic step_distribution of nodes as "
                                 "many as the air needs, 14 to 24");
}

ParameterInfo step_distribution_parameter() {
  return parameter::choice("step_distribution", std::span(kDistributions).first(3), "quadratic", kWhere);
}

ParameterInfo automatic_distribution_parameter() {
  return parameter::choice(
      "step_distribution", kDistributions, kAutomatic,
      "where the steps along the view ray stand: evenly; dense toward the ray's lowest point (quadratic); or two "
      "Gauss-Legendre nodes a panel, panels split at the planet's shadow. auto: nodes by day in air that is smooth and "
      "not too thick for 24 of them, where neither steps nor jitter are set; else quadratic");
}

bool steps_are_automatic(const RenderSettings& settings) {
  const auto is = [&](std::string_view key, const ParameterValue& value) {
    const auto found = settings.parameters.find(key);
    return found != settings.parameters.end() && found->second == value;
  };
  return is("steps", 0) && is("step_distribution", std::string(kAutomatic)) && is("jitter", std::string("none"));
}

MarchSteps march_steps(const Part& part) {
  if (steps_are_automatic(part.scene.render)) {
    if (const int nodes = panel_nodes_for(part); nodes > 0) {
      return {nodes, physics::kStepsGaussLegendre};
    }
  }
  const int wished = part.scene.render.get<int>("steps");
  return {wished > 0 ? wished : kUsualSteps, step_distribution_code(part.scene)};
}

std::uint32_t step_distribution_code(const Scene& scene) {
  const std::string& name = scene.render.get<std::string>("step_distribution");
  const auto code = static_cast<std::uint32_t>(std::ranges::find(kDistributions, name) - kDistributions.begin());
  return name == kAutomatic ? physics::kStepsQuadratic : code;
}

void write_steps(RenderSettings& settings, const MarchSteps& steps) {
  settings.parameters.insert_or_assign("steps", steps.count);
  settings.parameters.insert_or_assign("step_distribution", std::string(kDistributions[steps.distribution]));
}

}  // namespace airlight
