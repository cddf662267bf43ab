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
// The peak's spreading is taken in whole up to the first angle, and not at all beyond the second: light that has turned
// by more has not gone along the sun's ray, which the formula takes for granted.
constexpr double kSpreadWhole = 6.0 / 180.0 * std::numbers::pi;
constexpr double kSpreadNot = 16.0 / 180.0 * std::numbers::pi;

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

double spread_share(double angle) {
  const double t = std::clamp((kSpreadNot - angle) / (kSpreadNot - kSpreadWhole), 0.0, 1.0);
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
  const vec3& first = p.scene.media[0].legendre[degree + 1];
  const double peak = (first.x + first.y + first.z) / 3.0;
  const double scale = 1.0 - single_scattering_albedo * peak;
  constexpr std::size_t kRows = physics::kCloudPeakRows;
  std::vector<device::vec3> values(kRows * physics::kPhaseSamples);
  // What each moment has lost at each depth, times (2 l + 1) / 4 pi.
  std::vector<vec3> lost(kRows * moments.size(), vec3(0.0));
  for (std::size_t row = 0; row < kRows; ++row) {
    const double depth = cloud.peak_table_depth(static_cast<double>(row)) / scale;
    for (std::size_t l = static_cast<std::size_t>(degree) + 1; l < moments.size(); ++l) {
      const vec3 rate = (vec3(peak) - moments[l]) * single_scattering_albedo;
      const double share = (2.0 * static_cast<double>(l) + 1.0) / (4.0 * std::numbers::pi);
      lost[row * moments.size() + l] = moments[l] * share * (physics::exp(rate * -depth) - vec3(1.0));
    }
  }
  std::vector<vec3> wholes(physics::kPhaseSamples);
  for (std::size_t i = 0; i < wholes.size(); ++i) {
    wholes[i] = p.medium_phase(0, std::cos(peak_angle(static_cast<double>(i) / (physics::kPhaseSamples - 1))));
  }
  in_parallel(wholes.size(), [&](std::size_t i) {
    const double angle = peak_angle(static_cast<double>(i) / (physics::kPhaseSamples - 1));
    const double spread = spread_share(angle);
    std::vector<vec3> sums(kRows, wholes[i]);
    Polynomials legendre(std::cos(angle));
    for (std::size_t l = 0; l < moments.size() && spread > 0.0; ++l) {
      for (std::size_t row = 0; row < kRows; ++row) {
        sums[row] = sums[row] + lost[row * moments.size() + l] * (legendre.value() * spread);
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
