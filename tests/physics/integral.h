#pragma once
// Quadrature for closed forms, unlike the rules of the shaders.

#include <array>
#include <cstddef>
#include <numbers>

namespace airlight::test {

// Gauss-Legendre with 8 points, exact to degree 15 (Abramowitz and Stegun, table 25.4).
template <class F>
double gauss(const F& f, double a, double b) {
  constexpr std::array<double, 4> kNodes{0.1834346424956498, 0.5255324099163290, 0.7966664774136267,
                                         0.9602898564975363};
  constexpr std::array<double, 4> kWeights{0.3626837833783620, 0.3137066458778873, 0.2223810344533745,
                                           0.1012285362903763};
  const double middle = 0.5 * (a + b);
  const double half = 0.5 * (b - a);
  double sum = 0.0;
  for (std::size_t i = 0; i < kNodes.size(); ++i) {
    sum += kWeights[i] * (f(middle - half * kNodes[i]) + f(middle + half * kNodes[i]));
  }
  return half * sum;
}

template <class F>
double integral(const F& f, double a, double b, int panels) {
  double sum = 0.0;
  for (int i = 0; i < panels; ++i) {
    sum += gauss(f, a + (b - a) * i / panels, a + (b - a) * (i + 1) / panels);
  }
  return sum;
}

// Integral over the sphere of a function of the cosine to an axis. The panels halve toward both poles, where peaks are.
template <class F>
double sphere_integral(const F& f) {
  double sum = 0.0;
  double high = 1.0;
  for (int i = 0; i < 60; ++i) {
    const double low = i == 59 ? 0.0 : 0.5 * high;
    sum += gauss([&](double x) { return f(1.0 - x) + f(x - 1.0); }, low, high);
    high = low;
  }
  return 2.0 * std::numbers::pi * sum;
}

}  // namespace airlight::test
