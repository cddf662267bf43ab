#pragma once
// A vertex of a random walk and the directions in which the path may go on from there. For walk.cpp and
// walk_clouds.cpp.

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/methods/path_trace/analyser.h"
#include "core/methods/path_trace/bent_way.h"
#include "core/methods/path_trace/walk.h"

namespace airlight {

// Shares of the directions at a vertex: around the sun where a peaked medium scatters (its light was scattered forward
// before), by the sky guide, and the rest by the phase functions around the path. The values give the least variance in
// trials.
inline constexpr double kTowardSun = 0.3;  // times the share of peaked media
inline constexpr double kTowardSky = 0.8;
inline constexpr double kTowardSkyPeaked = 0.2;
inline constexpr double kTowardSkyGround = 0.8;

struct Walk::State {
  double h;
  physics::vec3 up;
  physics::vec3 direction;
  double mu_sun;
  bool at_ground = false;
  ThingNumber thing = kNoThing;  // at_ground: on this
  bool mirrors = false;
  physics::vec3 normal = physics::vec3(0.0);  // of ground or thing
  physics::vec3 albedo = physics::vec3(0.0);
  Wide wide_albedo;  // at all wavelengths, if there are any
  SurfaceShares shares;
  Analyser<physics::vec3> analyser = {};
  physics::vec3 axis = physics::vec3(0.0);     // of the analyser
  physics::vec3 dipoles = physics::vec3(0.0);  // coefficient of the molecules here that polarise
  physics::vec3 carry =
      physics::vec3(1.0);  // transmittances and coefficients so far, over the density of their choices
  std::array<physics::vec3, physics::kMaxMedia> scattering;  // of each medium here, 1/km
  Columns densities{};                                       // of each medium here
  physics::vec3 sum = physics::vec3(0.0);                    // sunlight sent back along the path
  // The vertex from the planet's centre. A vertex on terrain is moved so far up that the terrain does not hide what is
  // before it.
  physics::vec3 place(physics::Physics& physics) const { return off_thing(true_place(physics, up, h), thing); }
  double sun_share = 1.0;       // of the sunlight at the vertex, the part that the path itself brings
  FlightPlan* aside = nullptr;  // scratch memory among clouds
  WidePath* wide = nullptr;     // if set, replaces `sum` with all wavelengths; the channels above then only steer
};

// A direction in which a vertex may continue a path.
struct Walk::Choice {
  physics::vec3 direction;
  physics::vec3 scattered;  // coefficient times phase function back along the path, or the ground's counterpart
  double density;           // 1/sr
  double sun_weight;        // phase function from there to the sun, 1 for isotropic
};

// The directions in which a vertex may continue a path, and their densities.
class Walk::Lobes {
 public:
  // Without `guided`: only the phase functions, or the surface's own.
  // `first_cloud`: the first medium of a cloud.
  Lobes(physics::Physics& physics, const PhaseSampler& phases, const SkyGuide& guide, const State& state, bool guided,
        physics::uint first_cloud)
      : physics_(physics),
        phases_(phases),
        guide_(guide),
        state_(state),
        // Light from below counts where the surface sends it on.
        frame_(physics, state.h, state.up, state.at_ground && !(state.shares.even > 0.0)),
        first_cloud_(first_cloud) {
    if (state.at_ground) {
      toward_sky_ = guided ? kTowardSkyGround : 0.0;
      weight_ = channels_of(state.carry * state.albedo);
      return;
    }
    physics::vec3 scattering(0.0);
    double peaked = 0.0;
    double all = 0.0;
    for (physics::uint i = 0; i < count(); ++i) {
      along_path_[i] = dot(state.carry, state.scattering[i]);
      scattering = scattering + state.scattering[i];
      all += along_path_[i];
      peaked += phases.is_peaked(i) ? along_path_[i] : 0.0;
    }
    weight_ = channels_of(state.carry * scattering);
    const double whole = weight_[0] + weight_[1] + weight_[2];
    if (whole > 0.0) {
      const physics::vec3 shares(weight_[0] / whole, weight_[1] / whole, weight_[2] / whole);
      analyser_ = {dot(state.analyser.q, shares), dot(state.analyser.u, shares)};
    }
    peaked /= all;
    const double toward_sun = guided ? kTowardSun * peaked : 0.0;
    toward_sky_ = guided ? kTowardSky * (1.0 - peaked) + kTowardSkyPeaked * peaked : 0.0;
    for (physics::uint i = 0; i < count(); ++i) {
      mix_[i] = along_path_[i] / all;
      // Peaked media may be absent where the vertex lies.
      const bool guides = peaked > 0.0 && phases.is_peaked(i);
      around_sun_[i] = guides ? mix_[i] / peaked * toward_sun : 0.0;
      along_path_[i] *= (1.0 - toward_sun - toward_sky_) / all;
    }
  }

