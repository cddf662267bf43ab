#pragma once
// All wavelengths of a scene on one path. The path is chosen for three channels that represent the wavelengths, by the
// sum of the three contributions: the balance heuristic over their densities (Veach and Guibas 1995; Wilkie et al. 2014
// for spectra). The contribution of every wavelength is divided by the density of that choice.

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "core/methods/path_trace/analyser.h"
#include "core/methods/path_trace/optical_depth.h"
#include "core/methods/path_trace/things_trace.h"
#include "core/stage/stage.h"

namespace airlight {

// One number for each wavelength; entries beyond the scene's wavelengths stay 0.
struct Wide {
  alignas(32) std::array<double, kMostWavelengths> at{};

  Wide() = default;
  explicit Wide(double value) { at.fill(value); }
};

template <class Operation>
Wide each(const Wide& a, const Wide& b, Operation operation) {
  Wide out;
  for (std::size_t k = 0; k < out.at.size(); ++k) {
    out.at[k] = operation(a.at[k], b.at[k]);
  }
  return out;
}

inline Wide operator+(const Wide& a, const Wide& b) {
  return each(a, b, [](double x, double y) { return x + y; });
}
inline Wide operator-(const Wide& a, const Wide& b) {
  return each(a, b, [](double x, double y) { return x - y; });
}
inline Wide operator*(const Wide& a, const Wide& b) {
  return each(a, b, [](double x, double y) { return x * y; });
}
inline Wide operator*(const Wide& a, double b) {
  return each(a, a, [b](double x, double) { return x * b; });
}
inline Wide share_of(const Wide& part, const Wide& whole) {
  return each(part, whole, [](double a, double b) { return share_of(a, b); });
}
inline Wide absolute(const Wide& a) {
  return each(a, a, [](double x, double) { return std::abs(x); });
}
inline bool within(const Wide& error, const Wide& limit) {
  bool all = true;
  for (std::size_t k = 0; k < error.at.size(); ++k) {
    all = all && error.at[k] <= limit.at[k];
  }
  return all;
}

class Wavelengths {
 public:
  explicit Wavelengths(const Stage& stage);

  // Three channels whose coefficients are means over all wavelengths, weighted by each one's share of red,
  // green and blue. Whatever scatters or reflects at any wavelength does so in one of the channels.
  const Part& steering() const { return steering_; }

  // Each medium's phase function at a cosine of the scattering angle, 1/sr.
  using Phases = std::array<Wide, physics::kMaxMedia>;
  Phases phases(double nu) const;

  // Coefficient times phase function, 1/(km sr), for media of these densities.
  Wide scattered(const Columns& densities, const Phases& phases) const;
  Wide scattered(const Columns& densities, double nu) const;

  // Coefficient of the molecules that polarise, as of Physics::dipole_scattering(); nothing where none does.
  std::optional<Wide> dipoles(const Columns& densities) const;

  // exp(-optical depth) of such columns.
  Wide transmittance(const Columns& columns) const;

  // Albedo of a thing at a place from the planet's centre.
  Wide thing_albedo(const TracedThings& things, physics::vec3 place, ThingNumber thing) const;

  // A value of formulas in three wavelengths, at all of them. `value`: takes physics::Physics&, returns a vec3.
  template <class F>
  Wide of_groups(const F& value) const {
    Wide all;
    for (std::size_t g = 0; g < groups_.size(); ++g) {
      const physics::vec3 three = value(groups_[g]);
      const std::array<double, 3> values{three.x, three.y, three.z};
      for (std::size_t c = 0; c < 3 && 3 * g + c < count_; ++c) {
        all.at[3 * g + c] = values[c];
      }
    }
    return all;
  }

  // The picture's colour of a radiance that is relative to the sun's.
  physics::vec3 colour(const Wide& radiance) const;

 private:
  std::size_t count_;
  std::size_t media_;
  Part steering_;
  std::array<Wide, physics::kMaxMedia> scattering_;  // 1/km at density 1
  std::array<Wide, physics::kMaxMedia> extinction_;
  std::array<std::optional<Wide>, physics::kMaxMedia> dipoles_;  // of molecules that polarise, at density 1
  std::vector<Rgb> colours_;
  mutable std::vector<physics::Physics> groups_;       // of three wavelengths each; GLSL's functions have no const
  std::array<bool, physics::kMaxMedia> same_phase_{};  // at all wavelengths
};

// The light that the wavelengths carry along one path after another, over the densities of the path's choices.
class WidePath {
 public:
  explicit WidePath(const Wavelengths& all) : all_(all) {}

  const Wavelengths& wavelengths() const { return all_; }

  void begin(double q);  // q: of the analyser
  // Moves to the next vertex, through these columns, chosen with this density.
  void fly(const Columns& columns, double density);
  // Turns into a direction chosen with this density, 1/sr: in air, or at the ground (`cosine` over pi).
  void scatter(const Columns& densities, const Bend& bend, double density);
  void reflect(const Wide& albedo, double cosine, double density);
  // Multiplies the path's weight, to make up for paths that ended.
  void survive(double factor);
  // Adds sunlight that comes through these columns and is scattered or reflected back along the path.
  void add_scattered(const Columns& to_sun, const Columns& densities, const Bend& bend);
  void add_reflected(const Columns& to_sun, const Wide& albedo, double cosine);

  void take_sum(const WidePath& branch) { sum_ = branch.sum_; }  // of a copy that went on by itself
  const Wide& sum() const { return sum_; }                       // of all paths so far

 private:
  void add(const Columns& to_sun, const Wide& sent_back);
  Wide sent_into(const Bend& bend, const Columns& densities, const std::optional<Wide>& dipoles) const;

  const Wavelengths& all_;
  Analyser<Wide> analyser_;
  Wide carry_;        // without the transmittance of
  Columns passed_{};  // these columns, km at density 1,
  int flights_ = 0;   // and of this many flights
  Wide sum_;
};

}  // namespace airlight
