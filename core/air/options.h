#pragma once
// What a method says of the air beside what it is: filled in by the method from its own keys.

#include <optional>

#include "core/scene/method_info.h"

namespace airlight {

enum class Shells { never, where_needed, always };

struct AirOptions {
  std::optional<SunFade> sun_fade;         // absent: the planet's shadow alone
  bool schlick = false;                    // Schlick's phase function in place of the media's peaked ones
  double multiple_scattering_scale = 1.0;  // 0: single scattering alone
  Shells shells = Shells::never;  // whether rays go through the air shell by shell (shaders/physics/shells.glsl)
  int moment_rows = 12;           // altitudes of the table of moments; by shells there are more
  bool operator==(const AirOptions&) const = default;
};

}  // namespace airlight
