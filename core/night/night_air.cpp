#include "core/night/night_air.h"

#include <algorithm>
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

// A step of a ray: what it sends on of the mean radiance at its altitude, between two of the table's.
struct Step {
  int below = 0;
  double up = 0.0;
  vec3 weight{};
};

// A ray through the air, of all that its light takes on the way.
struct RayLight {
  double mu = 0.0;
  double weight = 0.0;  // of the direction
  std::vector<Step> steps;
  vec3 through{};
  bool at_ground = false;
};

class EvenSky {
 public:
  EvenSky(const Air& air, NightSource source)
      : p_(air.formulas()),
        planet_(p_.scene.planet),
        sky_(source == NightSource::sky ? 1.0 : 0.0),
        lamps_(source == NightSource::ground ? 1.0 : 0.0) {
    for (int i = 0; i < kAltitudes; ++i) {
      rays_[index(i)] = rays_from(altitude(i));
    }
  }

  // Of each altitude the mean radiance over all directions, by all orders.
  void find_field() {
    std::array<vec3, kAltitudes> sources{};  // of the order before: mean radiance at the altitudes
    vec3 irradiance(0.0);
    for (int order = 0; order <= kOrders; ++order) {
      const vec3 ground = order == 0 ? vec3(lamps_) : planet_.ground_albedo * irradiance / std::numbers::pi;
      irradiance = irradiance_of(sources, ground, order == 0);
      ground_ = ground_ + irradiance;
      std::array<vec3, kAltitudes> next{};
      for (int i = 0; i < kAltitudes; ++i) {
        for (const RayLight& ray : rays_[index(i)]) {
          next[index(i)] = next[index(i)] + along(ray, sources, ground, order == 0) * (0.5 * ray.weight);
        }
        field_[index(i)] = field_[index(i)] + next[index(i)];
      }
      sources = next;
    }
  }

  // What the air and the ground send into a ray from an altitude.
  vec3 scattered(double h, double mu) {
    return along(ray_from(h, mu), field_, planet_.ground_albedo * ground_ / std::numbers::pi + vec3(lamps_), false);
  }
  vec3 on_ground() const { return ground_; }

 private:
  static std::size_t index(int i) { return static_cast<std::size_t>(i); }
  double altitude(int i) const {
    const double x = static_cast<double>(i) / (kAltitudes - 1);
    return planet_.atmosphere_height * x * x;
  }

  RayLight ray_from(double h, double mu) {
    const auto ray = p_.ray_in_atmosphere(planet_, h, mu, 0.0, 0.0);
    RayLight light;
    light.mu = mu;
    light.at_ground = ray.at_ground;
    vec3 depth(0.0);
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
      const double x = std::sqrt(std::clamp(point.h / planet_.atmosphere_height, 0.0, 1.0)) * (kAltitudes - 1);
      const int below = std::min(static_cast<int>(x), kAltitudes - 2);
      light.steps.push_back({below, x - below, exp(-depth) * scattering * mean_through * width});
      depth = depth + step;
    }
    light.through = exp(-depth);
    return light;
  }

  // Rays on either side of the horizon, dense beside it; weights add up to 2.
  std::vector<RayLight> rays_from(double h) {
    std::vector<RayLight> rays;
    const double horizon = p_.horizon_mu(planet_, h);
    for (int i = 0; i < kSlopes; ++i) {
      const bool up = i % 2 == 0;
      const double x = (i / 2 + 0.5) / (kSlopes / 2);
      const double span = up ? 1.0 - horizon : -1.0 - horizon;
      rays.push_back(ray_from(h, horizon + span * x * x));
      rays.back().weight = std::abs(span) * 2.0 * x / (kSlopes / 2);
    }
    return rays;
  }

  // Radiance of an order along a ray, out of the mean radiance of the order before; of the first, `direct`, the
  // source's.
  vec3 along(const RayLight& ray, const std::array<vec3, kAltitudes>& sources, const vec3& ground, bool direct) const {
    vec3 light = ray.through * (ray.at_ground ? ground : vec3(direct ? sky_ : 0.0));
    if (direct) {
      return light;
    }
    for (const Step& step : ray.steps) {
      light = light +
              step.weight * (sources[index(step.below)] * (1.0 - step.up) + sources[index(step.below + 1)] * step.up);
    }
    return light;
  }

  vec3 irradiance_of(const std::array<vec3, kAltitudes>& sources, const vec3& ground, bool direct) const {
    vec3 sum(0.0);
    for (const RayLight& ray : rays_.front()) {
      const double level = 2.0 * std::numbers::pi * ray.weight * std::max(ray.mu, 0.0);
      sum = sum + along(ray, sources, ground, direct) * level;
    }
    return sum;
  }

  physics::Physics p_;
  physics::PlanetData planet_;
  double sky_;    // radiance
  double lamps_;  // radiance of the ground
  std::array<std::vector<RayLight>, kAltitudes> rays_{};
  std::array<vec3, kAltitudes> field_{};
  vec3 ground_{0.0, 0.0, 0.0};  // of all orders
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
