// Draws from a plan: the panel or surface that a path goes to, and the place in it.

#include <algorithm>
#include <cmath>

#include "core/methods/path_trace/flight.h"
#include "core/methods/path_trace/random.h"

namespace airlight {
namespace {

double weigh(const Channels& weight, const Channels& share) {
  return weight[0] * share[0] + weight[1] * share[1] + weight[2] * share[2];
}

// A place in one panel, by the channel's exponential with linear extinction over the panel. u in [0, 1).
double place_in(const FlightPlan::Panel& panel, std::size_t channel, double u) {
  const double enter = panel.enter[channel];
  const double slope = (panel.leave[channel] - enter) / panel.width;
  const double collides = -std::expm1(-0.5 * (enter + panel.leave[channel]) * panel.width);
  const double depth = -std::log1p(-u * collides);
  const double divisor = enter + std::sqrt(std::max(enter * enter + 2.0 * slope * depth, 0.0));
  return divisor > 0.0 ? std::min(2.0 * depth / divisor, panel.width) : 0.0;
}

// Density of that choice at x, 1/km.
double density_in(const FlightPlan::Panel& panel, std::size_t channel, double x) {
  const double enter = panel.enter[channel];
  const double slope = (panel.leave[channel] - enter) / panel.width;
  const double collides = -std::expm1(-0.5 * (enter + panel.leave[channel]) * panel.width);
  return (enter + slope * x) * std::exp(-(enter + 0.5 * slope * x) * x) / collides;
}

}  // namespace

Collision Flight::choose(const FlightPlan& plan, const Channels& weight, double u) {
  const double ground = weigh(weight, plan.ground);
  const double total = weigh(weight, plan.total);
  if (!(total > 0.0)) {
    return {};
  }
  double left = u * total;
  if (left < ground) {
    return {true, true, plan.length, ground / total};
  }
  if (!(total > ground)) {
    return {true, true, plan.length, 1.0};
  }
  left -= ground;
  const auto weight_of = [&](std::size_t j) { return weigh(weight, plan.panels[j].share); };
  const std::size_t k = draw(plan.panels.size(), weight_of, left);
  const FlightPlan::Panel& panel = plan.panels[k];
  Channels part;
  for (std::size_t c = 0; c < 3; ++c) {
    part[c] = weight[c] * panel.share[c];
  }
  left *= part[0] + part[1] + part[2];
  const auto part_of = [&](std::size_t c) { return part[c]; };
  const std::size_t channel = draw(3, part_of, left);
  const double x = place_in(panel, channel, left);
  double density = 0.0;
  for (std::size_t c = 0; c < 3; ++c) {
    if (part[c] > 0.0) {
      density += part[c] * density_in(panel, c, x);
    }
  }
  return {density > 0.0, false, panel.start + x, density / total};
}

}  // namespace airlight
