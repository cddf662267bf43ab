#include "core/spectra/phase_table.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/scene/angle.h"

namespace airlight {
namespace {

constexpr double kSmallest = 1e-9;

double log_of(double value) {
  return std::log(std::max(value, kSmallest));
}

// The place of x in an ascending list: between k and k + 1, at this fraction of the way.
struct Place {
  std::size_t k = 0;
  double share = 0.0;
};

Place place_in(const std::vector<double>& list, double x) {
  if (list.size() < 2) {
    return {};
  }
  const auto after = std::upper_bound(list.begin() + 1, list.end() - 1, x);
  const auto k = static_cast<std::size_t>(after - list.begin() - 1);
  return {k, std::clamp((x - list[k]) / (list[k + 1] - list[k]), 0.0, 1.0)};
}

double log_in_row(const std::vector<double>& row, const Place& angle) {
  return log_of(row[angle.k]) * (1.0 - angle.share) + log_of(row[angle.k + 1]) * angle.share;
}

}  // namespace

double phase_at(const PhaseTable& table, double nm, double angle_deg) {
  const Place angle = place_in(table.angles_deg, angle_deg);
  const Place wavelength = place_in(table.wavelengths_nm, nm);
  const double below = log_in_row(table.rows[wavelength.k], angle);
  if (table.rows.size() == 1) {
    return std::exp(below);
  }
  return std::exp(below * (1.0 - wavelength.share) +
                  log_in_row(table.rows[wavelength.k + 1], angle) * wavelength.share);
}

// The antiderivative of p sin t with p = exp(a + b t) is p (b sin t - cos t) / (1 + b^2).
double sphere_integral(const PhaseTable& table, std::size_t row) {
  const std::vector<double>& values = table.rows[row];
  double sum = 0.0;
  for (std::size_t k = 0; k + 1 < values.size(); ++k) {
    const double from = table.angles_deg[k] * kDegree;
    const double to = table.angles_deg[k + 1] * kDegree;
    const double b = (log_of(values[k + 1]) - log_of(values[k])) / (to - from);
    const auto at = [&](double value, double t) {
      return std::max(value, kSmallest) * (b * std::sin(t) - std::cos(t)) / (1.0 + b * b);
    };
    sum += at(values[k + 1], to) - at(values[k], from);
  }
  return 2.0 * std::numbers::pi * sum;
}

}  // namespace airlight
