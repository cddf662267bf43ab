#include "core/night/night_air.h"

#include <array>
#include <cmath>
#include <numbers>

namespace airlight {
namespace {

using physics::vec3;

constexpr int kAltitudes = 24;
constexpr int kSlopes = 24;  // zenith cosines, half of them above the horizon
constexpr int kSteps = 32;
constexpr int kOrders = 5;

class EvenSky {
 public:
  EvenSky(const Air& air, NightSource source)
      : p_(air.formulas()),
        planet_(p_.scene.planet),
        sky_(source == NightSource::sky ? 1.0 : 0.0),
        lamps_(source == NightSource::ground ? 1.0 : 0.0) {}

  // Of each altitude the mean radiance over all directions, by all orders.
  void find_field() {
    std::array<vec3, kAltitudes> sources{};  // of the order before: mean radiance at the altitudes
    for (int order = 0; order <= kOrders; ++order) {
      const vec3 ground = order == 0 ? vec3(lamps_) : planet_.ground_albedo * irradiance_ / std::numbers::pi;
      irradiance_ = irradiance(sources, ground, order == 0);
      ground_ = ground_ + irradiance_;
      std::array<vec3, kAltitudes> next{};
      for (int i = 0; i < kAltitudes; ++i) {
        next[index(i)] = mean(altitude(i), sources, ground, order == 0);
        field_[index(i)] = field_[index(i)] + next[index(i)];
      }
      sources = next;
    }
  }

  // What the air and the ground send into a ray from an altitude.
  vec3 scattered(double h, double mu) {
    return along(h, mu, field_, planet_.ground_albedo * ground_ / std::numbers::pi + vec3(lamps_), false);
  }
  vec3 on_ground() const { return ground_; }

 private:
  static std::size_t index(int i) { return static_cast<std::size_t>(i); }
  double altitude(int i) const {
    const double x = static_cast<double>(i) / (kAltitudes - 1);
    return planet_.atmosphere_height * x * x;
  }
  vec3 at(const std::array<vec3, kAltitudes>& values, double h) const {
    const double x = std::sqrt(std::min(h / planet_.atmosphere_height, 1.0)) * (kAltitudes - 1);
    const int i = std::min(static_cast<int>(x), kAltitudes - 2);
    const double u = x - i;
    return values[index(i)] * (1.0 - u) + values[index(i + 1)] * u;
  }

  // Radiance of an order along a ray, out of the mean radiance of the order before; of the first, `direct`, the
  // source's.
  vec3 along(double h, double mu, const std::array<vec3, kAltitudes>& sources, const vec3& ground, bool direct) {
    const auto ray = p_.ray_in_atmosphere(planet_, h, mu, 0.0, 0.0);
    vec3 depth(0.0);
    vec3 light(0.0);
    for (int i = 0; i < kSteps && ray.length_ > 0.0; ++i) {
      const double from = ray.length_ * i * i / (kSteps * kSteps);
      const double width = ray.length_ * (2 * i + 1) / (kSteps * kSteps);
      const auto point = p_.point_on_ray(planet_, ray, from + 0.5 * width);
      vec3 scattering(0.0);
      vec3 extinction(0.0);
      for (physics::uint m = 0; m < p_.media; ++m) {
        const auto& medium = p_.scene.media[m];
        const double density = p_.density(p_.density_profile(m), medium, point.h);
        scattering = scattering + medium.scattering * density;
        extinction = extinction + (medium.scattering + medium.absorption) * density;
      }
      const vec3 step = extinction * width;
      const vec3 mean_through(p_.mean_transmittance(step.x), p_.mean_transmittance(step.y),
                              p_.mean_transmittance(step.z));
      if (!direct) {
        light = light + exp(-depth) * scattering * at(sources, point.h) * mean_through * width;
      }
      depth = depth + step;
    }
    const vec3 behind = ray.at_ground ? ground : vec3(direct ? sky_ : 0.0);
    return light + exp(-depth) * behind;
  }

  // Calls use(mu, weight) for zenith cosines on either side of the horizon, dense beside it; weights add up to 2.
  template <class Use>
  void for_slopes(double h, Use use) {
    const double horizon = p_.horizon_mu(planet_, h);
    for (int i = 0; i < kSlopes; ++i) {
      const bool up = i % 2 == 0;
      const double x = (i / 2 + 0.5) / (kSlopes / 2);
      const double span = up ? 1.0 - horizon : -1.0 - horizon;
      use(horizon + span * x * x, std::abs(span) * 2.0 * x / (kSlopes / 2));
    }
  }

  vec3 mean(double h, const std::array<vec3, kAltitudes>& sources, const vec3& ground, bool direct) {
    vec3 sum(0.0);
    for_slopes(h,
               [&](double mu, double weight) { sum = sum + along(h, mu, sources, ground, direct) * (0.5 * weight); });
    return sum;
  }

  vec3 irradiance(const std::array<vec3, kAltitudes>& sources, const vec3& ground, bool direct) {
    vec3 sum(0.0);
    for_slopes(0.0, [&](double mu, double weight) {
      sum = sum + along(0.0, mu, sources, ground, direct) * (2.0 * std::numbers::pi * weight * std::max(mu, 0.0));
    });
    return sum;
  }

  physics::Physics p_;
  physics::PlanetData planet_;
  double sky_;    // radiance
  double lamps_;  // radiance of the ground
  std::array<vec3, kAltitudes> field_{};
  vec3 irradiance_{0.0, 0.0, 0.0};  // of the last order
  vec3 ground_{0.0, 0.0, 0.0};      // of all orders
};

}  // namespace

NightAir night_air(const Air& air, double camera, NightSource source) {
  EvenSky sky(air, source);
  sky.find_field();
  physics::Physics p = air.formulas();
  NightAir found;
  for (physics::uint i = 0; i < 2 * physics::kNightSlopes; ++i) {
    found.scattered.push_back(sky.scattered(camera, p.night_slope_cosine(p.scene.planet, camera, i)));
  }
  found.ground = sky.on_ground();
  return found;
}

}  // namespace airlight
