// What a date adds to a preset.
#include "core/library/place.h"

#include <gtest/gtest.h>

#include "core/library/built_in.h"
#include "core/methods/method.h"
#include "core/scene/angle.h"
#include "core/scene/resolve.h"

namespace airlight::test {
namespace {

// UTC, in Paris: the sun high, and some degrees below the horizon with the moon up.
constexpr const char* kNoon = "12:00";
constexpr const char* kDawn = "04:30";

Scene dated(const std::string& name, const std::string& time, const std::vector<std::string>& set = {}) {
  SceneChanges changes;
  changes.set = set;
  PlaceOptions place;
  place.date = "2026-09-02";
  place.time = time;
  place.latitude = 48.85;
  place.longitude = 2.35;
  Preset preset = built_in_preset(name, "test");
  apply_changes(preset, changes, sun_overrides(place, changes, "test"));
  leave_out_unseen(preset);
  return resolve(preset, method_infos());
}

TEST(SkyOfDate, AddsMoonAndStarsToEarth) {
  const Scene scene = dated("earth", kDawn);
  ASSERT_TRUE(scene.moon);
  EXPECT_TRUE(scene.night_sky);
  EXPECT_TRUE(scene.stars);
  EXPECT_NEAR(scene.camera.julian_date, 2461285.6875, 1e-4);
  EXPECT_NEAR(scene.camera.latitude, radians_from_degrees(48.85), 1e-12);
  // As a preset that has a moon of its own.
  const Scene own = dated("full-day", kDawn);
  EXPECT_EQ(scene.moon->elevation, own.moon->elevation);
  EXPECT_EQ(scene.moon->lit.phase, own.moon->lit.phase);
}

TEST(SkyOfDate, LeavesOutByDayWhatCannotBeSeen) {
  const Scene noon = dated("earth", kNoon);
  EXPECT_FALSE(noon.night_sky);
  EXPECT_TRUE(noon.stars);
}

// The moon is 15 degrees below the level: under the horizon of the ground, over that of 500 km.
TEST(SkyOfDate, KeepsAMoonThatTheCameraSeesFromItsHeight) {
  constexpr const char* kDusk = "18:00";
  const std::vector<std::string> dated_sky{"/sky_of_date=true"};
  EXPECT_FALSE(dated("earth", kDusk, dated_sky).moon);
  EXPECT_TRUE(dated("orbit", kDusk, dated_sky).moon);
  EXPECT_TRUE(dated("earth", kDusk, {"/sky_of_date=true", "/camera/altitude_km=500"}).moon);
}

// In a sequence each frame leaves out what it cannot show.
TEST(SkyOfDate, LeavesOutOfAFrameWhatItCannotShow) {
  const auto frame = [](const char* name, double sun, double moon, const std::vector<std::string>& set) {
    SceneChanges changes;
    Preset preset = built_in_preset(name, "test");
    changes.set = set;
    apply_changes(preset, changes, sky_of_date("--date 2026-09-02"));
    for (const auto& [key, degrees] : {std::pair("/sun/elevation_deg", sun), std::pair("/moon/elevation_deg", moon)}) {
      PresetValue value;
      value.data = degrees;
      put_value(preset, key, std::move(value), "frame 1");
    }
    leave_out_unseen(preset);
    Scene scene = resolve(preset, method_infos());
    leave_out_outshone(scene);
    return scene;
  };
  const Scene day = frame("earth", 20.0, 5.0, {});
  EXPECT_FALSE(day.night_sky);
  EXPECT_TRUE(day.moon && day.stars);
  const Scene night = frame("earth", -20.0, -30.0, {});
  EXPECT_TRUE(night.night_sky && night.stars);
  EXPECT_FALSE(night.moon);
  // What the preset has itself goes as well, but for what can be seen.
  const Scene own = frame("full-day", 20.0, -30.0, {});
  EXPECT_FALSE(own.night_sky || own.moon);
  EXPECT_TRUE(own.stars);
  EXPECT_TRUE(frame("full-day", -1.0, 5.0, {}).night_sky);
  EXPECT_TRUE(frame("full-day", -1.0, -9.0, {}).moon);
  EXPECT_TRUE(frame("full-day", 20.0, 5.0, {"/night_sky/light_pollution_cd_per_m2=100"}).night_sky);
  EXPECT_TRUE(frame("full-day", 20.0, 5.0, {"/night_sky/airglow=1000"}).night_sky);
  EXPECT_TRUE(frame("full-day", 20.0, 5.0, {"/sun/irradiance=0.1"}).night_sky);
  EXPECT_TRUE(frame("full-day", 20.0, 5.0, {"/camera/altitude_km=400"}).night_sky);
  EXPECT_TRUE(frame("full-day", 20.0, -15.0, {"/camera/altitude_km=400"}).moon);
}

TEST(SkyOfDate, IsForPresetsThatAskForIt) {
  EXPECT_FALSE(dated("mars-like", kDawn).moon);
  EXPECT_FALSE(dated("earth-hillaire2020", kDawn).stars);
  const Scene off = dated("earth", kDawn, {"/sky_of_date=false"});
  EXPECT_FALSE(off.moon || off.night_sky || off.stars);
  const Scene on = dated("earth-hillaire2020", kDawn, {"/sky_of_date=true"});
  EXPECT_TRUE(on.moon && on.night_sky && on.stars);
}

TEST(SkyOfDate, KeepsWhatThePresetHas) {
  SceneChanges changes;
  Preset preset = built_in_preset("earth", "test");
  apply_override(preset, "/stars/magnitude_limit=4");
  apply_changes(preset, changes, sky_of_date("--date"));
  const Scene scene = resolve(preset, method_infos());
  EXPECT_EQ(scene.stars->magnitude_limit, 4.0);
  EXPECT_TRUE(scene.moon);
}

}  // namespace
}  // namespace airlight::test
