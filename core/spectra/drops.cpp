#include "core/spectra/drops.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <deque>
#include <functional>
#include <mutex>
#include <numbers>
#include <utility>

#include "core/base/in_parallel.h"
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

constexpr std::size_t kAngles = kHalf + 1;

// pi_n and tau_n at the angles of half_angle(), angle by angle for each n from 1.
struct AngularFunctions {
  explicit AngularFunctions(std::size_t orders) : pi(orders * kAngles), tau(orders * kAngles) {
    for (std::size_t k = 0; k < kAngles; ++k) {
      const double mu = std::cos(half_angle(k) * kDegree);
      double before = 0.0;
      double here = 1.0;
      for (std::size_t n = 1; n <= orders; ++n) {
        const double order = static_cast<double>(n);
        pi[(n - 1) * kAngles + k] = here;
        tau[(n - 1) * kAngles + k] = order * mu * here - (order + 1.0) * before;
        const double next = ((2.0 * order + 1.0) * mu * here - (order + 1.0) * before) / order;
        before = std::exchange(here, next);
      }
    }
  }
  std::vector<double> pi;
  std::vector<double> tau;
};

// |S1|^2 + |S2|^2 summed over spheres, at the angles of half_angle() and at their supplements, where pi_n has the sign
// (-1)^(n - 1) and tau_n (-1)^n.
class Amplitudes {
 public:
  void add(const AngularFunctions& functions, const MieSeries& series, double weight) {
    for (auto& lists : sums_) {
      for (auto& list : lists) list.fill(0.0);
    }
    for (std::size_t n = 1; n <= series.a.size(); ++n) {
      const double order = static_cast<double>(n);
      const double factor = (2.0 * order + 1.0) / (order * (order + 1.0));
      const std::size_t row = (n - 1) * kAngles;
      add_order(sums_[n % 2], &functions.pi[row], &functions.tau[row], series.a[n - 1] * factor,
                series.b[n - 1] * factor);
    }
    for (std::size_t k = 0; k < kAngles; ++k) {
      // a pi + b tau and a tau + b pi, real and imaginary parts; `sign` of the sums over even n.
      const auto square = [&](std::size_t first, std::size_t second, double sign) {
        const auto sum = [&](std::size_t i) { return sums_[1][i][k] + sign * sums_[0][i][k]; };
        const auto turned = [&](std::size_t i) { return sign * sums_[1][i][k] + sums_[0][i][k]; };
        const double value = sum(first) + turned(second);
        return value * value;
      };
      const auto all = [&](double sign) {
        return square(0, 2, sign) + square(1, 3, sign) + square(6, 4, sign) + square(7, 5, sign);
      };
      forward[k] += weight * all(1.0);
      backward[k] += weight * all(-1.0);
    }
  }

  void add(const Amplitudes& other) {
    std::ranges::transform(forward, other.forward, forward.begin(), std::plus());
    std::ranges::transform(backward, other.backward, backward.begin(), std::plus());
  }

  std::array<double, kAngles> forward{};
  std::array<double, kAngles> backward{};

 private:
  // a pi, b tau, a tau, b pi: real and imaginary parts.
  using Sums = std::array<std::array<double, kAngles>, 8>;

  static void add_order(Sums& sums, const double* pi, const double* tau, Complex a, Complex b) {
    const double ar = a.real();
    const double ai = a.imag();
    const double br = b.real();
    const double bi = b.imag();
    for (std::size_t k = 0; k < kAngles; ++k) {
      sums[0][k] += ar * pi[k];
      sums[1][k] += ai * pi[k];
      sums[2][k] += br * tau[k];
      sums[3][k] += bi * tau[k];
      sums[4][k] += ar * tau[k];
      sums[5][k] += ai * tau[k];
      sums[6][k] += br * pi[k];
      sums[7][k] += bi * pi[k];
    }
  }

  std::array<Sums, 2> sums_{};  // of even and of odd n
};

constexpr double kLargest = 3.2;  // radius over the effective radius; beyond it is 1e-4 of the scattering
constexpr int kRadii = 320;

// One row for each size: circumference of the effective radius over wavelength, and refractive index.
std::vector<std::vector<double>> rows_of(const std::vector<std::pair<double, double>>& sizes) {
  constexpr std::size_t kBlocks = 8;  // of radii
  const double largest = kLargest * std::ranges::max(sizes).first;
  const AngularFunctions functions(static_cast<std::size_t>(largest + 4.0 * std::cbrt(largest) + 3.0));
  std::vector<Amplitudes> sums(sizes.size() * kBlocks);
  in_parallel(sums.size(), [&](std::size_t task) {
    const auto& [size, m] = sizes[task / kBlocks];
    for (std::size_t i = task % kBlocks; i < kRadii; i += kBlocks) {
      const double share = kLargest * (static_cast<double>(i) + 0.5) / kRadii;  // of the effective radius
      const double spread = std::pow(share, 1.0 / kDropVariance - 3.0) * std::exp(-share / kDropVariance);
      sums[task].add(functions, mie_series(share * size, m), spread);
    }
  });
  std::vector<std::vector<double>> rows;
  for (std::size_t first = 0; first < sums.size(); first += kBlocks) {
    for (std::size_t block = 1; block < kBlocks; ++block) sums[first].add(sums[first + block]);
    const Amplitudes& sum = sums[first];
    rows.emplace_back(sum.forward.begin(), sum.forward.end());
    rows.back().insert(rows.back().end(), sum.backward.rbegin() + 1, sum.backward.rend());
  }
  return rows;
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
  constexpr double kNanometres = 1e3;  // a um
  std::vector<std::pair<double, double>> sizes;
  for (const double nm : wavelengths_nm) {
    sizes.emplace_back(2.0 * std::numbers::pi * kNanometres / nm * effective_radius, m > 0.0 ? m : water_index(nm));
  }
  table.rows = rows_of(sizes);
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const double integral = sphere_integral(table, i);
    for (double& value : table.rows[i]) value /= integral;
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
