#pragma once
// The rule at the end of a time zone file, for the years after its list: POSIX's TZ, "CET-1CEST,M3.5.0,M10.5.0/3".

#include <cstdint>
#include <optional>
#include <string_view>

namespace airlight::sequence {

// A day of each year and a time on it.
struct YearlyMoment {
  enum class Kind { month_week_day, julian, day_of_year };
  Kind kind = Kind::month_week_day;
  int month = 1;    // month_week_day: 1 to 12
  int week = 1;     // 1 to 5, 5 the last
  int weekday = 0;  // 0 Sunday
  int day = 1;      // julian: 1 to 365, February 29 never counted; day_of_year: 0 to 365
  int time = 7200;  // s after midnight of the clock in force until then; may be negative or beyond the day
};

struct ZoneRule {
  int standard_offset = 0;  // s east of UTC
  bool has_summer = false;
  int summer_offset = 0;
  YearlyMoment summer_begins;
  YearlyMoment summer_ends;
};

// Nothing when the text is no such rule.
std::optional<ZoneRule> parse_zone_rule(std::string_view text);

// Seconds east of UTC; `utc` in s since 1970.
int offset_at(const ZoneRule& rule, std::int64_t utc);

}  // namespace airlight::sequence
