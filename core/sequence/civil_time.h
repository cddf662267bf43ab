#pragma once
// Dates, times of day and steps as people type them. Days follow the Gregorian calendar at all times.

#include <cstdint>
#include <string>
#include <string_view>

namespace airlight::sequence {

// Since 1970-01-01 00:00, 86400 s a day (no leap seconds), by UTC or by a local clock; variables' names tell which.
using Milliseconds = std::int64_t;

inline constexpr Milliseconds kSecond = 1000;
inline constexpr Milliseconds kDay = 86400 * kSecond;

// The years in which core/sequence/sun_position.h holds.
inline constexpr int kFirstYear = 1600;
inline constexpr int kLastYear = 2400;

struct CivilDate {
  int year = 1970;
  int month = 1;  // 1 to 12
  int day = 1;    // 1 to 31
};

Milliseconds midnight_of(const CivilDate& date);
CivilDate date_of(Milliseconds local);

// "2026-06-21" -> its midnight. `option` names the option in messages. Throws InputError: no date, a day that the
// calendar lacks, a year outside the two above.
Milliseconds parse_date(std::string_view text, const std::string& option);

// "05:00", "5:00:30", "24:00" -> since midnight, 0 to a day. Throws InputError.
Milliseconds parse_time_of_day(std::string_view text, const std::string& option);

// "5m", "90s", "1h30m", "0.5s" -> above 0. Throws InputError.
Milliseconds parse_step(std::string_view text, const std::string& option);

// "2026-06-21T05:00:00+02:00"; with ".250" where there are milliseconds, and "Z" for an offset of 0.
std::string iso_text(Milliseconds utc, int offset_seconds);

// "05:00", "05:00:30" where there are seconds: the time of day on the clock.
std::string clock_text(Milliseconds utc, int offset_seconds);

}  // namespace airlight::sequence
