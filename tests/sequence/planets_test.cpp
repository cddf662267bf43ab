// Where the planets stand and how bright they are, against published events.

#include "core/night/planets.h"

#include <erfa.h>
#include <erfam.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

#include "core/night/celestial.h"
#include "core/sequence/sun_position.h"

namespace airlight::sequence {
namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;

PlanetInSky planet(std::string_view name, double julian_date) {
  for (const PlanetInSky& found : planets_at(julian_date)) {
    if (found.name == name) {
      return found;
    }
  }
  ADD_FAILURE() << name;
  return {};
}

double apart(const physics::vec3& a, const physics::vec3& b) {
  return 2.0 * std::asin(0.5 * physics::length(a - b)) * kDegrees;
}

// The sun seen from the earth's centre, J2000, without aberration: it hardly moves while its light is on the way.
physics::vec3 sun(double julian_date) {
  double from_sun[2][3], from_barycentre[2][3];
  (void)eraEpv00(julian_date, 0.0, from_sun, from_barycentre);
  return physics::normalize(physics::vec3(-from_sun[0][0], -from_sun[0][1], -from_sun[0][2]));
}

// Meeus, Astronomical Algorithms, example 33.a: 20 December 1992, 0 h of terrestrial time; apparent place of the date.
TEST(Planets, VenusAgreesWithAPublishedExample) {
  const double date = 2448976.5 - 59.0 / ERFA_DAYSEC;
  const PlanetInSky venus = planet("Venus", date);
  const CelestialFrame frame = celestial_frame(date, 0.0, 0.0);
  const physics::vec3 seen = physics::normalize(venus.star.j2000 + frame.aberration);
  double turned[3][3], of_date[3];
  double place[3] = {seen.x, seen.y, seen.z};
  eraPnm06a(2448976.5, 0.0, turned);
  eraRxp(turned, place, of_date);
  EXPECT_NEAR(eraAnp(std::atan2(of_date[1], of_date[0])) * kDegrees, 316.17291, 0.003);
  EXPECT_NEAR(std::asin(of_date[2]) * kDegrees, -18.88801, 0.003);
}

// JPL Horizons (DE441), 18 March 2023, 12 h TDB: from the sun along J2000's ecliptic, km and km/s.
struct State {
  const char* name;
  physics::vec3 at;
  physics::vec3 velocity;
};
const State kEarth{"Earth", {-1.487154929e8, 7.003100927e6, 8.447504e2}, {-1.893868, -29.878421, 0.001375}};
const State kStates[] = {{"Mercury", {5.268563421e7, 1.158560366e6, -4.737898529e6}, {-10.479165, 50.879197, 5.119055}},
                         {"Venus", {1.378043765e7, 1.068360337e8, 6.716190241e5}, {-34.852439, 4.303377, 2.070160}},
                         {"Mars", {-1.362257852e8, 2.038506360e8, 7.613881365e6}, {-19.229447, -11.400983, 0.232747}},
                         {"Jupiter", {6.994074369e8, 2.435976789e8, -1.665986411e7}, {-4.454217, 12.966936, 0.045830}},
                         {"Saturn", {1.249891679e9, -7.699558729e8, -3.635347604e7}, {4.527060, 8.216948, -0.322427}}};

TEST(Planets, StandWhereHorizonsHasThem) {
  constexpr double kTerrestrialMinusUtc = 69.184;
  constexpr double kLightSpeed = 299792.458;  // km/s
  for (const State& state : kStates) {
    const double seconds = physics::length(state.at - kEarth.at) / kLightSpeed;
    const physics::vec3 v = physics::normalize(state.at - state.velocity * seconds - kEarth.at);
    const double tilt = 84381.406 * ERFA_DAS2R;
    const physics::vec3 there(v.x, v.y * std::cos(tilt) - v.z * std::sin(tilt),
                              v.y * std::sin(tilt) + v.z * std::cos(tilt));
    EXPECT_LT(apart(planet(state.name, 2460022.0 - kTerrestrialMinusUtc / ERFA_DAYSEC).star.j2000, there), 0.003)
        << state.name;
  }
}

// Both planets before the sun's disc: 76 arc seconds from its middle on 11 November 2019, 15:20 (Mercury), 554 on 6
// June 2012, 1:30 (Venus), by NASA's predictions.
TEST(Planets, CrossTheSunWhenTheyDid) {
  EXPECT_NEAR(apart(planet("Mercury", 2458799.1388).star.j2000, sun(2458799.1388)), 76.0 / 3600.0, 5e-4);
  EXPECT_NEAR(apart(planet("Venus", 2456084.5622).star.j2000, sun(2456084.5622)), 554.0 / 3600.0, 5e-4);
}

// The great conjunction: 6.1 arc minutes apart on 21 December 2020, 18:20.
TEST(Planets, JupiterMetSaturn) {
  const double date = 2459205.2639;
  EXPECT_NEAR(apart(planet("Jupiter", date).star.j2000, planet("Saturn", date).star.j2000), 6.1 / 60.0, 0.003);
}

// Mars at its nearest in 60 000 years, 28 August 2003: -2.88, by the side it turns to us 0.05 more or less; Jupiter in
// opposition, 26 September 2022: -2.94; Venus at its brightest, 28 April 2020; Saturn with open rings, 15 June 2017.
TEST(Planets, AreAsBrightAsTheyWere) {
  EXPECT_NEAR(planet("Mars", 2452879.9).star.magnitude, -2.88, 0.1);
  EXPECT_NEAR(planet("Jupiter", 2459849.3).star.magnitude, -2.94, 0.05);
  EXPECT_NEAR(planet("Venus", 2458967.5).star.magnitude, -4.7, 0.1);
  EXPECT_NEAR(planet("Saturn", 2457919.9).star.magnitude, 0.0, 0.1);
}

TEST(StarNames, AreFoundInTheCatalogue) {
  std::set<std::string_view> named;
  for (const CatalogueStar& star : bright_stars()) {
    named.insert(star_name(star));
  }
  EXPECT_EQ(named.size(), 36U + 1U);  // and those without a name
  EXPECT_EQ(star_name(bright_stars().front()), "Sirius");
}

}  // namespace
}  // namespace airlight::sequence
