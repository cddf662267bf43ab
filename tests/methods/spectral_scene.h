#pragma once
// Presets with curves over the wavelength, as text.

#include <string>

#include "core/methods/method.h"
#include "core/scene/preset.h"
#include "core/scene/resolve.h"

namespace airlight::test {

inline Scene scene_of(const std::string& text) {
  return resolve(parse_preset(text, "test", {}), method_infos());
}

// Air of one medium, a sun, and a map of the sky in few pixels. The arguments are JSON; `extra` follows a comma.
inline std::string clear_air(const std::string& scattering, const std::string& sun, const std::string& extra = "") {
  return R"({"airlight": 1, "planet": {"ground_albedo": 0.3}, "media": [{"name": "air", "scattering_per_km": )" +
         scattering + R"(, "density": {"profile": "exponential", "scale_height_km": 8},
          "phase": {"function": "rayleigh"}}], "sun": )" +
         sun + R"(, "camera": {"projection": "equirectangular"}, "image": {"width": 16, "height": 8})" + extra + "}";
}

}  // namespace airlight::test