  // True for a black place of a map.
  bool send_nothing() const { return weight_[0] + weight_[1] + weight_[2] <= 0.0; }

  physics::vec3 draw_direction(double u, double turn, Random& random) const {
    if (state_.at_ground) {
      if (u < toward_sky_) {
        return guide_.draw_direction(frame_, weight_, u / toward_sky_, turn);
      }
      const double rest = (1.0 - u) / (1.0 - toward_sky_);
      const double matte = state_.shares.matte / state_.shares.all();
      const double nu = rest <= matte ? std::sqrt(rest / matte) : 2.0 * (rest - matte) / (1.0 - matte) - 1.0;
      return around(state_.normal, nu, turn);
    }
    const physics::uint n = count();
    const auto weight = [&](std::size_t k) {
      return k == 0 ? toward_sky_ : k <= n ? along_path_[k - 1] : around_sun_[k - 1 - n];
    };
    const std::size_t lobe = draw(2 * n + 1, weight, u);
    if (lobe == 0) {
      return guide_.draw_direction(frame_, weight_, u, turn);
    }
    const physics::uint chosen = static_cast<physics::uint>(lobe - 1) % n;
    const double nu = chosen < first_cloud_ ? phases_.sample(chosen, u, random)
                                            : phases_.sample_by(carried(chosen), chosen, u, random);
    if (lobe > n) {
      return around(physics_.scene.sun.direction, nu, turn);
    }
    physics::vec3 next = around(state_.direction, nu, turn);
    while (polarises(chosen) && !(2.0 * random.uniform() < evenness(chosen, next))) {
      next = around(state_.direction, nu, random.uniform());
    }
    return next;
  }

  Choice judge(const physics::vec3& direction) const {
    const double to_sun = std::clamp(dot(direction, physics_.scene.sun.direction), -1.0, 1.0);
    const double from_sky = toward_sky_ > 0.0 ? guide_.density(frame_, weight_, direction) : 0.0;
    if (state_.at_ground) {
      const double cosine = state_.shares.cosine(dot(direction, state_.normal)) / std::numbers::pi;
      const double own = cosine / state_.shares.all();
      return {direction, state_.albedo * cosine, toward_sky_ * from_sky + (1.0 - toward_sky_) * own, 1.0};
    }
    const Bend bend = bend_of(state_.direction, direction, state_.axis);
    const double turned = bend.nu;
    Choice choice{direction, state_.analyser.correction(bend, state_.dipoles), toward_sky_ * from_sky, 0.0};
    for (physics::uint i = 0; i < count(); ++i) {
      const double toward_sun = phases_.density(i, to_sun, physics_.medium_phase(i, to_sun));
      const physics::vec3 phase = physics_.medium_phase(i, turned);
      const double around_path = i < first_cloud_ || along_path_[i] <= 0.0
                                     ? phases_.density(i, turned, phase)
                                     : phases_.density_by(carried(i), i, turned, phase);
      const double along = around_path + (polarises(i) ? uneven(i, bend) : 0.0);
      choice.density += along_path_[i] * along + around_sun_[i] * toward_sun;
      choice.scattered = choice.scattered + state_.scattering[i] * phase;
      choice.sun_weight += mix_[i] * toward_sun * 4.0 * std::numbers::pi;
    }
    return choice;
  }

 private:
  physics::uint count() const { return physics_.medium_count(); }
  // What the medium scatters of each channel's light.
  Channels carried(physics::uint i) const { return channels_of(state_.carry * state_.scattering[i]); }

  // Whether the medium scatters unevenly around the path, whose end tells polarised light.
  bool polarises(physics::uint i) const {
    return (analyser_.q != 0.0 || analyser_.u != 0.0) && physics_.polarised() && physics_.is_molecular(i);
  }

  // What a molecule's density has beyond the mean around the path, 1/sr.
  double uneven(physics::uint i, const Bend& bend) const {
    return analyser_.correction(bend, physics_.kDipole * phases_.dipole_share(i));
  }

  // How likely a molecule's lobe takes a direction over the mean around the path: 0 to 2.
  double evenness(physics::uint i, const physics::vec3& direction) const {
    const Bend bend = bend_of(state_.direction, direction, state_.axis);
    return 1.0 + uneven(i, bend) / phases_.density(i, bend.nu, physics_.medium_phase(i, bend.nu));
  }

  physics::Physics& physics_;
  Analyser<double> analyser_;  // mean of the channels, by the light that they carry
  const PhaseSampler& phases_;
  const SkyGuide& guide_;
  const State& state_;
  SkyFrame frame_;
  physics::uint first_cloud_;
  Channels weight_;
  double toward_sky_ = 0.0;
  std::array<double, physics::kMaxMedia> along_path_{};
  std::array<double, physics::kMaxMedia> around_sun_{};
  std::array<double, physics::kMaxMedia> mix_{};
};

}  // namespace airlight
