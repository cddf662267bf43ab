// Where the stars stand, by our formulas, against ERFA's in double.

#include "core/night/celestial.h"

#include <erfa.h>
#include <erfam.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/night/stars.h"
#include "core/scene/readers.h"
#include "core/sequence/sun_position.h"

namespace airlight::sequence {
namespace {

struct Star {
  const char* name;
  double right_ascension;  // J2000, degrees
  double declination;
  double east;  // proper motion, 1e-3 seconds of arc a year
  double north;
};

// Places and motions of Hipparcos, J2000.
constexpr std::array<Star, 10> kStars{{{"Sirius", 101.2872, -16.7161, -546.01, -1223.08},
                                       {"Canopus", 95.9880, -52.6957, 19.99, 23.67},
                                       {"Arcturus", 213.9153, 19.1824, -1093.45, -1999.40},
                                       {"Vega", 279.2347, 38.7837, 200.94, 286.23},
                                       {"Capella", 79.1723, 45.9980, 75.52, -427.11},
                                       {"Rigel", 78.6345, -8.2016, 1.87, -0.56},
                                       {"Achernar", 24.4285, -57.2368, 88.02, -40.08},
                                       {"Betelgeuse", 88.7929, 7.4071, 27.33, 10.86},
                                       {"Polaris", 37.9546, 89.2641, 44.22, -11.74},
                                       {"Antares", 247.3519, -26.4320, -10.16, -23.21}}};

physics::vec3 catalogue_place(const Star& star, double julian_date) {
  const physics::vec3 there = direction_of(star.right_ascension * ERFA_DD2R, star.declination * ERFA_DD2R);
  const auto apart = [&](const CatalogueStar& of_table) { return physics::length(of_table.j2000 - there); };
  return place_at(*std::ranges::min_element(bright_stars(), {}, apart), julian_date);
}

struct Moment {
  double julian_date;
  double latitude;  // degrees
  double longitude;
};

// The second and third date are in 2025 and 2026, the last in 2050.
TEST(Celestial, AgreesWithErfaForTenStarsAtFiveDates) {
  constexpr double kThousandth = 1e-3 * ERFA_DAS2R;
  for (const Moment& at :
       {Moment{2451545.0, 0.0, 0.0}, Moment{2460845.42, 48.85, 2.35}, Moment{2461120.9, -24.6, -70.4},
        Moment{2440000.25, 69.6, 18.9}, Moment{2470172.7, -41.3, 174.8}}) {
    const CelestialFrame frame = celestial_frame(at.julian_date, at.latitude * ERFA_DD2R, at.longitude * ERFA_DD2R);
    for (const Star& star : kStars) {
      double azimuth = 0.0, zenith = 0.0, hour = 0.0, declination = 0.0, right_ascension = 0.0, origins = 0.0;
      ASSERT_GE(
          eraAtco13(star.right_ascension * ERFA_DD2R, star.declination * ERFA_DD2R,
                    star.east * kThousandth / std::cos(star.declination * ERFA_DD2R), star.north * kThousandth, 0.0,
                    0.0, at.julian_date, 0.0, 0.0, at.longitude * ERFA_DD2R, at.latitude * ERFA_DD2R, 0.0, 0.0, 0.0,
                    0.0, 0.0, 0.0, 0.55, &azimuth, &zenith, &hour, &declination, &right_ascension, &origins),
          0);
      const physics::vec3 ours = frame.apparent(catalogue_place(star, at.julian_date));
      const physics::vec3 theirs(std::sin(zenith) * std::sin(azimuth), std::cos(zenith),
                                 -std::sin(zenith) * std::cos(azimuth));
      EXPECT_LT(physics::length(ours - theirs) * ERFA_DR2D, 0.01) << star.name << " at " << at.julian_date;
    }
  }
}

// Meeus, Astronomical Algorithms, examples 47.a and 48.a: 12 April 1992, 0 h TT. Right ascension 134.6885 and
// declination 13.7684 degrees, distance 368 409.7 km, phase angle 69.08 degrees, waxing. Where it stands at the zenith
// the parallax is 0 and the place nearer to it by the earth's radius.
TEST(Moon, AgreesWithAPublishedExample) {
  const Milliseconds utc = 703036741000;  // 59 s before 0 h
  const double days = static_cast<double>(utc) / static_cast<double>(kDay);
  const double sidereal = eraGst06a(2440587.5, days, 2440587.5, days + 59.0 / ERFA_DAYSEC) * ERFA_DR2D;
  const MoonAngles moon = moon_angles(utc, {13.7684, 134.6885 - sidereal, 0.0});
  EXPECT_GT(moon.at.elevation_deg, 89.98);
  EXPECT_NEAR(moon.distance_km, 368409.7 - 6376.9, 10.0);
  EXPECT_NEAR(moon.phase_deg, 69.08, 0.02);
  EXPECT_NEAR(julian_date(utc), 2448724.5 - 59.0 / ERFA_DAYSEC, 1e-8);
}

// Five days later it is full.
TEST(Moon, WanesWhenItWasFull) {
  const Milliseconds full = 703486992000;  // 17 April 1992, 4:43
  EXPECT_LT(std::abs(moon_angles(full, {0.0, 0.0, 0.0}).phase_deg), 5.0);
  EXPECT_GT(moon_angles(full - kDay, {0.0, 0.0, 0.0}).phase_deg, 5.0);
  EXPECT_LT(moon_angles(full + kDay, {0.0, 0.0, 0.0}).phase_deg, -5.0);
}

// 8 April 2024 over Dallas (32.78 N, 96.80 W): total from 18:40:43 to 18:44:35 UTC; before and after, a crescent. 14
// October 2023 over Albuquerque (35.08 N, 106.65 W): a ring from 16:34:30 to 16:39:20.
TEST(Eclipse, IsTotalOrAnnularWhereItWas) {
  const auto discs = [](Milliseconds utc, const Place& place) {
    const SunAngles sun = sun_angles(utc, place);
    const MoonAngles moon = moon_angles(utc, place);
    double apart = eraSeps(sun.azimuth_deg * ERFA_DD2R, sun.elevation_deg * ERFA_DD2R, moon.at.azimuth_deg * ERFA_DD2R,
                           moon.at.elevation_deg * ERFA_DD2R);
    const double moon_radius = std::asin(1737.4 / moon.distance_km);
    return uncovered_share(0.2666 * ERFA_DD2R, 0.6, moon_radius, apart);
  };
  const Place dallas{32.7767, -96.797, 0.13};
  const Milliseconds total = 1712601643000;  // 18:40:43
  EXPECT_GT(discs(total - 40000, dallas), 0.0);
  EXPECT_EQ(discs(total + 40000, dallas), 0.0);
  EXPECT_EQ(discs(total + 192000, dallas), 0.0);
  EXPECT_GT(discs(total + 272000, dallas), 0.0);
  EXPECT_LT(discs(total + 272000, dallas), 0.05);
  const double ring = discs(1697301420000, {35.0844, -106.6504, 1.6});  // 16:37:00
  EXPECT_GT(ring, 0.05);
  EXPECT_LT(ring, 0.12);
}

TEST(Celestial, KnowsTheSunsLongitude) {
  EXPECT_NEAR(std::remainder(sun_longitude(2451623.815), 2.0 * M_PI) * ERFA_DR2D, 0.0, 0.02);  // equinox of March 2000
}

}  // namespace
}  // namespace airlight::sequence
