// Lists of frames: sun paths, sweeps, key frames, shards.
#include "core/sequence/frame_list.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.h"

namespace airlight::sequence::test {
namespace {

SunPathOrder paris_day() {
  return {"2026-06-21", "05:00", "21:00", "5m", "Europe/Paris", {48.85, 2.35}};
}

std::string refusal(const SunPathOrder& order) {
  try {
    make_sun_path(order);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

std::string sweep_refusal(const std::string& text) {
  try {
    parse_sweep(text, "--sun-elevation");
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

double value_of(const Frame& frame, const std::string& pointer) {
  for (const auto& [key, values] : frame.keys) {
    if (key == pointer) return values.front();
  }
  ADD_FAILURE() << "no " << pointer;
  return 0.0;
}

TEST(SunPaths, CountBothEnds) {
  const FrameSource source = make_sun_path(paris_day());
  ASSERT_EQ(frame_count(source), 193U);
  const Frame first = frame_at(source, 0);
  EXPECT_EQ(first.number, 1);
  EXPECT_EQ(iso_text(first.time->utc, first.time->offset_seconds), "2026-06-21T05:00:00+02:00");
  const Frame last = frame_at(source, 192);
  EXPECT_EQ(iso_text(last.time->utc, last.time->offset_seconds), "2026-06-21T21:00:00+02:00");
  const SunAngles sun = sun_angles(last.time->utc, {48.85, 2.35});
  EXPECT_NEAR(value_of(last, "/sun/elevation_deg"), sun.elevation_deg, 1e-6);
  EXPECT_NEAR(value_of(last, "/sun/azimuth_deg"), sun.azimuth_deg, 1e-6);
}

// A year by the hour, over both changes of the clocks.
TEST(SunPaths, GoOnForDays) {
  SunPathOrder order{"2026-01-01", "00:30", "23:30", "1h", "Europe/Paris", {48.85, 2.35}};
  order.until = "2026-12-31";
  const FrameSource source = make_sun_path(order);
  ASSERT_EQ(frame_count(source), 8760U);
  const std::optional<FrameTime> summer = frame_time(source, 4700);
  EXPECT_EQ(iso_text(summer->utc, summer->offset_seconds), "2026-07-15T21:30:00+02:00");
  order.until = "2025-12-31";
  EXPECT_EQ(refusal(order),
            "sequence: --until 2025-12-31: it ends before it begins, on 2026-01-01 at 00:30; give a later date");
  order.until = "2026-02-30";
  EXPECT_NE(refusal(order).find("sequence: --until"), std::string::npos);
}

// By the time since the first frame, whichever frames are asked for; a field that repeats itself stays near.
TEST(SunPaths, HaveWind) {
  SunPath path = make_sun_path(paris_day());  // every five minutes
  path.winds = {{.pointer = "/clouds/0", .from = {2.0, -3.0}, .speed = {10.0, -20.0}},
                {.pointer = "/clouds/2", .from = {0.5, 0.0}, .speed = {10.0, 0.0}, .period = {16.0, 16.0}}};
  const FrameSource source = path;
  EXPECT_EQ(value_of(frame_at(source, 0), "/clouds/0/east_km"), 2.0);
  EXPECT_EQ(value_of(frame_at(source, 0), "/clouds/2/east_km"), 0.5);
  for (const std::size_t index : {192U, 1U, 7U}) {
    const double seconds = 300.0 * static_cast<double>(index);
    const Frame frame = frame_at(source, index);
    EXPECT_NEAR(value_of(frame, "/clouds/0/east_km"), 2.0 + 0.01 * seconds, 1e-9);
    EXPECT_NEAR(value_of(frame, "/clouds/0/north_km"), -3.0 - 0.02 * seconds, 1e-9);
    const double east = value_of(frame, "/clouds/2/east_km");
    EXPECT_LE(std::abs(east - 0.5), 8.0);
    EXPECT_NEAR(std::remainder(east - 0.5 - 0.01 * seconds, 16.0), 0.0, 1e-9);
    EXPECT_EQ(value_of(frame, "/clouds/2/north_km"), 0.0);
  }
}

TEST(SunPaths, RefractionIsOffUnlessAsked) {
  SunPathOrder order = paris_day();
  order.from = "06:00";
  const double plain = value_of(frame_at(make_sun_path(order), 0), "/sun/elevation_deg");
  order.refraction = Air{};
  const double lifted = value_of(frame_at(make_sun_path(order), 0), "/sun/elevation_deg");
  EXPECT_NEAR(lifted - plain, refraction_deg(plain, Air{}), 1e-5);
  EXPECT_GT(lifted - plain, 0.1);
}

TEST(SunPaths, OverMidnightOneFrameAndAStepLongerThanTheDay) {
  SunPathOrder order = paris_day();
  order.from = "22:00";
  order.to = "02:00";
  order.step = "1h";
  EXPECT_EQ(frame_count(make_sun_path(order)), 5U);
  order.from = order.to = "12:00";
  EXPECT_EQ(frame_count(make_sun_path(order)), 1U);
  order.to = "13:00";
  order.step = "30h";
  EXPECT_EQ(frame_count(make_sun_path(order)), 1U);
  order.from = "00:00";
  order.to = "24:00";
  order.step = "6h";
  EXPECT_EQ(frame_count(make_sun_path(order)), 5U);
}

// On the night of the change the clock jumps but the sun does not: steps are in real time.
TEST(SunPaths, StepsAreOfRealTimeOverAChangeOfTheClocks) {
  SunPathOrder order = paris_day();
  order.date = "2026-03-29";
  order.from = "01:00";
  order.to = "04:00";
  order.step = "1h";
  const SunPath path = make_sun_path(order);
  EXPECT_EQ(path.count, 3U);
  const Frame last = frame_at(path, 2);
  EXPECT_EQ(iso_text(last.time->utc, last.time->offset_seconds), "2026-03-29T04:00:00+02:00");
  order.from = "02:30";
  EXPECT_NE(refusal(order).find("the clocks of Europe/Paris skip 2026-03-29T02:30"), std::string::npos);
}

TEST(SunPaths, RefusePlacesThatAreNone) {
  SunPathOrder order = paris_day();
  order.place.latitude_deg = 90.5;
  EXPECT_NE(refusal(order).find("--lat: 90.5 is outside -90 to 90"), std::string::npos);
  order = paris_day();
  order.place.longitude_deg = -181;
  EXPECT_NE(refusal(order).find("--lon: -181 is outside -180 to 360"), std::string::npos);
}

TEST(Sweeps, BothWaysAndWithoutRoundingErrors) {
  const Sweep up = parse_sweep("-12:90:1", "--sun-elevation");
  EXPECT_EQ(up.count, 103U);
  EXPECT_EQ(value_of(frame_at(up, 102), "/sun/elevation_deg"), 90.0);
  const Sweep fine = parse_sweep("0:1:0.1", "--sun-elevation");
  EXPECT_EQ(fine.count, 11U);
  EXPECT_EQ(value_of(frame_at(fine, 3), "/sun/elevation_deg"), 0.3);
  const Sweep down = parse_sweep("5:-5:-2.5", "--sun-elevation");
  EXPECT_EQ(down.count, 5U);
  EXPECT_EQ(value_of(frame_at(down, 4), "/sun/elevation_deg"), -5.0);
  EXPECT_EQ(parse_sweep("3:3:1", "--sun-elevation").count, 1U);
}

TEST(Sweeps, RefuseWhatIsNone) {
  for (const char* text : {"", "5", "1:2", "1:2:3:4", "a:2:1", "1:2:x", "1:2:", "nan:2:1", "1 :2:1"}) {
    EXPECT_NE(sweep_refusal(text).find("is not FROM:TO:STEP"), std::string::npos) << text;
  }
  EXPECT_NE(sweep_refusal("0:10:0").find("steps of 0 never get from 0 to 10"), std::string::npos);
  EXPECT_NE(sweep_refusal("0:10:-1").find("never get from"), std::string::npos);
  EXPECT_NE(sweep_refusal("0:91:1").find("91 is outside -90 to 90"), std::string::npos);
}

TEST(KeyFrameLists, InterpolateEachKeyBetweenTheFramesThatHaveIt) {
  KeyFrames sequence;
  sequence.frames = {{10, {{"/a", {0.0}}, {"/s", {1.0}}}},
                     {12, {{"/w", {2.0}}}},
                     {14, {{"/a", {4.0}}}},
                     {15, {{"/s", {1.0, 2.0, 6.0}}, {"/w", {4.0}}}}};
  sequence.whole = {"/w"};
  ASSERT_EQ(frame_count(sequence), 6U);
  const auto at = [&](std::size_t index, const std::string& pointer) {
    return value_of(frame_at(sequence, index), pointer);
  };
  EXPECT_EQ(frame_at(sequence, 0).number, 10);
  EXPECT_EQ(at(0, "/a"), 0.0);
  EXPECT_EQ(at(1, "/a"), 1.0);
  EXPECT_EQ(at(2, "/a"), 2.0);  // the frame at 12 says nothing about it
  EXPECT_EQ(at(5, "/a"), 4.0);  // stays after the last
  EXPECT_EQ(at(0, "/w"), 2.0);  // and before the first
  EXPECT_EQ(at(3, "/w"), 3.0);  // 2.67, rounded
  const Frame last = frame_at(sequence, 5);
  const auto spectrum = std::ranges::find(last.keys, "/s", [](const auto& key) { return key.first; });
  ASSERT_NE(spectrum, last.keys.end());
  EXPECT_EQ(spectrum->second, (std::vector<double>{1.0, 2.0, 6.0}));
}

TEST(Shards, PartTheFrames) {
  for (const std::size_t frames : {0U, 1U, 5U, 16U, 100U}) {
    std::vector<int> seen(frames);
    for (std::size_t i = 1; i <= 16; ++i) {
      const Shard shard{i, 16};
      for (std::size_t k = 0; k < shard_size(shard, frames); ++k) ++seen.at(shard_frame(shard, k));
    }
    EXPECT_TRUE(std::ranges::all_of(seen, [](int count) { return count == 1; })) << frames;
  }
  EXPECT_EQ(shard_frame(parse_shard("3/16", ""), 1), 18U);  // the 19th frame
  for (const char* text : {"", "3", "0/4", "5/4", "1/0", "a/b", "1/2/3", "-1/2", "1/ 2"}) {
    EXPECT_THROW(parse_shard(text, ""), InputError) << text;
  }
}

}  // namespace
}  // namespace airlight::sequence::test
