#pragma once
// The simple fogs of game engines, as closed forms in distance, for people who want their look. None of them depends on
// the sun's height, on light scattered more than once or on the colour of the sky behind.

#include <optional>
#include <string_view>

#include "core/physics/vector.h"

namespace airlight::composite {

// mix(a, b, x) = a + (b - a) x; t the distance from the camera, in the unit of the parameters.
enum class FogKind {
  exponential,           // mix(c, colour, 1 - exp(-density t))
  sun_tinted,            // the same with colour = mix(colour, sun_colour, max(v.s, 0)^sun_power)
  height,                // mix by amount: see height_fog_amount
  extinction_inscatter,  // c exp(-t extinction) + colour (1 - exp(-t inscatter)), each by channel
};

std::optional<FogKind> fog_kind(
    std::string_view name);  // "exponential", "sun-tinted", "height", "extinction-inscatter"

struct Fog {
  FogKind kind = FogKind::exponential;
  physics::vec3 colour{0.5, 0.6, 0.7};
  double density = 0.1;
  physics::vec3 sun_colour{1.0, 0.9, 0.7};
  double sun_power = 8.0;
  double amount = 0.5;   // a of the height fog
  double falloff = 0.3;  // b of the height fog, per unit of height
  bool exact = false;    // of the height fog: 1 - exp(-amount) in place of the amount clamped to 0 to 1
  physics::vec3 extinction{0.02, 0.025, 0.03};
  physics::vec3 inscatter{0.015, 0.02, 0.025};
};

struct FogRay {
  double distance = 0.0;    // t
  double height = 0.0;      // y of the camera
  double rise = 0.0;        // v_y: sine of the ray's elevation
  double toward_sun = 0.0;  // v.s
};

// (a/b) exp(-b y) (1 - exp(-b t v_y)) / v_y, and its limit a exp(-b y) t for level rays.
double height_fog_amount(const Fog& fog, const FogRay& ray);

// Effect of the fog on a colour c behind it: c times `keeps` plus `adds`.
struct FogTerms {
  physics::vec3 keeps;
  physics::vec3 adds;
};
FogTerms fog_terms(const Fog& fog, const FogRay& ray);

}  // namespace airlight::composite
