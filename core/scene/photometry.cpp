#include "core/scene/photometry.h"

#include "core/scene/rules.h"

namespace airlight {

double bt709_luminance(const Spectrum& rgb) {
  return 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2];
}

std::optional<double> white_luminance(SunUnit unit) {
  switch (unit) {
    case SunUnit::relative:
      return std::nullopt;
    case SunUnit::watts_per_square_metre:
      return kSunlightEfficacy;
    case SunUnit::lux:
      return 1.0;
  }
  return std::nullopt;
}

std::string_view irradiance_unit(SunUnit unit) {
  return unit == SunUnit::relative ? std::string_view() : kSunUnitNames.at(static_cast<std::size_t>(unit));
}

std::string_view radiance_unit(SunUnit unit) {
  switch (unit) {
    case SunUnit::relative:
      break;
    case SunUnit::watts_per_square_metre:
      return "W/(m2 sr)";
    case SunUnit::lux:
      return "cd/m2";
  }
  return "irradiance's unit per sr";
}

}  // namespace airlight
