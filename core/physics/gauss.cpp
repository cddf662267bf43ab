#include "core/physics/gauss.h"

#include <cmath>
#include <numbers>

namespace airlight {
namespace {

struct Legendre {
  double value;
  double derivative;
};

// P_n by its recurrence.
Legendre legendre(int n, double x) {
  double before = 1.0;
  double value = x;
  for (int j = 2; j <= n; ++j) {
    const double next = ((2 * j - 1) * x * value - (j - 1) * before) / j;
    before = value;
    value = next;
  }
  return {value, n * (x * value - before) / (x * x - 1.0)};
}

}  // namespace

GaussRule gauss_legendre(int n) {
  GaussRule rule;
  for (int i = 0; i < n; ++i) {
    double x = -std::cos(std::numbers::pi * (i + 0.75) / (n + 0.5));
    for (int step = 0; step < 20; ++step) {
      const Legendre p = legendre(n, x);
      x -= p.value / p.derivative;
    }
    const double slope = legendre(n, x).derivative;
    rule.nodes.push_back(0.5 * (1.0 + x));
    rule.weights.push_back(1.0 / ((1.0 - x * x) * slope * slope));
  }
  return rule;
}

GaussRule gauss_falling(int n) {
  GaussRule rule = gauss_legendre(n);
  for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
    const double y = rule.nodes[i];
    rule.nodes[i] = y / (2.0 - y);
    rule.weights[i] *= 2.0 / ((2.0 - y) * (2.0 - y));
  }
  return rule;
}

}  // namespace airlight
