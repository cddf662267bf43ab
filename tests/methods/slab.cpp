#include "slab.h"

#include <cmath>
#include <numbers>
#include <utility>

#include "core/physics/gauss.h"

namespace airlight {
namespace {

// A small square matrix.
struct Matrix {
  explicit Matrix(std::size_t size) : n(size), values(size * size) {}
  double& operator()(std::size_t i, std::size_t j) { return values[i * n + j]; }
  double operator()(std::size_t i, std::size_t j) const { return values[i * n + j]; }
  std::size_t n;
  std::vector<double> values;
};

Matrix product(const Matrix& a, const Matrix& b) {
  Matrix c(a.n);
  for (std::size_t i = 0; i < a.n; ++i) {
    for (std::size_t k = 0; k < a.n; ++k) {
      for (std::size_t j = 0; j < a.n; ++j) {
        c(i, j) += a(i, k) * b(k, j);
      }
    }
  }
  return c;
}

Matrix sum(Matrix a, const Matrix& b) {
  for (std::size_t k = 0; k < a.values.size(); ++k) {
    a.values[k] += b.values[k];
  }
  return a;
}

// (1 - a)^-1 b by Gauss's elimination; the diagonal dominates.
Matrix bounced(const Matrix& a, Matrix b) {
  Matrix m(a.n);
  for (std::size_t i = 0; i < a.n; ++i) {
    for (std::size_t j = 0; j < a.n; ++j) {
      m(i, j) = (i == j ? 1.0 : 0.0) - a(i, j);
    }
  }
  for (std::size_t k = 0; k < a.n; ++k) {
    for (std::size_t i = 0; i < a.n; ++i) {
      if (i == k) {
        continue;
      }
      const double factor = m(i, k) / m(k, k);
      for (std::size_t j = 0; j < a.n; ++j) {
        m(i, j) -= factor * m(k, j);
        b(i, j) -= factor * b(k, j);
      }
    }
  }
  for (std::size_t i = 0; i < a.n; ++i) {
    for (std::size_t j = 0; j < a.n; ++j) {
      b(i, j) /= m(i, i);
    }
  }
  return b;
}

// sqrt((l-m)!/(l+m)!) P_l^m(x) for l = 0 .. count-1, by recurrence in l.
std::vector<double> legendre(int m, int count, double x) {
  std::vector<double> y(static_cast<std::size_t>(count));
  double diagonal = 1.0;
  for (int k = 1; k <= m; ++k) {
    diagonal *= std::sqrt((2.0 * k - 1.0) / (2.0 * k)) * std::sqrt(1.0 - x * x);
  }
  double before = 0.0;
  double value = diagonal;
  for (int l = m; l < count; ++l) {
    y[static_cast<std::size_t>(l)] = value;
    const double a = std::sqrt((l + 1.0) * (l + 1.0) - m * m);
    const double next = ((2.0 * l + 1.0) * x * value - std::sqrt(1.0 * l * l - 1.0 * m * m) * before) / a;
    before = value;
    value = next;
  }
  return y;
}

}  // namespace

std::vector<double> rayleigh_moments() {
  return {1.0, 0.0, 0.1};
}

std::vector<double> henyey_greenstein_moments(double g, int count) {
  std::vector<double> moments;
  for (int l = 0; l < count; ++l) {
    moments.push_back(std::pow(g, l));
  }
  return moments;
}

Slab::Slab(const SlabCase& slab, int nodes_per_hemisphere, int sun) {
  const GaussRule rule = gauss_legendre(nodes_per_hemisphere);
  nodes_ = rule.nodes;
  weights_ = rule.weights;
  const std::size_t n = nodes_.size();
  const int count = static_cast<int>(slab.moments.size());
  constexpr int kDoublings = 32;
  const double thin = std::ldexp(slab.optical_depth, -kDoublings);
  for (int m = 0; m < count; ++m) {
    Matrix reflect(n);
    Matrix transmit(n);
    std::vector<std::vector<double>> y;
    for (const double mu : nodes_) {
      y.push_back(legendre(m, count, mu));
    }
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) {
        double forward = 0.0;
        double back = 0.0;
        for (int l = m; l < count; ++l) {
          const auto k = static_cast<std::size_t>(l);
          const double term = (2.0 * l + 1.0) * slab.moments[k] * y[i][k] * y[j][k];
          forward += term;
          back += (l + m) % 2 == 0 ? term : -term;
        }
        const double scale = 0.5 * slab.single_scattering_albedo * weights_[j] * thin / nodes_[i];
        reflect(i, j) = scale * back;
        transmit(i, j) = scale * forward + (i == j ? 1.0 - thin / nodes_[i] : 0.0);
      }
    }
    for (int k = 0; k < kDoublings; ++k) {
      const Matrix between = bounced(product(reflect, reflect), transmit);
      reflect = sum(reflect, product(transmit, product(reflect, between)));
      transmit = product(transmit, between);
    }
    if (m == 0 && slab.ground_albedo > 0.0) {
      Matrix ground(n);
      for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < n; ++j) {
          ground(i, j) = 2.0 * slab.ground_albedo * nodes_[j] * weights_[j];
        }
      }
      const Matrix arrives = bounced(product(reflect, ground), transmit);
      reflect = sum(reflect, product(transmit, product(ground, arrives)));
      transmit = arrives;
    }
    // A beam of irradiance 1 is a radiance of (2 - delta_m0) / (2 pi w) in its node.
    const auto s = static_cast<std::size_t>(sun);
    const double beam = (m == 0 ? 1.0 : 2.0) / (2.0 * std::numbers::pi * weights_[s]);
    std::vector<double> up(n);
    std::vector<double> down(n);
    for (std::size_t i = 0; i < n; ++i) {
      up[i] = reflect(i, s) * beam;
      down[i] = (transmit(i, s) - (i == s ? std::exp(-slab.optical_depth / nodes_[s]) : 0.0)) * beam;
    }
    reflected_.push_back(std::move(up));
    transmitted_.push_back(std::move(down));
  }
}

double Slab::reflected(std::size_t i, double azimuth) const {
  double radiance = 0.0;
  for (std::size_t m = 0; m < reflected_.size(); ++m) {
    radiance += reflected_[m][i] * std::cos(static_cast<double>(m) * azimuth);
  }
  return radiance;
}

double Slab::transmitted(std::size_t i, double azimuth) const {
  double radiance = 0.0;
  for (std::size_t m = 0; m < transmitted_.size(); ++m) {
    radiance += transmitted_[m][i] * std::cos(static_cast<double>(m) * azimuth);
  }
  return radiance;
}

}  // namespace airlight
