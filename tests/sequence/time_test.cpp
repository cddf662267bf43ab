// Dates, times, steps and zones: accepted texts, refusals, and every offset against the C library's.
#include <gtest/gtest.h>
#include <time.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "core/base/error.h"
#include "core/sequence/time_zone.h"

namespace airlight::sequence::test {
namespace {

template <class Call>
std::string time_refusal(const Call& call) {
  try {
    call();
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(Dates, ComeBackAndFollowTheCalendar) {
  for (const char* text : {"1600-02-29", "1899-12-31", "1970-01-01", "2000-02-29", "2026-06-21", "2400-12-31"}) {
    EXPECT_EQ(iso_text(parse_date(text, "--date"), 0), std::string(text) + "T00:00:00Z");
  }
  EXPECT_EQ(parse_date("1900-03-01", "--date") - parse_date("1900-02-28", "--date"), kDay);  // no leap year
}

TEST(Dates, RefuseWhatTheCalendarLacks) {
  for (const char* text : {"", "2026", "2026-6-21", "21.06.2026", "2026-06-21x", "2026-06", "-026-06-21"}) {
    EXPECT_TRUE(contains(time_refusal([&] { parse_date(text, "--date"); }), "write YYYY-MM-DD")) << text;
  }
  for (const char* text : {"2026-02-29", "2026-13-01", "2026-00-10", "2026-04-31"}) {
    EXPECT_TRUE(contains(time_refusal([&] { parse_date(text, "--date"); }), "has no day")) << text;
  }
  EXPECT_TRUE(contains(time_refusal([] { parse_date("1582-10-15", "--date"); }), "1582 is outside 1600 to 2400"));
}

TEST(Times, OfDay) {
  EXPECT_EQ(parse_time_of_day("05:00", "--from"), 5 * 3600 * kSecond);
  EXPECT_EQ(parse_time_of_day("5:07:09", "--from"), (5 * 3600 + 7 * 60 + 9) * kSecond);
  EXPECT_EQ(parse_time_of_day("24:00", "--to"), kDay);
  for (const char* text : {"", "5", "25:00", "24:01", "05:60", "05:00:60", "05:0", "-1:00", "5 pm", "05:00:00:00"}) {
    EXPECT_TRUE(contains(time_refusal([&] { parse_time_of_day(text, "--from"); }), "is not a time of day")) << text;
  }
}

TEST(Steps, WithTheirUnits) {
  EXPECT_EQ(parse_step("5m", "--step"), 300 * kSecond);
  EXPECT_EQ(parse_step("1h30m", "--step"), 5400 * kSecond);
  EXPECT_EQ(parse_step("90s", "--step"), 90 * kSecond);
  EXPECT_EQ(parse_step("0.25s", "--step"), 250);
  for (const char* text : {"", "5", "m", "5x", "-5m", "5 m", "1e400s", "inf"}) {
    EXPECT_TRUE(contains(time_refusal([&] { parse_step(text, "--step"); }), "is not a length of time")) << text;
  }
  for (const char* text : {"0s", "0m", "0.0001s"}) {
    EXPECT_TRUE(contains(time_refusal([&] { parse_step(text, "--step"); }), "never gets from --from to --to")) << text;
  }
}

TEST(Texts, OfMoments) {
  const Milliseconds when = parse_date("2026-06-21", "") + parse_time_of_day("03:00", "");
  EXPECT_EQ(iso_text(when, 7200), "2026-06-21T05:00:00+02:00");
  EXPECT_EQ(iso_text(when + 250, -12600), "2026-06-20T23:30:00.250-03:30");
  EXPECT_EQ(iso_text(when, 561), "2026-06-21T03:09:21+00:09:21");
  EXPECT_EQ(clock_text(when, 7200), "05:00");
  EXPECT_EQ(clock_text(when + 1000, 0), "03:00:01");
}

// glibc reads the same files by code of its own. Both hemispheres, half hours, a zone of many changes, one without
// summer time, one whose footer has a time beyond the day; before the first change and after the last.
TEST(Zones, HaveTheOffsetsOfTheCLibrary) {
  for (const char* name :
       {"Europe/Paris", "America/New_York", "Australia/Lord_Howe", "Asia/Kolkata", "Africa/Cairo", "Africa/Casablanca",
        "Asia/Tokyo", "America/Nuuk", "Pacific/Apia", "Europe/Dublin", "America/Santiago", "Asia/Gaza"}) {
    const TimeZone zone = find_zone(name, "--tz");
    ::setenv("TZ", (std::string(":") + name).c_str(), 1);
    ::tzset();
    int different = 0;
    for (std::int64_t seconds = -12000000000; seconds < 14000000000; seconds += 1234567) {
      const time_t when = seconds;
      tm fields{};
      ::localtime_r(&when, &fields);
      different += offset_at(zone, seconds * kSecond) == fields.tm_gmtoff ? 0 : 1;
    }
    EXPECT_EQ(different, 0) << name;
  }
  ::unsetenv("TZ");
  ::tzset();
}

TEST(Zones, FixedOffsets) {
  EXPECT_EQ(offset_at(find_zone("+02:00", ""), 0), 7200);
  EXPECT_EQ(offset_at(find_zone("-0330", ""), 0), -12600);
  EXPECT_EQ(offset_at(find_zone("+5:45", ""), 0), 20700);
  EXPECT_EQ(offset_at(find_zone("-3", ""), 0), -10800);
  EXPECT_EQ(offset_at(find_zone("UTC", ""), 0), 0);
  for (const char* name : {"+", "+16", "+02:60", "+2:0", "+12345", "+02:00x", "2"}) {
    EXPECT_NE(time_refusal([&] { find_zone(name, "--tz"); }), "") << name;
  }
}

TEST(Zones, UnknownOnesAreRefusedWithTheNearest) {
  const std::string typo = time_refusal([] { find_zone("Europe/Pariss", "--tz"); });
  EXPECT_TRUE(contains(typo, "--tz: no time zone 'Europe/Pariss'")) << typo;
  EXPECT_TRUE(contains(typo, "did you mean 'Europe/Paris'?")) << typo;
  EXPECT_EQ(typo.find('\n'), std::string::npos);
  for (const char* name :
       {"", "/etc/passwd", "../zoneinfo/UTC", "Europe", "Europe/../UTC", "zone.tab", "posixrules2"}) {
    EXPECT_TRUE(contains(time_refusal([&] { find_zone(name, "--tz"); }), "no time zone '")) << name;
  }
  const std::string none = time_refusal([] { find_zone("Europe/Paris", "--tz", "/nowhere"); });
  EXPECT_TRUE(contains(none, "tzdata") && contains(none, "/nowhere")) << none;
}

TEST(Zones, ADamagedFileIsRefusedWhereverItIsCut) {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "airlight_zones";
  std::filesystem::create_directories(folder);
  std::ifstream whole(std::filesystem::path(kZoneFolder) / "Europe/Paris", std::ios::binary);
  const std::string data{std::istreambuf_iterator<char>(whole), std::istreambuf_iterator<char>()};
  ASSERT_GT(data.size(), 200U);
  for (std::size_t length = 4; length + 30 < data.size(); length += 7) {
    const std::string name = "Cut" + std::to_string(length);  // a name that was read once is remembered
    std::ofstream(folder / name, std::ios::binary) << data.substr(0, length);
    EXPECT_TRUE(contains(time_refusal([&] { find_zone(name, "--tz", folder); }), "is damaged")) << length;
  }
  std::filesystem::remove_all(folder);
}

TEST(Zones, ClocksThatSkipAnHourAndShowOneTwice) {
  const TimeZone paris = find_zone("Europe/Paris", "");
  const auto at = [&](const char* date, const char* time) {
    return utc_of(paris, parse_date(date, "") + parse_time_of_day(time, ""));
  };
  EXPECT_FALSE(at("2026-03-29", "02:30").has_value());
  EXPECT_EQ(iso_text(*at("2026-03-29", "03:00"), 0), "2026-03-29T01:00:00Z");
  EXPECT_EQ(iso_text(*at("2026-10-25", "02:30"), 0), "2026-10-25T00:30:00Z");  // the earlier one
  EXPECT_EQ(iso_text(*at("2026-06-21", "05:00"), 0), "2026-06-21T03:00:00Z");
  EXPECT_EQ(iso_text(*at("1850-06-21", "12:00"), 0), "1850-06-21T11:50:39Z");  // local mean time
}

}  // namespace
}  // namespace airlight::sequence::test
