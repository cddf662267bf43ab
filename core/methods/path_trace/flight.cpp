#include "core/methods/path_trace/flight.h"

#include <algorithm>
#include <cmath>

#include "core/air/phase_functions.h"
#include "core/air/refraction.h"
#include "core/scene/density_profiles.h"

namespace airlight {

using physics::MediumData;
using physics::uint;
using physics::vec3;

namespace {

// Greatest bend of a density within a shell, as a share of it; vertical optical depth of a thin shell, and of a
// negligible one; number of thin shells that is too many.
constexpr double kStraight = 0.15;
constexpr double kThin = 0.45;
constexpr double kNothing = 1e-9;
constexpr std::size_t kManyShells = 48;
constexpr std::size_t kMostShells = 512;  // 66 KB of guide each

// Weight of the unguided part of a choice, by collisions alone, next to the guided part of 1.
constexpr double kUnguided = 0.25;

// Altitudes nearer than this share of the shell to its edges count as inside: a profile may jump at an edge.
constexpr double kInside = 1e-6;

// exp(-x), accurate enough to distribute samples.
double rough_transmittance(double x) {
  return 1.0 / (1.0 + x * (1.0 + x * (0.5 + x * (1.0 / 6.0))));
}

}  // namespace

Flight::Flight(physics::Physics& physics, const OpticalDepth& depth) : physics_(physics) {
  const std::vector<double> ends = this->corners();
  // Shells are thicker where thick air would need more of them than pay, then more bent where they would fill the
  // memory. Neither changes a result: shells only steer samples.
  const auto divide_all = [&](const Thinness& thin) {
    edges_.assign(1, 0.0);
    for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
      divide(ends[k], ends[k + 1], thin);
    }
  };
  Thinness thin{kThin, kStraight};
  divide_all(thin);
  while (edges_.size() > kManyShells && thin.depth < 1e6) {
    thin.depth *= 2.0;
    divide_all(thin);
  }
  while (edges_.size() > kMostShells && thin.bend < 1e30) {
    thin.bend *= 4.0;
    divide_all(thin);
  }
  for (std::size_t k = 0; k + 1 < edges_.size(); ++k) {
    const double inset = kInside * (edges_[k + 1] - edges_[k]);
    shells_.push_back({at(edges_[k] + inset), at(edges_[k + 1] - inset)});
  }
  Channels forward{};
  std::vector<GuideShell> guide_shells;
  for (std::size_t k = 0; k < shells_.size(); ++k) {
    GuideShell& shell = guide_shells.emplace_back();
    shell.altitude = 0.5 * (edges_[k] + edges_[k + 1]);
    for (std::size_t c = 0; c < 3; ++c) {
      const double extinction = shells_[k].low.extinction[c] + shells_[k].high.extinction[c];
      const double scattering = shells_[k].low.scattering[c] + shells_[k].high.scattering[c];
      shell.depth[c] = 0.5 * extinction * (edges_[k + 1] - edges_[k]);
      shell.scattered[c] = extinction > 0.0 ? scattering / extinction : 0.0;
    }
    shell.asymmetry = asymmetry_at(shell.altitude);
    for (std::size_t c = 0; c < 3; ++c) {
      forward[c] += shell.depth[c] * shell.scattered[c] * std::abs(shell.asymmetry[c]);
    }
  }
  forward_depth_ = std::max({forward[0], forward[1], forward[2]});
  guide_.emplace(physics, depth, guide_shells);
}

std::vector<double> Flight::corners() const {
  const double top = physics_.scene.planet.atmosphere_height;
  std::vector<double> list{0.0, top};
  for (uint i = 0; i < physics_.medium_count(); ++i) {
    for (const double altitude : profile_row(physics_.density_profile(i)).marks(physics_, physics_.medium(i))) {
      const double h = optical_altitude(physics_, altitude);
      if (h > 0.0 && h < top) {
        list.push_back(h);
      }
    }
  }
  std::ranges::sort(list);
  list.erase(std::unique(list.begin(), list.end()), list.end());
  return list;
}

Flight::Coefficients Flight::at(double h) const {
  vec3 extinction(0.0);
  vec3 scattering(0.0);
  for (uint i = 0; i < physics_.medium_count(); ++i) {
    const MediumData m = physics_.medium(i);
    const double density = physics_.density(physics_.density_profile(i), m, h);
    scattering = scattering + m.scattering * density;
    extinction = extinction + (m.scattering + m.absorption) * density;
  }
  return {channels_of(extinction), channels_of(scattering)};
}

