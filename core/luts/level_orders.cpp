#include "core/luts/level_orders.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/physics/gauss.h"

namespace airlight {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr int kNodes = 8;  // zenith cosines a hemisphere, dense at the horizon

double channel(const physics::vec3& v, std::size_t c) {
  return c == 0 ? v.x : c == 1 ? v.y : v.z;
}

// One shell of one channel.
struct Shell {
  double height = 0.0;
  double extinction = 0.0;
  std::array<double, 9> scattering = {};  // by degree
};

std::vector<Shell> shells_of(physics::Physics& p, std::size_t c) {
  std::vector<Shell> shells;
  for (physics::uint k = 0; k + 1 < p.shell_rows(); ++k) {
    const double low = p.shell_altitude(k);
    const double high = p.shell_altitude(k + 1);
    const auto air = p.diffuse_air_over(0.5 * (low + high), high - low, p.equal_phases(0.0));
    Shell shell{high - low, channel(air.extinction, c), {}};
    std::ranges::transform(air.degree, shell.scattering.begin(), [c](const physics::vec3& v) { return channel(v, c); });
    shells.push_back(shell);
  }
  return shells;
}

struct Matrix {
  explicit Matrix(std::size_t size) : n(size), values(size * size) {}
  double& operator()(std::size_t i, std::size_t j) { return values[i * n + j]; }
  double operator()(std::size_t i, std::size_t j) const { return values[i * n + j]; }
  std::size_t n;
  std::vector<double> values;
};

// (1 - a)^-1 - 1 by Gauss and Jordan; the diagonal dominates, as no order holds more light than the one before.
Matrix all_powers(const Matrix& a) {
  const std::size_t n = a.n;
  Matrix m(n);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      m(i, j) = (i == j ? 1.0 : 0.0) - a(i, j);
    }
  }
  for (std::size_t k = 0; k < n; ++k) {
    const double pivot = 1.0 / m(k, k);
    m(k, k) = 1.0;
    for (std::size_t j = 0; j < n; ++j) {
      m(k, j) *= pivot;
    }
    for (std::size_t i = 0; i < n; ++i) {
      const double factor = m(i, k);
      if (i == k || factor == 0.0) {
        continue;
      }
      m(i, k) = 0.0;
      for (std::size_t j = 0; j < n; ++j) {
        m(i, j) -= factor * m(k, j);
      }
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    m(i, i) -= 1.0;
  }
  return m;
}

// Light that reaches a row along one zenith cosine: of what each row's moments of degree l send, and of what leaves the
// ground.
struct Arrival {
  std::vector<std::array<double, 9>> from;  // by row
  double ground = 0.0;
};

Arrival arrival_at(physics::Physics& p, const std::vector<Shell>& shells, std::size_t row, double mu, bool upward) {
  Arrival arrival;
  arrival.from.resize(shells.size() + 1);
  double through = 1.0;
  const std::size_t count = upward ? shells.size() - row : row;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t k = upward ? row + i : row - 1 - i;
    const Shell& shell = shells[k];
    const double depth = shell.extinction * shell.height / mu;
    const double mean = through * p.mean_transmittance(depth) * shell.height / mu;
    const double far = p.source_place(depth);
    for (std::size_t l = 0; l < shell.scattering.size(); ++l) {
      arrival.from[upward ? k : k + 1][l] += mean * shell.scattering[l] * (1.0 - far);
      arrival.from[upward ? k + 1 : k][l] += mean * shell.scattering[l] * far;
    }
    through *= std::exp(-depth);
  }
  arrival.ground = upward ? 0.0 : through;
  return arrival;
}

// One order: from the moments of order m, l by l and row by row, and for m = 0 the ground's irradiance behind them.
std::vector<Matrix> one_order(physics::Physics& p, const std::vector<Shell>& shells, int degree, double albedo) {
  const std::size_t rows = shells.size() + 1;
  const auto harmonics = static_cast<std::size_t>(degree) + 1;
  std::vector<Matrix> by_mode;
  for (std::size_t m = 0; m < harmonics; ++m) {
    by_mode.emplace_back((harmonics - m) * rows + (m == 0 ? 1 : 0));
  }
  const std::size_t irradiance = harmonics * rows;
  const GaussRule gauss = gauss_legendre(kNodes);
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t node = 0; node < gauss.nodes.size(); ++node) {
      const double mu = gauss.nodes[node] * gauss.nodes[node];
      const double weight = 2.0 * gauss.nodes[node] * gauss.weights[node];
      for (const bool upward : {true, false}) {
        const Arrival arrival = arrival_at(p, shells, row, mu, upward);
        const auto y = p.harmonics(upward ? mu : -mu, 1.0);
        for (std::size_t m = 0; m < harmonics; ++m) {
          Matrix& a = by_mode[m];
          const double norm = weight * (m == 0 ? 2.0 * kPi : kPi);
          for (std::size_t to = m; to < harmonics; ++to) {
            const double taken = norm * y.of[to * (to + 1) / 2 + m];
            const std::size_t i = (to - m) * rows + row;
            for (std::size_t l = m; l < harmonics; ++l) {
              const double given = taken * y.of[l * (l + 1) / 2 + m];
              for (std::size_t k = 0; k < rows; ++k) {
                a(i, (l - m) * rows + k) += given * arrival.from[k][l];
              }
            }
            if (m == 0) {
              a(i, irradiance) += taken * arrival.ground * albedo / kPi;
            }
          }
        }
        if (row == 0 && upward) {
          for (std::size_t l = 0; l < harmonics; ++l) {
            const double given = weight * 2.0 * kPi * mu * y.of[l * (l + 1) / 2];
            for (std::size_t k = 0; k < rows; ++k) {
              by_mode[0](irradiance, l * rows + k) += given * arrival.from[k][l];
            }
          }
        }
      }
    }
  }
  return by_mode;
}

}  // namespace

std::size_t LevelShape::values() const {
  const auto r = static_cast<std::size_t>(rows);
  std::size_t sum = static_cast<std::size_t>(degree + 1) * r * 2 + 1;  // to and from the irradiance
  for (auto n = static_cast<std::size_t>(degree + 1); n > 0; --n) {
    sum += n * n * r * r;
  }
  return sum;
}

std::vector<float> level_orders(const Air& air, const LevelShape& shape, int table_degree, bool delta, double lost) {
  physics::Physics p = air.formulas();
  p.degree = static_cast<physics::uint>(table_degree);
  p.delta = delta;
  const auto rows = static_cast<std::size_t>(shape.rows);
  const auto harmonics = static_cast<std::size_t>(shape.degree) + 1;
  std::vector<float> values(3 * shape.values());
  for (std::size_t c = 0; c < 3; ++c) {
    std::size_t at = c;
    const auto put = [&](double value) {
      values[at] = static_cast<float>(value);
      at += 3;
    };
    std::vector<double> to_irradiance;
    std::vector<Matrix> orders = one_order(p, shells_of(p, c), shape.degree, air.planet().ground_albedo[c]);
    for (std::size_t m = 0; m < harmonics; ++m) {
      std::ranges::transform(orders[m].values, orders[m].values.begin(), [&](double v) { return v * (1.0 - lost); });
      const Matrix all = all_powers(orders[m]);
      for (std::size_t j = 0; j < all.n; ++j) {
        for (std::size_t i = 0; i < (harmonics - m) * rows; ++i) {
          put(all(i, j));
        }
        if (m == 0) {
          to_irradiance.push_back(all(all.n - 1, j));
        }
      }
    }
    std::ranges::for_each(to_irradiance, put);
  }
  return values;
}

}  // namespace airlight
