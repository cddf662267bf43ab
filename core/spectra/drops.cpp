#include "core/spectra/drops.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <deque>
#include <mutex>
#include <numbers>
#include <utility>

#include "core/scene/angle.h"

namespace airlight {
namespace {

using Complex = std::complex<double>;

// a_n and b_n of one sphere, n from 1 [Bohren and Huffman, eqs. 4.88 and 4.89].
struct MieSeries {
  std::vector<Complex> a;
  std::vector<Complex> b;
};

MieSeries mie_series(double x, double m) {
  const auto count = static_cast<std::size_t>(x + 4.0 * std::cbrt(x) + 2.0);
  const auto deepest = std::max(count, static_cast<std::size_t>(m * x)) + 16;
  // The logarithmic derivative is stable downward, the Riccati-Bessel functions upward.
  std::vector<double> derivative(deepest + 1, 0.0);
  for (std::size_t n = deepest; n > 0; --n) {
    const double share = static_cast<double>(n) / (m * x);
    derivative[n - 1] = share - 1.0 / (derivative[n] + share);
  }
  MieSeries series;
  double psi_before = std::cos(x);
  double psi = std::sin(x);
  double chi_before = -std::sin(x);
  double chi = std::cos(x);
  for (std::size_t n = 1; n <= count; ++n) {
    const double order = static_cast<double>(n);
    const double psi_next = (2.0 * order - 1.0) / x * psi - psi_before;
    const double chi_next = (2.0 * order - 1.0) / x * chi - chi_before;
    const Complex xi(psi, -chi);
    const Complex xi_next(psi_next, -chi_next);
    const double ta = derivative[n] / m + order / x;
    const double tb = derivative[n] * m + order / x;
    series.a.push_back((ta * psi_next - psi) / (ta * xi_next - xi));
    series.b.push_back((tb * psi_next - psi) / (tb * xi_next - xi));
    psi_before = std::exchange(psi, psi_next);
    chi_before = std::exchange(chi, chi_next);
  }
  return series;
}

constexpr std::size_t kHalf = 256;  // intervals from 0 to 90 degrees, denser toward the peak

double half_angle(std::size_t k) {
  const double share = static_cast<double>(k) / kHalf;
  return 90.0 * share * std::sqrt(share);
}

// |S1|^2 + |S2|^2 summed over spheres, at the angles of half_angle() and at their supplements.
class Amplitudes {
 public:
  explicit Amplitudes(std::size_t orders) : pi_(orders * kAngles), tau_(orders * kAngles) {
    std::array<double, kAngles> before{};
    std::array<double, kAngles> here;
    here.fill(1.0);
    for (std::size_t n = 1; n <= orders; ++n) {
      const double order = static_cast<double>(n);
      for (std::size_t k = 0; k < kAngles; ++k) {
        const double mu = std::cos(half_angle(k) * kDegree);
        pi_[(n - 1) * kAngles + k] = here[k];
        tau_[(n - 1) * kAngles + k] = order * mu * here[k] - (order + 1.0) * before[k];
        const double next = ((2.0 * order + 1.0) * mu * here[k] - (order + 1.0) * before[k]) / order;
        before[k] = std::exchange(here[k], next);
      }
    }
  }

  void add(const MieSeries& series, double weight) {
    for (auto& list : sums_) {
      list.fill(0.0);
    }
    for (std::size_t n = 1; n <= series.a.size(); ++n) {
      const double order = static_cast<double>(n);
      const double factor = (2.0 * order + 1.0) / (order * (order + 1.0));
      add_order(n, series.a[n - 1] * factor, series.b[n - 1] * factor);
    }
    for (std::size_t k = 0; k < kAngles; ++k) {
      const auto square = [&](std::size_t i) { return sums_[i][k] * sums_[i][k]; };
      forward[k] += weight * (square(0) + square(1) + square(2) + square(3));
      backward[k] += weight * (square(4) + square(5) + square(6) + square(7));
    }
  }

  static constexpr std::size_t kAngles = kHalf + 1;
  std::array<double, kAngles> forward{};
  std::array<double, kAngles> backward{};

 private:
  // At the supplement pi_n has the sign (-1)^(n - 1) and tau_n (-1)^n.
  void add_order(std::size_t n, Complex a, Complex b) {
    const double sign = n % 2 == 1 ? 1.0 : -1.0;
    const double* pi = &pi_[(n - 1) * kAngles];
    const double* tau = &tau_[(n - 1) * kAngles];
    const double ar = a.real();
    const double ai = a.imag();
    const double br = b.real();
    const double bi = b.imag();
    for (std::size_t k = 0; k < kAngles; ++k) {
      sums_[0][k] += ar * pi[k] + br * tau[k];
      sums_[1][k] += ai * pi[k] + bi * tau[k];
      sums_[2][k] += ar * tau[k] + br * pi[k];
      sums_[3][k] += ai * tau[k] + bi * pi[k];
      sums_[4][k] += sign * (ar * pi[k] - br * tau[k]);
      sums_[5][k] += sign * (ai * pi[k] - bi * tau[k]);
      sums_[6][k] += sign * (br * pi[k] - ar * tau[k]);
      sums_[7][k] += sign * (bi * pi[k] - ai * tau[k]);
    }
  }

