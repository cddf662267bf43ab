#include "core/scene/photometry.h"

#include "core/scene/rules.h"

namespace airlight {

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
