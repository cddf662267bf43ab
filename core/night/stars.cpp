#include "core/night/stars.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>

#include "core/night/celestial.h"
#include "core/scene/photometry.h"

namespace airlight {

namespace {

struct Motion {
  int right_ascension;  // as in the table
  int declination;
  double east;  // seconds of arc a year
  double north;
};

// Hipparcos, ESA SP-1200 (1997).
constexpr std::array<Motion, 17> kMotions{{{1012872, -167161, -0.546, -1.223},  // Sirius
                                           {2199021, -608340, -3.678, 0.482},   // Rigil Kentaurus
                                           {2198962, -608372, -3.600, 0.952},   // its companion
                                           {2139153, 191824, -1.093, -1.999},   // Arcturus
                                           {2792347, 387837, 0.201, 0.286},     // Vega
                                           {791723, 459980, 0.076, -0.427},     // Capella
                                           {1148255, 52250, -0.717, -1.035},    // Procyon
                                           {2976958, 88683, 0.537, 0.385},      // Altair
                                           {689802, 165093, 0.063, -0.189},     // Aldebaran
                                           {1163290, 280262, -0.626, -0.046},   // Pollux
                                           {3444127, -296222, 0.329, -0.164},   // Fomalhaut
                                           {260170, -159375, -1.721, 0.854},    // tau Ceti
                                           {532327, -94583, -0.975, 0.019},     // epsilon Eridani
                                           {638180, -76529, -2.239, -3.420},    // 40 Eridani
                                           {3308402, -567860, 3.961, -2.538},   // epsilon Indi
                                           {3167248, 387494, 4.155, 3.259},     // 61 Cygni
                                           {3167303, 387421, 4.107, 3.144}}};   // its companion

physics::vec3 motion_of(int right_ascension, int declination, const physics::vec3& there) {
  const auto found = std::ranges::find_if(kMotions, [&](const Motion& motion) {
    return motion.right_ascension == right_ascension && motion.declination == declination;
  });
  if (found == kMotions.end()) {
    return physics::vec3(0.0);
  }
  constexpr double kSecondOfArc = std::numbers::pi / (180.0 * 3600.0);
  const double level = std::hypot(there.x, there.y);
  const physics::vec3 east(-there.y / level, there.x / level, 0.0);
  return (east * found->east + physics::cross(there, east) * found->north) * kSecondOfArc;
}

}  // namespace

std::vector<CatalogueStar> read_stars(std::string_view table) {
  std::vector<CatalogueStar> all;
  all.reserve(table.size() / 16);
  const char* at = table.data();
  const char* const end = at + table.size();
  const auto next = [&] {
    int value = 0;
    at = std::from_chars(at, end, value).ptr + 1;
    return value;
  };
  constexpr double kTenThousandths = 1e-4 * std::numbers::pi / 180.0;
  while (at < end) {
    const int right_ascension = next();
    const int declination = next();
    const double magnitude = 0.01 * next();
    const double colour = 0.01 * next();
    const physics::vec3 there = direction_of(right_ascension * kTenThousandths, declination * kTenThousandths);
    all.push_back({there, magnitude, colour, motion_of(right_ascension, declination, there)});
  }
  return all;
}

const std::vector<CatalogueStar>& bright_stars() {
  static const std::vector<CatalogueStar> stars = read_stars(star_table());
  return stars;
}

physics::vec3 place_at(const CatalogueStar& star, double julian_date) {
  constexpr double kJ2000 = 2451545.0;
  constexpr double kYear = 365.25;
  return star.j2000 + star.motion * ((julian_date - kJ2000) / kYear);
}

namespace {

struct NamedStar {
  std::string_view name;
  double right_ascension;  // J2000, degrees
  double declination;
};

// Places of Hipparcos, J2000.
constexpr std::array<NamedStar, 36> kNames{
    {{"Sirius", 101.287, -16.716},  {"Canopus", 95.988, -52.696},  {"Rigil Kentaurus", 219.90, -60.834},
     {"Arcturus", 213.915, 19.182}, {"Vega", 279.235, 38.784},     {"Capella", 79.172, 45.998},
     {"Rigel", 78.634, -8.202},     {"Procyon", 114.825, 5.225},   {"Achernar", 24.429, -57.237},
     {"Betelgeuse", 88.793, 7.407}, {"Hadar", 210.956, -60.373},   {"Altair", 297.696, 8.868},
     {"Acrux", 186.650, -63.099},   {"Aldebaran", 68.980, 16.509}, {"Spica", 201.298, -11.161},
     {"Antares", 247.352, -26.432}, {"Pollux", 116.329, 28.026},   {"Fomalhaut", 344.413, -29.622},
     {"Deneb", 310.358, 45.280},    {"Mimosa", 191.930, -59.689},  {"Regulus", 152.093, 11.967},
     {"Adhara", 104.656, -28.972},  {"Castor", 113.650, 31.888},   {"Gacrux", 187.791, -57.113},
     {"Shaula", 263.402, -37.104},  {"Bellatrix", 81.283, 6.350},  {"Elnath", 81.573, 28.608},
     {"Alnilam", 84.053, -1.202},   {"Alnitak", 85.190, -1.943},   {"Alioth", 193.507, 55.960},
     {"Mirfak", 51.081, 49.861},    {"Dubhe", 165.932, 61.751},    {"Alkaid", 206.885, 49.313},
     {"Polaris", 37.955, 89.264},   {"Mizar", 200.981, 54.925},    {"Kochab", 222.676, 74.156}}};

}  // namespace

std::string_view star_name(const CatalogueStar& star) {
  constexpr double kFaintestNamed = 2.4;
  constexpr double kNear = 0.05 * std::numbers::pi / 180.0;
  if (star.magnitude > kFaintestNamed) {
    return {};
  }
  const auto is_it = [&](const NamedStar& named) {
    constexpr double kDegree = std::numbers::pi / 180.0;
    const physics::vec3 there = direction_of(named.right_ascension * kDegree, named.declination * kDegree);
    return physics::length(there - star.j2000) < kNear;
  };
  const auto found = std::ranges::find_if(kNames, is_it);
  return found == kNames.end() ? std::string_view() : found->name;
}

double star_temperature(double colour) {
  return 4600.0 * (1.0 / (0.92 * colour + 1.7) + 1.0 / (0.92 * colour + 0.62));
}

double star_illuminance(double magnitude) {
  constexpr double kSunsMagnitude = -26.76;
  return kSunlight * std::pow(10.0, -0.4 * (magnitude - kSunsMagnitude));
}

}  // namespace airlight
