#pragma once
// A quantity over the wavelength, as a preset gives it. Wavelengths in nm.

#include <string>
#include <vector>

namespace airlight {

// Linear between samples, constant outside them. Without samples it is the power law value (nm / at_nm)^exponent, a
// plain number where the exponent is 0.
struct Curve {
  std::vector<double> wavelengths = {};  // ascending
  std::vector<double> values = {};       // as many
  double at_nm = 550.0;
  double value = 0.0;
  double exponent = 0.0;
  // The preset's JSON for this curve; empty: a number, or the samples.
  std::string json = {};

  bool is_sampled() const { return !wavelengths.empty(); }
  bool operator==(const Curve&) const = default;
};

Curve constant_curve(double value);

double value_at(const Curve& curve, double nm);

// The mean from `low` to `high`: exact for samples, by Simpson's rule for a power law.
double mean_over(const Curve& curve, double low, double high);

// The curve times a number.
Curve scaled(Curve curve, double factor);

}  // namespace airlight
