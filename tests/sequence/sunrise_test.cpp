// Sunrise and sunset over the sea by the air of the preset `earth`, against published times.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <string>

#include "core/air/refraction.h"
#include "core/methods/method.h"
#include "core/scene/angle.h"
#include "core/scene/preset.h"
#include "core/scene/resolve.h"
#include "core/sequence/sun_position.h"

namespace airlight::sequence::test {
namespace {

struct Event {
  const char* source;
  Place place;
  CivilDate date;
  int hour;  // UTC
  int minute;
  int second;
  bool rises;
};

// Almanacs put both where the disc's centre is 50' below the horizontal: 34' of refraction and 16' of radius.
//   SPA: Reda and Andreas, NREL/TP-560-34302 (2003, revised 2008), what their program prints of the example of table
//   A5.1; its sunset is that of the day of UTC, which is the evening before.
//   pvlib: values of NREL's web calculator of the same algorithm, in the tests of pvlib-python (test_solarposition.py).
//   Skyfield: its manual, "Almanac Computation", by the ephemeris DE421.
const Event kPublished[] = {
    {"SPA", {39.742476, -105.1786}, {2003, 10, 17}, 13, 12, 43, true},
    {"SPA", {39.742476, -105.1786}, {2003, 10, 17}, 0, 20, 19, false},
    {"Skyfield", {40.8939, -83.8917}, {2018, 9, 12}, 11, 13, 13, true},
    {"Skyfield", {40.8939, -83.8917}, {2018, 9, 12}, 23, 49, 38, false},
    {"pvlib", {-35.0, 0.0}, {1996, 7, 5}, 7, 8, 15, true},
    {"pvlib", {-35.0, 0.0}, {1996, 7, 5}, 17, 1, 4, false},
    {"pvlib", {-35.0, 0.0}, {2004, 12, 4}, 4, 38, 57, true},
    {"pvlib", {-35.0, 0.0}, {2004, 12, 4}, 19, 2, 3, false},
};

constexpr double kRadiusDeg = 16.0 / 60.0;

Milliseconds told(const Event& event) {
  return midnight_of(event.date) + (event.hour * 3600 + event.minute * 60 + event.second) * kSecond;
}

// When the sun's centre passes this geometric elevation, within five minutes of what is told.
Milliseconds when_at(const Event& event, double elevation_deg) {
  Milliseconds low = told(event) - 300 * kSecond;
  Milliseconds high = told(event) + 300 * kSecond;
  while (high - low > 10) {
    const Milliseconds middle = low + (high - low) / 2;
    const bool above = sun_angles(middle, event.place).elevation_deg > elevation_deg;
    (above == event.rises ? high : low) = middle;
  }
  return low;
}

// The geometric elevation of a light that is seen on the sea's horizon, from its surface.
double seen_on_the_horizon_deg(const std::string& preset) {
  const Scene scene =
      resolve(load_preset(std::string(AIRLIGHT_SOURCE_DIR "/presets/") + preset + ".json"), method_infos());
  physics::Physics p;
  put_planet(p, scene.planet);
  p.scene.camera.altitude = 0.0;
  double low = -2.0;
  double high = 0.0;
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (low + high);
    const double up = std::sin(middle * kDegree);
    const SeenDirection seen = seen_direction(p, {std::cos(middle * kDegree), up, 0.0});
    (seen.direction.y > 1e-9 ? high : low) = middle;
  }
  return high;
}

TEST(Sunrise, OverTheSeaIsTheAlmanacs) {
  const double horizon = seen_on_the_horizon_deg("earth");
  EXPECT_NEAR(-60.0 * horizon, 33.03, 0.1);  // minutes of arc, by the US standard atmosphere of 1976 and 2.78e-4
  for (const Event& event : kPublished) {
    const std::string name = std::string(event.source) + (event.rises ? " rise " : " set ") + iso_text(told(event), 0);
    const double convention = static_cast<double>(when_at(event, -50.0 / 60.0) - told(event)) / kSecond;
    const double own = static_cast<double>(when_at(event, horizon - kRadiusDeg) - told(event)) / kSecond;
    std::printf("%s: %+.1f s by 50', %+.1f s by the preset's air\n", name.c_str(), convention, own);
    EXPECT_NEAR(convention, 0.0, 2.5) << name;  // UT1 is taken for UTC
    EXPECT_NEAR(own, 0.0, 15.0) << name;
    // Less refraction: later up, earlier down.
    EXPECT_GT(event.rises ? own - convention : convention - own, 0.0) << name;
  }
}

// Straight rays, which published skies have, miss by three minutes.
TEST(Sunrise, IsMissedByStraightRays) {
  const double horizon = seen_on_the_horizon_deg("earth-hillaire2020");
  EXPECT_NEAR(horizon, 0.0, 1e-6);
  const Event& event = kPublished[0];
  EXPECT_GT(when_at(event, horizon - kRadiusDeg) - told(event), 150 * kSecond);
}

}  // namespace
}  // namespace airlight::sequence::test