  std::vector<double> pi_;
  std::vector<double> tau_;
  std::array<std::array<double, kAngles>, 8> sums_{};
};

constexpr double kLargest = 3.2;  // radius over the effective radius; beyond it is 1e-4 of the scattering
constexpr int kRadii = 320;

std::vector<double> row_of(double effective_radius, double nm, double m) {
  constexpr double kNanometres = 1e3;  // a um
  const double wave_number = 2.0 * std::numbers::pi * kNanometres / nm;
  const double largest = kLargest * effective_radius * wave_number;
  Amplitudes sum(static_cast<std::size_t>(largest + 4.0 * std::cbrt(largest) + 3.0));
  for (int i = 0; i < kRadii; ++i) {
    const double share = kLargest * (i + 0.5) / kRadii;  // of the effective radius
    const double spread = std::pow(share, 1.0 / kDropVariance - 3.0) * std::exp(-share / kDropVariance);
    sum.add(mie_series(share * effective_radius * wave_number, m), spread);
  }
  std::vector<double> row(sum.forward.begin(), sum.forward.end());
  row.insert(row.end(), sum.backward.rbegin() + 1, sum.backward.rend());
  return row;
}

}  // namespace

double water_index(double nm) {
  const double square = nm * nm * 1e-6;  // um^2
  constexpr std::array<std::array<double, 2>, 4> kTerms{{{5.684027565e-1, 5.101829712e-3},
                                                         {1.726177391e-1, 1.821153936e-2},
                                                         {2.086189578e-2, 2.620722293e-2},
                                                         {1.130748688e-1, 1.069792721e1}}};
  double sum = 1.0;
  for (const auto& [strength, place] : kTerms) {
    sum += strength * square / (square - place);
  }
  constexpr double kAir = 1.00027;  // the sum is that of the index against vacuum
  return std::sqrt(sum) / kAir;
}

double drop_extinction(double water, double radius) {
  constexpr double kPerKm = 1e3;
  return kPerKm * 1.5 * water / radius;
}

double crystal_extinction(double water, double radius) {
  constexpr double kIce = 0.917;  // g/cm3
  return drop_extinction(water, radius) / kIce;
}

MieEfficiencies mie_efficiencies(double x, double m) {
  const MieSeries series = mie_series(x, m);
  double scattering = 0.0;
  double forward = 0.0;
  for (std::size_t k = 0; k < series.a.size(); ++k) {
    const double n = static_cast<double>(k + 1);
    const Complex a = series.a[k];
    const Complex b = series.b[k];
    scattering += (2.0 * n + 1.0) * (std::norm(a) + std::norm(b));
    forward += (2.0 * n + 1.0) / (n * (n + 1.0)) * (a * std::conj(b)).real();
    if (k + 1 < series.a.size()) {
      forward += n * (n + 2.0) / (n + 1.0) * (a * std::conj(series.a[k + 1]) + b * std::conj(series.b[k + 1])).real();
    }
  }
  return {2.0 / (x * x) * scattering, 2.0 * forward / scattering};
}

PhaseTable drops_table(double effective_radius, const std::vector<double>& wavelengths_nm, double m) {
  PhaseTable table;
  for (std::size_t k = 0; k <= kHalf; ++k) {
    table.angles_deg.push_back(half_angle(k));
  }
  for (std::size_t k = kHalf; k-- > 0;) {
    table.angles_deg.push_back(180.0 - half_angle(k));
  }
  table.wavelengths_nm = wavelengths_nm;
  for (const double nm : wavelengths_nm) {
    table.rows.push_back(row_of(effective_radius, nm, m > 0.0 ? m : water_index(nm)));
    std::vector<double>& row = table.rows.back();
    const double integral = sphere_integral(table, table.rows.size() - 1);
    for (double& value : row) {
      value /= integral;
    }
  }
  if (wavelengths_nm.size() == 1) {
    table.wavelengths_nm.clear();
  }
  return table;
}

PhaseTable drops_phase(double effective_radius) {
  constexpr std::size_t kMost = 8;
  static std::mutex mutex;
  static std::deque<std::pair<double, PhaseTable>> known;
  const std::lock_guard lock(mutex);
  const auto same = [&](const auto& entry) { return entry.first == effective_radius; };
  if (const auto found = std::ranges::find_if(known, same); found != known.end()) {
    return found->second;
  }
  if (known.size() == kMost) {
    known.pop_front();
  }
  known.emplace_back(effective_radius, drops_table(effective_radius, {430.0, 490.0, 550.0, 610.0, 670.0}));
  return known.back().second;
}

}  // namespace airlight
