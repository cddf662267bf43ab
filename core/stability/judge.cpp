#include "core/stability/judge.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/text.h"
#include "core/scene/angle.h"

namespace airlight::stability {
namespace {

using physics::vec3;

constexpr double kMostRounding = 0.003;    // mean relative: a tenth of what an eye tells apart
constexpr double kMostNarrowJump = 0.01;   // between directions a fortieth of a degree apart
constexpr double kMostJump = 0.05;         // between cells of the coarse sweeps
constexpr double kExplainedBySlope = 0.5;  // of the converged radiance's own change
constexpr double kMostEnergy = 1.01;       // the quadrature over the globe is good to less than 1 %
constexpr double kGlory = -0.9;            // asymmetry at least as sharp as this sends light back within a few degrees
constexpr double kLeastEnergy = 0.9;       // where nothing absorbs
constexpr double kMostBrightness = 2.0;    // air under one sun is never brighter than this, all round
constexpr double kFloor = 1e-3;
constexpr double kBlack = 1e-12;  // radiance under a sun of irradiance 1: starlight is brighter

double relative(double a, double b, double mean) {
  return std::abs(a - b) / std::max({b, kFloor * mean, kBlack});
}

bool black(double a, double b) {
  return std::max(std::abs(a), std::abs(b)) < kBlack;
}

double mean_of(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double v : values) {
    sum += v / static_cast<double>(values.size());
  }
  return sum;
}

std::string outside_claim(const Validity& validity, const Place& place) {
  if (place[Quantity::sun_elevation] < degrees_from_radians(validity.sun_elevation_min)) {
    return "claims nothing for a sun below " + rounded(degrees_from_radians(validity.sun_elevation_min), 4) +
           " degrees";
  }
  if (place[Quantity::altitude] > validity.altitude_max) {
    return "claims nothing above " + rounded(validity.altitude_max, 4) + " km";
  }
  if (place[Quantity::optical_depth] > validity.optical_depth_max) {
    return "claims nothing for optical depths above " + rounded(validity.optical_depth_max, 4);
  }
  return {};
}

double number_behind(const Cell& cell, char symptom) {
  switch (symptom) {
    case 'F':
      return cell.not_finite;
    case 'N':
      return cell.negative;
    case 'J':
      return cell.jump;
    case 'G':
      return std::isnan(cell.energy) ? cell.brightest : std::max(cell.energy, cell.brightest);
    case 'L':
      return cell.energy;
    case 'R':
      return cell.rounding;
    default:
      return cell.error;
  }
}

}  // namespace

std::string_view symptom_name(char letter) {
  const auto* const found =
      std::find_if(std::begin(kSymptoms), std::end(kSymptoms), [&](const Symptom& s) { return s.letter == letter; });
  return found == std::end(kSymptoms) ? std::string_view() : found->name;
}

void measure(Cell& cell, const std::vector<Look>& looks, double mean) {
  std::vector<double> errors;
  std::vector<double> roundings;
  for (const Look& look : looks) {
    for (std::size_t c = 0; c < 3; ++c) {
      const double asked = channel(look.asked, c);
      const double converged = channel(look.converged, c);
      const double exact = channel(look.in_double, c);
      if (!black(asked, converged)) {
        errors.push_back(relative(asked, converged, mean));
      }
      if (!std::isnan(exact) && !black(asked, exact)) {
        roundings.push_back(relative(asked, exact, mean));
      }
    }
  }
  const bool formulas = !looks.empty() && !std::isnan(looks.front().in_double.x);
  cell.error = mean_of(errors);
  cell.rounding = formulas ? mean_of(roundings) : std::numeric_limits<double>::quiet_NaN();
  std::sort(errors.begin(), errors.end());
  cell.error95 = errors.empty() ? 0.0 : errors[static_cast<std::size_t>(0.95 * static_cast<double>(errors.size() - 1))];
}

