#include "core/composite/fog.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/text.h"

namespace airlight::composite {
namespace {

using physics::vec3;

vec3 mix(const vec3& a, const vec3& b, double x) {
  return a + (b - a) * x;
}

FogTerms mixed(const vec3& colour, double share) {
  return {vec3(1.0 - share), colour * share};
}

vec3 taken(const vec3& rate, double distance) {
  return {-std::expm1(-rate.x * distance), -std::expm1(-rate.y * distance), -std::expm1(-rate.z * distance)};
}

}  // namespace

std::optional<FogKind> fog_kind(std::string_view name) {
  return named<FogKind>(std::array<std::string_view, 4>{"exponential", "sun-tinted", "height", "extinction-inscatter"},
                        name);
}

double height_fog_amount(const Fog& fog, const FogRay& ray) {
  // a t exp(-b y) (1 - exp(-x))/x with x = b t v_y: the quotient has no pole, and expm1 keeps its digits.
  const double x = fog.falloff * ray.distance * ray.rise;
  const double mean = std::abs(x) < 1e-12 ? 1.0 : -std::expm1(-x) / x;
  return fog.amount * ray.distance * std::exp(-fog.falloff * ray.height) * mean;
}

FogTerms fog_terms(const Fog& fog, const FogRay& ray) {
  switch (fog.kind) {
    case FogKind::exponential:
      return mixed(fog.colour, -std::expm1(-fog.density * ray.distance));
    case FogKind::sun_tinted: {
      const double sun = std::pow(std::max(ray.toward_sun, 0.0), fog.sun_power);
      return mixed(mix(fog.colour, fog.sun_colour, sun), -std::expm1(-fog.density * ray.distance));
    }
    case FogKind::height: {
      const double amount = height_fog_amount(fog, ray);
      return mixed(fog.colour, fog.exact ? -std::expm1(-amount) : std::clamp(amount, 0.0, 1.0));
    }
    case FogKind::extinction_inscatter:
      return {vec3(1.0) - taken(fog.extinction, ray.distance), fog.colour * taken(fog.inscatter, ray.distance)};
  }
  return {};
}

}  // namespace airlight::composite
