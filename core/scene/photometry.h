#pragma once
// From radiance in the linear working space (BT.709) to luminance, where `sun.unit` gives it an absolute size.
//
// For a scene with spectra and D65 as white, luminance is Y of CIE 1931. Three channels are no spectrum: a medium's
// coefficients stand for wavelengths near 680, 550 and 440 nm, and luminance is their BT.709 sum, not an integral over
// V(lambda). For `W/m2` the efficacy is that of sunlight above the air, whatever the light has gone through; blue sky
// alone has a higher one, a low red sun a lower one.

#include <optional>
#include <string_view>

#include "core/base/srgb.h"
#include "core/scene/scene.h"

namespace airlight {

constexpr double bt709_luminance(const Spectrum& rgb) {
  return bt709_luminance(rgb[0], rgb[1], rgb[2]);
}

// Solar illuminance constant of the IES, lux.
inline constexpr double kSunlight = 128000.0;

// kSunlight over the total solar irradiance of Kopp and Lean 2011, 1361 W/m2: lm per W of sunlight above the air, its
// infrared included.
inline constexpr double kSunlightEfficacy = kSunlight / 1361.0;

// Luminance in cd/m2 of the radiance (1, 1, 1), the value of OpenEXR's whiteLuminance; also lux per unit of irradiance.
// None: the unit does not determine it.
constexpr std::optional<double> white_luminance(SunUnit unit) {
  switch (unit) {
    case SunUnit::relative:
      break;
    case SunUnit::watts_per_square_metre:
      return kSunlightEfficacy;
    case SunUnit::lux:
      return 1.0;
  }
  return std::nullopt;
}

// The same for a scene. A sun without a unit counts as Earth's, whatever its number; 0: there is no light to tell it
// by.
constexpr double luminance_of_one(const Scene& scene) {
  const double sun = bt709_luminance(scene.sun.irradiance);
  return white_luminance(scene.sun.unit).value_or(sun > 0.0 ? kSunlight / sun : 0.0);
}

std::string_view irradiance_unit(SunUnit unit);  // "W/m2", "lux"; empty: relative
std::string_view radiance_unit(SunUnit unit);    // "W/(m2 sr)", "cd/m2"; "sun irradiance unit / sr": relative

}  // namespace airlight