// Mean cosine of the scattering.
Channels Flight::asymmetry_at(double h) const {
  vec3 forward(0.0);
  vec3 all(0.0);
  for (uint i = 0; i < physics_.medium_count(); ++i) {
    const MediumData m = physics_.medium(i);
    const vec3 scattering = m.scattering * physics_.density(physics_.density_profile(i), m, h);
    all = all + scattering;
    forward = forward + scattering * mean_cosine(physics_, i);
  }
  Channels mean{};
  for (std::size_t c = 0; c < 3; ++c) {
    mean[c] = channel(all, c) > 0.0 ? channel(forward, c) / channel(all, c) : 0.0;
  }
  return mean;
}

// Appends the edges above `low`, so close that the straight line through the ends of each shell meets its middle and no
// shell is thick.
void Flight::divide(double low, double high, const Thinness& thin) {
  const double middle = 0.5 * (low + high);
  const double inset = kInside * (high - low);
  const Coefficients a = at(low + inset);
  const Coefficients b = at(high - inset);
  const Coefficients m = at(middle);
  bool whole = true;
  for (std::size_t c = 0; c < 3; ++c) {
    const double ends = 0.5 * (a.extinction[c] + b.extinction[c]);
    const double depth = ends * (high - low);
    const bool straight = std::abs(ends - m.extinction[c]) <= thin.bend * m.extinction[c];
    whole = whole && (depth < kNothing || (straight && depth <= thin.depth));
  }
  if (whole || high - low < 1e-4 * physics_.scene.planet.atmosphere_height) {
    edges_.push_back(high);
    return;
  }
  divide(low, middle, thin);
  divide(middle, high, thin);
}

Flight::Coefficients Flight::between(std::size_t k, double h) const {
  const double x = std::clamp((h - edges_[k]) / (edges_[k + 1] - edges_[k]), 0.0, 1.0);
  const Shell& shell = shells_[k];
  Coefficients c;
  for (std::size_t i = 0; i < 3; ++i) {
    c.extinction[i] = shell.low.extinction[i] + x * (shell.high.extinction[i] - shell.low.extinction[i]);
    c.scattering[i] = shell.low.scattering[i] + x * (shell.high.scattering[i] - shell.low.scattering[i]);
  }
  return c;
}

std::size_t Flight::shell_of(double h) const {
  return static_cast<std::size_t>(std::upper_bound(edges_.begin() + 1, edges_.end() - 1, h) - edges_.begin()) - 1;
}

// Records one ray's way through the shells. `guide` may be null.
class Flight::Planner {
 public:
  Planner(const Guide* guide, const physics::Physics::Ray& ray, double r, double sun_weight, FlightPlan& plan)
      : guide_(guide), ray_(ray), r_(r), sun_weight_(sun_weight), plan_(plan) {
    plan_.panels.clear();
    plan_.length = ray.length_;
    plan_.thing = kNoThing;
    plan_.ground = {};
    plan_.total = {};
  }

  // A wall may end the ray before the shell does.
  void add(double until, std::size_t shell, const Coefficients& a, const Coefficients& b) {
    const double start = plan_.panels.empty() ? 0.0 : plan_.panels.back().start + plan_.panels.back().width;
    if (until > ray_.length_ * (1.0 + 1e-9)) {
      if (ray_.length_ > start) {
        add(ray_.length_, shell, a, part_way(a, b, (ray_.length_ - start) / (until - start)));
      }
      return;
    }
    const double width = until - start;
    if (!(width > 0.0)) {
      return;
    }
    FlightPlan::Panel& panel = plan_.panels.emplace_back();
    panel.start = start;
    panel.width = width;
    panel.enter = a.extinction;
    panel.leave = b.extinction;
    const Guide::Light* light = guide_ ? &guide_->in_air(shell, mu_sun(start + 0.5 * width)) : nullptr;
    for (std::size_t c = 0; c < 3; ++c) {
      const double extinction = a.extinction[c] + b.extinction[c];
      const double scattering = a.scattering[c] + b.scattering[c];
      const double after = transmittance_[c] * rough_transmittance(0.5 * extinction * width);
      panel.plain[c] = extinction > 0.0 ? (transmittance_[c] - after) * scattering / extinction : 0.0;
      panel.share[c] = panel.plain[c] * (light ? light->sky[c] + sun_weight_ * light->sun[c] : 1.0);
      transmittance_[c] = after;
    }
  }

