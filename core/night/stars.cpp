#include "core/night/stars.h"

#include <charconv>
#include <cmath>
#include <numbers>

#include "core/night/celestial.h"
#include "core/scene/photometry.h"

namespace airlight {

const std::vector<CatalogueStar>& bright_stars() {
  static const std::vector<CatalogueStar> stars = [] {
    std::vector<CatalogueStar> all;
    const std::string_view table = star_table();
    const char* at = table.data();
    const char* const end = at + table.size();
    const auto next = [&] {
      int value = 0;
      at = std::from_chars(at, end, value).ptr + 1;
      return static_cast<double>(value);
    };
    constexpr double kTenThousandths = 1e-4 * std::numbers::pi / 180.0;
    while (at < end) {
      const double right_ascension = next() * kTenThousandths;
      const double declination = next() * kTenThousandths;
      const double magnitude = 0.01 * next();
      all.push_back({direction_of(right_ascension, declination), magnitude, 0.01 * next()});
    }
    return all;
  }();
  return stars;
}

double star_temperature(double colour) {
  return 4600.0 * (1.0 / (0.92 * colour + 1.7) + 1.0 / (0.92 * colour + 0.62));
}

double star_illuminance(double magnitude) {
  constexpr double kSunsMagnitude = -26.76;
  return kSunlight * std::pow(10.0, -0.4 * (magnitude - kSunsMagnitude));
}

}  // namespace airlight