double jump_between(const std::vector<Look>& a, const std::vector<Look>& b, double mean) {
  double most = 0.0;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    for (std::size_t c = 0; c < 3; ++c) {
      const double asked = channel(b[i].asked, c) - channel(a[i].asked, c);
      const double converged = channel(b[i].converged, c) - channel(a[i].converged, c);
      const double scale =
          std::max({channel(a[i].converged, c), channel(b[i].converged, c), 10.0 * kFloor * mean, kBlack});
      const double unexplained = std::abs(asked - converged) - kExplainedBySlope * std::abs(converged);
      most = std::max(most, unexplained / scale);
    }
  }
  return most;
}

std::string symptoms_of(const Cell& cell, const Sweep& sweep, const Validity& validity) {
  std::string out;
  const auto add = [&](bool wrong, char letter) {
    if (wrong) {
      out += letter;
    }
  };
  add(cell.not_finite > 0, 'F');
  add(cell.negative > 0, 'N');
  add(cell.error > validity.error, 'E');
  add(cell.jump > (sweep.narrow ? kMostNarrowJump : std::max(kMostJump, 2.0 * validity.error)), 'J');
  add(cell.energy > kMostEnergy || cell.brightest > kMostBrightness, 'G');
  const bool keeps_all = (sweep.x == Quantity::optical_depth || sweep.y == Quantity::optical_depth) &&
                         !(sweep.x == Quantity::asymmetry && cell.x <= kGlory);
  add(keeps_all && cell.energy < kLeastEnergy, 'L');
  add(cell.rounding > kMostRounding, 'R');
  return out;
}

std::string explanation(const Subject& subject, const Place& place, char symptom) {
  const Validity& validity = subject.method->validity;
  const std::string outside = outside_claim(validity, place);
  if (!outside.empty()) {
    return outside;
  }
  for (const KnownFailure& known : validity.known_failures) {
    const bool here = std::all_of(known.where.begin(), known.where.end(), [&](const Limit& limit) {
      return place[limit.quantity] >= limit.minimum && place[limit.quantity] <= limit.maximum;
    });
    if (here && known.symptoms.find(symptom) != std::string_view::npos) {
      return std::string(known.cause);
    }
  }
  return {};
}

std::vector<Region> regions(const Block& block, const Sweep& sweep, const Subject& subject) {
  const std::size_t width = sweep.xs.size();
  std::vector<Region> list;
  for (const Symptom& symptom : kSymptoms) {
    std::vector<std::string> causes(block.cells.size());
    std::vector<bool> waiting(block.cells.size());
    for (std::size_t i = 0; i < block.cells.size(); ++i) {
      waiting[i] = block.cells[i].symptoms.find(symptom.letter) != std::string::npos;
      causes[i] = waiting[i] ? explanation(subject, place_of(sweep, i % width, i / width), symptom.letter) : "";
    }
    for (std::size_t first = 0; first < block.cells.size(); ++first) {
      if (!waiting[first]) {
        continue;
      }
      const Cell& seed = block.cells[first];
      Region region{block.subject, block.sweep, symptom.letter, causes[first], 0,  block.cells.size(),
                    seed.x,        seed.x,      seed.y,         seed.y,        0.0};
      region.worst = number_behind(seed, symptom.letter);
      std::vector<std::size_t> stack{first};
      waiting[first] = false;
      while (!stack.empty()) {
        const std::size_t i = stack.back();
        stack.pop_back();
        const Cell& cell = block.cells[i];
        ++region.cells;
        region.x_low = std::min(region.x_low, cell.x);
        region.x_high = std::max(region.x_high, cell.x);
        region.y_low = std::min(region.y_low, cell.y);
        region.y_high = std::max(region.y_high, cell.y);
        const double number = number_behind(cell, symptom.letter);
        region.worst = symptom.letter == 'L' ? std::min(region.worst, number) : std::max(region.worst, number);
        const auto visit = [&](bool inside, std::size_t j) {
          if (inside && waiting[j] && causes[j] == region.cause) {
            waiting[j] = false;
            stack.push_back(j);
          }
        };
        visit(i % width > 0, i - 1);
        visit(i % width + 1 < width, i + 1);
        visit(i >= width, i - width);
        visit(i + width < block.cells.size(), i + width);
      }
      list.push_back(region);
    }
  }
  return list;
}

}  // namespace airlight::stability
