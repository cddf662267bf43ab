#include "core/clouds/cloud_phase.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/air/scene_block.h"
#include "core/base/in_parallel.h"
#include "core/clouds/cloud_physics.h"

namespace airlight {
namespace {

using physics::vec3;

constexpr int kMostDegree = 1500;   // a peak of a fifth of a degree
constexpr double kNoMoment = 1e-5;  // the last moment that matters: thousands of them add up straight on
constexpr int kAngles = 4096;       // of the moments' integrals
// All orders of small turns are taken for one in whole up to the first angle, and not at all beyond the second: light
// that has turned by more has not gone along the sun's ray, which the formula takes for granted.
constexpr double kTurnedWhole = 60.0 / 180.0 * std::numbers::pi;
constexpr double kTurnedNot = 90.0 / 180.0 * std::numbers::pi;

// The angle at x of 0 to 1, dense in the peak.
double peak_angle(double x) {
  return std::numbers::pi * x * x;
}

// Legendre polynomials of one cosine, degree by degree.
class Polynomials {
 public:
  explicit Polynomials(double mu) : mu_(mu) {}
  double value() const { return now_; }
  void next() {
    const double after = ((2 * degree_ + 1) * mu_ * now_ - degree_ * before_) / (degree_ + 1);
    before_ = now_;
    now_ = after;
    ++degree_;
  }

 private:
  double mu_;
  int degree_ = 0;
  double before_ = 0.0;
  double now_ = 1.0;
};

double turned_share(double angle) {
  const double t = std::clamp((kTurnedNot - angle) / (kTurnedNot - kTurnedWhole), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

// Moments of the phase function from 0 on, up to the last that matters; the integral is made 1.
std::vector<vec3> peak_moments(physics::Physics& p) {
  constexpr std::size_t kBlocks = 32;  // of angles, each summed by itself
  std::vector<vec3> weights(kAngles);
  for (int i = 0; i < kAngles; ++i) {
    const double x = (i + 0.5) / kAngles;
    const double angle = peak_angle(x);
    const double width = 2.0 * std::numbers::pi * x / kAngles;
    weights[static_cast<std::size_t>(i)] =
        p.medium_phase(0, std::cos(angle)) * (2.0 * std::numbers::pi * std::sin(angle) * width);
  }
  std::vector<std::vector<vec3>> sums(kBlocks, std::vector<vec3>(kMostDegree + 1, vec3(0.0)));
  in_parallel(kBlocks, [&](std::size_t block) {
    for (std::size_t i = block * kAngles / kBlocks; i < (block + 1) * kAngles / kBlocks; ++i) {
      Polynomials legendre(std::cos(peak_angle((static_cast<double>(i) + 0.5) / kAngles)));
      for (vec3& moment : sums[block]) {
        moment = moment + weights[i] * legendre.value();
        legendre.next();
      }
    }
  });
  std::vector<vec3> moments(kMostDegree + 1, vec3(0.0));
  for (const std::vector<vec3>& part : sums) {
    for (std::size_t l = 0; l < moments.size(); ++l) moments[l] = moments[l] + part[l];
  }
  const vec3 whole = moments.front();
  std::ranges::for_each(moments, [&](vec3& moment) { moment = moment / whole; });
  while (moments.size() > 1 &&
         std::max({std::abs(moments.back().x), std::abs(moments.back().y), std::abs(moments.back().z)}) < kNoMoment) {
    moments.pop_back();
  }
  return moments;
}

}  // namespace

std::vector<device::vec3> cloud_phase_rows(physics::Physics& p, double single_scattering_albedo, int degree) {
  physics::CloudPhysics cloud;
  const std::vector<vec3> moments = peak_moments(p);
  const double peak = physics::channel_mean(p.scene.media[0].legendre[degree + 1]);
  const double scale = 1.0 - single_scattering_albedo * peak;
  constexpr std::size_t kRows = physics::kCloudPeakRows;
  std::vector<device::vec3> values(kRows * physics::kPhaseSamples);
  // By how much moments at each depth differ from the phase function's, times (2 l + 1) / 4 pi. Where the sun's light
  // has been met by m (albedo times depth), all orders of small turns together leave exp(-(1 - chi_l) m) of its moment
  // l [GS40], over what counts as unscattered, exp(-(1 - f) m) with f the peak: exp(-(f - chi_l) m). Light that has
  // turned at all is this less the same for all l, here exp(-f m); over m it is chi_l where m is small. The field
  // scatters moments up to `degree` further, so of them one order stands here, chi_l - f, and the same constant.
  std::vector<vec3> gains(kRows * moments.size());
  for (std::size_t row = 0; row < kRows; ++row) {
    const double met = single_scattering_albedo * cloud.peak_table_depth(static_cast<double>(row)) / scale;
    const double unscattered = std::exp(-peak * met);
    const auto of_all_orders = [&](double chi) { return met > 0.0 ? unscattered * std::expm1(chi * met) / met : chi; };
    for (std::size_t l = 0; l < moments.size(); ++l) {
      const double share = (2.0 * static_cast<double>(l) + 1.0) / (4.0 * std::numbers::pi);
      const vec3& chi = moments[l];
      const vec3 all(of_all_orders(chi.x), of_all_orders(chi.y), of_all_orders(chi.z));
      const bool goes_on = l <= static_cast<std::size_t>(degree);
      gains[row * moments.size() + l] = (goes_on ? vec3(of_all_orders(peak) - peak) : all - chi) * share;
    }
  }
  std::vector<vec3> wholes(physics::kPhaseSamples);
  for (std::size_t i = 0; i < wholes.size(); ++i) {
    wholes[i] = p.medium_phase(0, std::cos(peak_angle(static_cast<double>(i) / (physics::kPhaseSamples - 1))));
  }
  in_parallel(wholes.size(), [&](std::size_t i) {
    const double angle = peak_angle(static_cast<double>(i) / (physics::kPhaseSamples - 1));
    const double turned = turned_share(angle);
    std::vector<vec3> sums(kRows, wholes[i]);
    Polynomials legendre(std::cos(angle));
    for (std::size_t l = 0; l < moments.size() && turned > 0.0; ++l) {
      for (std::size_t row = 0; row < kRows; ++row) {
        sums[row] = sums[row] + gains[row * moments.size() + l] * (legendre.value() * turned);
      }
      legendre.next();
    }
    for (std::size_t row = 0; row < kRows; ++row) {
      const vec3 value = physics::max(sums[row], vec3(0.0)) * (single_scattering_albedo / scale);
      values[row * physics::kPhaseSamples + i] = narrowed(value);
    }
  });
  return values;
}

}  // namespace airlight