  void add_ground(const Channels& albedo) {
    const Guide::Light* light = guide_ ? &guide_->on_ground(mu_sun(ray_.length_)) : nullptr;
    for (std::size_t c = 0; c < 3; ++c) {
      ground_[c] = albedo[c] * transmittance_[c];
      plan_.ground[c] = ground_[c] * (light ? light->sky[c] + (sun_weight_ > 0.0 ? light->sun[c] : 0.0) : 1.0);
    }
  }

  // Sums up, and returns a part of the choice to collisions and scattering: no share falls far below its unguided one,
  // however wrong the guide is.
  void finish() {
    Channels plain = ground_;
    plan_.total = plan_.ground;
    for (const FlightPlan::Panel& panel : plan_.panels) {
      for (std::size_t c = 0; c < 3; ++c) {
        plain[c] += panel.plain[c];
        plan_.total[c] += panel.share[c];
      }
    }
    if (!guide_) {
      return;
    }
    Channels back;
    for (std::size_t c = 0; c < 3; ++c) {
      back[c] = plain[c] > 0.0 ? kUnguided * plan_.total[c] / plain[c] : 0.0;
      plan_.ground[c] += back[c] * ground_[c];
      plan_.total[c] *= 1.0 + kUnguided;
    }
    for (FlightPlan::Panel& panel : plan_.panels) {
      for (std::size_t c = 0; c < 3; ++c) {
        panel.share[c] += back[c] * panel.plain[c];
      }
    }
  }

 private:
  static Coefficients part_way(const Coefficients& a, const Coefficients& b, double x) {
    Coefficients c;
    for (std::size_t i = 0; i < 3; ++i) {
      c.extinction[i] = a.extinction[i] + x * (b.extinction[i] - a.extinction[i]);
      c.scattering[i] = a.scattering[i] + x * (b.scattering[i] - a.scattering[i]);
    }
    return c;
  }

  double mu_sun(double t) const {
    return (r_ * ray_.mu_sun + t * ray_.nu) / std::sqrt(r_ * r_ + t * (2.0 * r_ * ray_.mu + t));
  }

  const Guide* guide_;
  const physics::Physics::Ray& ray_;
  double r_;
  double sun_weight_;
  FlightPlan& plan_;
  Channels transmittance_{1.0, 1.0, 1.0};
  Channels ground_{};
};

void Flight::plan_guided(const physics::Physics::Ray& ray, double sun_weight, FlightPlan& plan,
                         const Channels* thing) const {
  Planner planner(&*guide_, ray, physics_.scene.planet.ground_radius + ray.h, sun_weight, plan);
  follow(ray, planner, thing);
}

void Flight::plan_plain(const physics::Physics::Ray& ray, FlightPlan& plan, const Channels* thing) const {
  Planner planner(nullptr, ray, physics_.scene.planet.ground_radius + ray.h, 0.0, plan);
  follow(ray, planner, thing);
}

void Flight::follow(const physics::Physics::Ray& ray, Planner& planner, const Channels* thing) const {
  if (!(ray.length_ >= 0.0)) {
    return;
  }
  const physics::PlanetData& planet = physics_.scene.planet;
  const double r = planet.ground_radius + ray.h;
  const double r_mu = r * ray.mu;
  std::size_t k = shell_of(ray.h);
  Coefficients here = between(k, ray.h);
  // Half the ray's chord through the sphere of altitude h.
  const auto half_chord = [&](double h) {
    return std::sqrt(std::max(r_mu * r_mu + (h - ray.h) * (r + r + h - ray.h), 0.0));
  };
  if (r_mu < 0.0) {
    const double bottom = ray.at_ground ? 0.0 : physics_.point_on_ray(planet, ray, -r_mu).h;
    for (; k > 0 && edges_[k] > bottom; --k) {
      planner.add(-r_mu - half_chord(edges_[k]), k, here, shells_[k].low);
      here = shells_[k - 1].high;
    }
    const Coefficients lowest = between(k, bottom);
    planner.add(ray.at_ground ? ray.length_ : -r_mu, k, here, lowest);
    here = lowest;
  }
  if (ray.at_ground) {
    planner.add_ground(channels_of(planet.ground_albedo));
  } else {
    for (; k + 1 < shells_.size(); ++k) {
      planner.add(half_chord(edges_[k + 1]) - r_mu, k, here, shells_[k].high);
      here = shells_[k + 1].low;
    }
    planner.add(ray.length_, k, here, shells_[k].high);
  }
  if (thing != nullptr) {
    planner.add_ground(*thing);  // steered like level ground
  }
  planner.finish();
}

}  // namespace airlight
