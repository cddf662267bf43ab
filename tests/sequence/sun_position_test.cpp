// The sun's position against published values, against events that define it, and against another published formula.
#include "core/sequence/sun_position.h"

#include <gtest/gtest.h>

#include <cmath>

namespace airlight::sequence::test {
namespace {

Milliseconds utc(const CivilDate& date, int hour, int minute, int second = 0) {
  return midnight_of(date) + (hour * 3600 + minute * 60 + second) * kSecond;
}

// Reda and Andreas, Solar Position Algorithm for Solar Radiation Applications, NREL/TP-560-34302 (2003, revised 2008),
// table A5.1: 17 October 2003, 12:30:30 at UTC-7, 1830.14 m, 820 hPa, 11 C. Their zenith angle is with refraction.
TEST(SunPosition, IsThePublishedExampleOfTheSolarPositionAlgorithm) {
  const Place golden{39.742476, -105.1786, 1.83014};
  const SunAngles sun = sun_angles(utc({2003, 10, 17}, 19, 30, 30), golden);
  EXPECT_NEAR(sun.azimuth_deg, 194.34024, 0.001);
  const double lifted = sun.elevation_deg + refraction_deg(sun.elevation_deg, {820.0, 11.0});
  EXPECT_NEAR(90.0 - lifted, 50.11162, 0.001);
  // Without refraction: the result of removing their eq. 42, solved by hand: 39.88838 - 0.01633.
  EXPECT_NEAR(sun.elevation_deg, 39.87205, 0.001);
}

// At the pole the elevation is the declination less the sun's parallax of 8.794". Equinoxes and solstices in UTC to the
// minute: U.S. Naval Observatory, Earth's Seasons. The declination changes by 0.0003 degrees a minute at an equinox.
TEST(SunPosition, CrossesTheEquatorAtThePublishedEquinoxes) {
  constexpr double kParallax = 8.794 / 3600.0;
  for (const Milliseconds equinox :
       {utc({2003, 3, 21}, 1, 0), utc({2003, 9, 23}, 10, 47), utc({2026, 3, 20}, 14, 46), utc({2026, 9, 23}, 0, 5)}) {
    EXPECT_NEAR(sun_angles(equinox, {90.0, 0.0}).elevation_deg, -kParallax, 0.001) << iso_text(equinox, 0);
  }
}

// The declination at a solstice is the obliquity: 23.4393 degrees at J2000 less 0.0130 a century, and nutation of at
// most 9.2" (IAU 2006).
TEST(SunPosition, StandsAtTheObliquityAtThePublishedSolstices) {
  const double parallax = 8.794 / 3600.0;
  EXPECT_NEAR(sun_angles(utc({2003, 6, 21}, 19, 10), {90.0, 0.0}).elevation_deg, 23.4388 - parallax, 0.003);
  EXPECT_NEAR(sun_angles(utc({2026, 6, 21}, 8, 24), {90.0, 0.0}).elevation_deg, 23.4359 - parallax, 0.003);
  EXPECT_NEAR(sun_angles(utc({2026, 12, 21}, 20, 50), {-90.0, 0.0}).elevation_deg, 23.4359 - parallax, 0.003);
}

// Meeus, Astronomical Algorithms (1998), chapter 25, "low accuracy, 0.01 degrees", with his mean sidereal time (12.4).
// Another theory of the sun, and no ERFA.
SunAngles meeus(Milliseconds when, const Place& place) {
  const auto rad = [](double degrees) { return degrees * M_PI / 180.0; };
  const double days = static_cast<double>(when) / static_cast<double>(kDay) + 2440587.5 - 2451545.0;
  const double t = days / 36525.0;
  const double longitude = 280.46646 + t * (36000.76983 + t * 0.0003032);
  const double anomaly = rad(357.52911 + t * (35999.05029 - t * 0.0001537));
  const double centre = (1.914602 - t * (0.004817 + t * 0.000014)) * std::sin(anomaly) +
                        (0.019993 - t * 0.000101) * std::sin(2 * anomaly) + 0.000289 * std::sin(3 * anomaly);
  const double node = rad(125.04 - 1934.136 * t);
  const double apparent = rad(longitude + centre - 0.00569 - 0.00478 * std::sin(node));
  const double obliquity = rad(23.4392911 - t * (0.0130042 + t * 1.6e-7) + 0.00256 * std::cos(node));
  const double right_ascension = std::atan2(std::cos(obliquity) * std::sin(apparent), std::cos(apparent));
  const double declination = std::asin(std::sin(obliquity) * std::sin(apparent));
  const double sidereal = rad(280.46061837 + 360.98564736629 * days + t * t * 0.000387933);
  const double hour = sidereal + rad(place.longitude_deg) - right_ascension;
  const double latitude = rad(place.latitude_deg);
  const double up =
      std::sin(latitude) * std::sin(declination) + std::cos(latitude) * std::cos(declination) * std::cos(hour);
  const double south =
      std::atan2(std::sin(hour), std::cos(hour) * std::sin(latitude) - std::tan(declination) * std::cos(latitude));
  const double azimuth = std::fmod(south * 180.0 / M_PI + 180.0 + 360.0, 360.0);
  return {std::asin(up) * 180.0 / M_PI, azimuth};
}

double around(double degrees) {
  return std::remainder(degrees, 360.0);
}

// The bound: 0.01 degrees of Meeus, 0.0024 of parallax, 0.005 of nutation in his sidereal time, and over centuries 0.02
// more of his. Both theories used here, from 1900 to 2100 and outside, are covered.
TEST(SunPosition, AgreesWithMeeusOverEightCenturies) {
  for (int year = kFirstYear; year <= kLastYear; year += 25) {
    for (const Place& place : {Place{48.85, 2.35}, Place{-33.9, 151.2}, Place{69.6, 18.9}, Place{0.0, -78.5}}) {
      for (int month = 1; month <= 12; month += 3) {
        const Milliseconds when = utc({year, month, 11}, 3 * month % 24, 17);
        const SunAngles ours = sun_angles(when, place);
        const SunAngles his = meeus(when, place);
        const double bound = year < 1900 || year > 2100 ? 0.04 : 0.02;
        EXPECT_NEAR(ours.elevation_deg, his.elevation_deg, bound) << iso_text(when, 0) << " " << place.latitude_deg;
        EXPECT_NEAR(around(ours.azimuth_deg - his.azimuth_deg) * std::cos(ours.elevation_deg * M_PI / 180.0), 0.0,
                    bound)
            << iso_text(when, 0) << " " << place.latitude_deg;
      }
    }
  }
}

// Years where one theory of the Earth's path replaces the other.
TEST(SunPosition, DoesNotJumpWhereTheTheoryChanges) {
  for (const int year : {1900, 2100}) {
    const Milliseconds change = utc({year, 1, 1}, 12, 0);
    for (Milliseconds when = change - 2 * kDay; when < change + 2 * kDay; when += kDay / 4) {
      const Place place{48.85, 2.35};
      const double before = sun_angles(when - 1000, place).elevation_deg;
      const double middle = sun_angles(when, place).elevation_deg;
      const double after = sun_angles(when + 1000, place).elevation_deg;
      EXPECT_NEAR(after - middle, middle - before, 0.005) << iso_text(when, 0);
    }
  }
}

TEST(SunPosition, RisesInTheEastAndStandsInTheSouthAtNoonOfTheNorth) {
  const Place paris{48.85, 2.35};
  EXPECT_NEAR(sun_angles(utc({2026, 3, 20}, 5, 58), paris).azimuth_deg, 90.0, 1.5);
  const SunAngles noon = sun_angles(utc({2026, 6, 21}, 11, 52, 30), paris);  // 12:00 less 9.4 min of longitude
  EXPECT_NEAR(noon.azimuth_deg, 180.0, 1.0);
  EXPECT_NEAR(noon.elevation_deg, 90.0 - 48.85 + 23.436, 0.01);
  const SunAngles sydney = sun_angles(utc({2026, 12, 21}, 1, 55), {-33.9, 151.2});
  EXPECT_NEAR(around(sydney.azimuth_deg), 0.0, 4.0);  // noon of the south: north
}

TEST(SunPosition, PolarDayPolarNightAndThePolesThemselves) {
  for (int hour = 0; hour < 24; ++hour) {
    EXPECT_GT(sun_angles(utc({2026, 6, 21}, hour, 0), {69.65, 18.96}).elevation_deg, 2.0);
    EXPECT_LT(sun_angles(utc({2026, 12, 21}, hour, 0), {69.65, 18.96}).elevation_deg, -2.0);
    for (const double pole : {90.0, -90.0}) {
      const SunAngles sun = sun_angles(utc({2026, 6, 21}, hour, 0), {pole, 0.0});
      EXPECT_TRUE(std::isfinite(sun.elevation_deg) && sun.azimuth_deg >= 0.0 && sun.azimuth_deg < 360.0);
      EXPECT_NEAR(std::abs(sun.elevation_deg), 23.436, 0.005);
    }
  }
}

TEST(SunPosition, LongitudesBeyondHalfTheEarthAreTheSamePlace) {
  const SunAngles a = sun_angles(utc({2026, 4, 4}, 4, 4), {10.0, 200.0});
  const SunAngles b = sun_angles(utc({2026, 4, 4}, 4, 4), {10.0, -160.0});
  EXPECT_NEAR(a.elevation_deg, b.elevation_deg, 1e-9);
  EXPECT_NEAR(a.azimuth_deg, b.azimuth_deg, 1e-9);
}

// The almanacs' refraction at the horizon is 34'; at 45 degrees 1'.
TEST(Refraction, IsTheAlmanacs) {
  const Air air;
  EXPECT_NEAR(refraction_deg(-34.0 / 60.0, air), 34.0 / 60.0, 0.02);
  EXPECT_NEAR(refraction_deg(45.0, air), 1.0 / 60.0, 0.001);
  EXPECT_NEAR(refraction_deg(90.0, air), 0.0, 1e-4);
  EXPECT_EQ(refraction_deg(-0.84, air), 0.0);
  EXPECT_NEAR(refraction_deg(10.0, {505.0, 10.0}), 0.5 * refraction_deg(10.0, air), 1e-12);
}

}  // namespace
}  // namespace airlight::sequence::test
