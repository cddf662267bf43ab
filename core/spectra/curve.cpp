#include "core/spectra/curve.h"

#include <algorithm>
#include <cmath>

namespace airlight {

Curve constant_curve(double value) {
  Curve curve;
  curve.value = value;
  return curve;
}

double value_at(const Curve& curve, double nm) {
  if (!curve.is_sampled()) {
    return curve.exponent == 0.0 ? curve.value : curve.value * std::pow(nm / curve.at_nm, curve.exponent);
  }
  const std::vector<double>& x = curve.wavelengths;
  const auto after = static_cast<std::size_t>(std::upper_bound(x.begin(), x.end(), nm) - x.begin());
  if (after == 0) {
    return curve.values.front();
  }
  if (after == x.size()) {
    return curve.values.back();
  }
  const double t = (nm - x[after - 1]) / (x[after] - x[after - 1]);
  return curve.values[after - 1] + t * (curve.values[after] - curve.values[after - 1]);
}

double mean_over(const Curve& curve, double low, double high) {
  if (!(high > low)) {
    return value_at(curve, low);
  }
  if (!curve.is_sampled()) {
    const double middle = value_at(curve, 0.5 * (low + high));
    return (value_at(curve, low) + 4.0 * middle + value_at(curve, high)) / 6.0;
  }
  double sum = 0.0;
  double from = low;
  double value_from = value_at(curve, low);
  const auto add_to = [&](double to) {
    const double value_to = value_at(curve, to);
    sum += 0.5 * (value_from + value_to) * (to - from);
    from = to;
    value_from = value_to;
  };
  for (const double x : curve.wavelengths) {
    if (x > low && x < high) {
      add_to(x);
    }
  }
  add_to(high);
  return sum / (high - low);
}

Curve scaled(Curve curve, double factor) {
  for (double& value : curve.values) {
    value *= factor;
  }
  curve.value *= factor;
  return curve;
}

}  // namespace airlight
