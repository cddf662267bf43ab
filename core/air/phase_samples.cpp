#include "core/air/phase_samples.h"

#include <array>
#include <cmath>
#include <numbers>

#include "core/scene/angle.h"

namespace airlight {
namespace {

using physics::vec3;

constexpr std::size_t kSamples = physics::kPhaseSamples;

double angle_of(double place) {
  const double x = place / (kSamples - 1);
  return std::numbers::pi * x * x;
}

// Calls visit(k, cosine, weight) at Gauss-Legendre nodes of each interval; the weights' sum is 4 pi.
template <class Visit>
void for_each_node(Visit visit) {
  constexpr std::array<double, 4> kNodes{-0.8611363115940526, -0.3399810435848563, 0.3399810435848563,
                                         0.8611363115940526};
  constexpr std::array<double, 4> kWeights{0.3478548451374538, 0.6521451548625461, 0.6521451548625461,
                                           0.3478548451374538};
  for (std::size_t k = 0; k + 1 < kSamples; ++k) {
    for (std::size_t i = 0; i < kNodes.size(); ++i) {
      const double share = 0.5 + 0.5 * kNodes[i];
      const double place = static_cast<double>(k) + share;
      const double angle = angle_of(place);
      const double width = 2.0 * std::numbers::pi * place / ((kSamples - 1.0) * (kSamples - 1.0));
      visit(k, share, angle, 2.0 * std::numbers::pi * std::sin(angle) * width * 0.5 * kWeights[i]);
    }
  }
}

vec3 between(const std::vector<vec3>& samples, std::size_t at, double share) {
  return exp(samples[at] * (1.0 - share) + samples[at + 1] * share);
}

constexpr std::size_t kGatherDegrees = 16;

// How much of a moment is left where few directions gather light: all of the low ones, none from kGatherDegrees on,
// which 16 azimuths do not tell from others.
double kept_of(std::size_t degree) {
  constexpr double kWhole = 4.0;
  const double x = (static_cast<double>(degree) - kWhole) / (kGatherDegrees - kWhole);
  return x <= 0.0 ? 1.0 : 0.5 + 0.5 * std::cos(std::numbers::pi * x);
}

// Divides the table of logarithms that begins there by its integral.
void normalise(std::vector<vec3>& samples, std::size_t first) {
  vec3 norm(0.0);
  for_each_node([&](std::size_t k, double share, double, double weight) {
    norm = norm + between(samples, first + k, share) * weight;
  });
  for (std::size_t k = first; k < first + kSamples; ++k) {
    samples[k] = samples[k] - log(norm);
  }
}

// Behind the table that begins there, the same for those who gather light.
void add_gathered(std::vector<vec3>& samples, std::size_t first) {
  std::array<vec3, kGatherDegrees> moments{};
  for_each_node([&](std::size_t k, double share, double angle, double weight) {
    const vec3 value = between(samples, first + k, share) * weight;
    for_each_polynomial(kGatherDegrees, std::cos(angle),
                        [&](std::size_t l, double p) { moments[l] = moments[l] + value * p; });
  });
  constexpr double kLeast = 1e-3;  // the series undershoots a little beside a sharp peak
  for (std::size_t k = 0; k < kSamples; ++k) {
    vec3 sum(0.0);
    for_each_polynomial(kGatherDegrees, sample_cosine(k), [&](std::size_t l, double p) {
      sum = sum + moments[l] * (kept_of(l) * p * (2.0 * static_cast<double>(l) + 1.0) / (4.0 * std::numbers::pi));
    });
    samples.push_back(log(max(sum, vec3(kLeast))));
  }
  normalise(samples, first + kSamples);
}

}  // namespace

bool is_sharp(const Medium& medium) {
  constexpr double kSharp = 0.85;
  return phase_row(medium.phase).is_peaked_by_g() && std::abs(medium.phase_g) > kSharp;
}

bool has_samples(const Medium& medium) {
  return medium.phase == PhaseFunction::table || is_sharp(medium);
}

std::shared_ptr<const std::vector<vec3>> phase_samples(const std::vector<Medium>& media) {
  auto all = std::make_shared<std::vector<vec3>>();
  physics::Physics p;
  for (const Medium& medium : media) {
    if (!has_samples(medium)) {
      continue;
    }
    const std::size_t first = all->size();
    for (std::size_t k = 0; k < kSamples; ++k) {
      const auto value = [&](std::size_t c) {
        const double degrees = angle_of(static_cast<double>(k)) / kDegree;
        return std::log(medium.phase == PhaseFunction::table
                            ? phase_at(medium.phase_table, medium.phase_wavelengths[c], degrees)
                            : p.phase_value(phase_row(medium.phase).code, medium.phase_g, sample_cosine(k)));
      };
      all->emplace_back(value(0), value(1), value(2));
    }
    normalise(*all, first);
    add_gathered(*all, first);
  }
  return all->empty() ? nullptr : all;
}

std::array<std::vector<double>, 4> interval_shares(const physics::Physics& p, physics::uint table) {
  std::array<std::vector<double>, 4> shares;
  shares.fill(std::vector<double>(kSamples - 1));
  for_each_node([&](std::size_t k, double share, double, double weight) {
    const vec3 value = between(*p.phase_samples, 2 * table * kSamples + k, share) * weight;
    for (std::size_t c = 0; c < 3; ++c) {
      shares[c][k] += channel(value, c);
    }
    shares[3][k] += channel_mean(value);
  });
  return shares;
}

double sample_cosine(std::size_t k) {
  return std::cos(angle_of(static_cast<double>(k)));
}

LegendreMoments table_moments(const physics::Physics& p, physics::uint table) {
  LegendreMoments moments{};
  for_each_node([&](std::size_t k, double share, double angle, double weight) {
    const vec3 value = between(*p.phase_samples, 2 * table * kSamples + k, share) * weight;
    add_moments(moments, value, std::cos(angle));
  });
  return moments;
}

}  // namespace airlight
