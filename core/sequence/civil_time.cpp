#include "core/sequence/civil_time.h"

#include <charconv>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <optional>
#include <vector>

#include "core/base/error.h"
#include "core/base/text.h"

namespace airlight::sequence {
namespace {

namespace chrono = std::chrono;

// The whole text as a whole number of `fewest` to `most` digits; else none.
std::optional<int> digits(std::string_view text, std::size_t fewest, std::size_t most) {
  const bool fits = text.size() >= fewest && text.size() <= most && !text.starts_with('-');
  return fits ? number_from<int>(text) : std::nullopt;
}

std::string quote(std::string_view text) {
  return "'" + std::string(text) + "'";
}

constexpr Milliseconds kHour = 3600 * kSecond;
constexpr Milliseconds kMinute = 60 * kSecond;

// Milliseconds of a unit; 0: no unit of ours.
Milliseconds unit_of(char letter) {
  return letter == 'h' ? kHour : letter == 'm' ? kMinute : letter == 's' ? kSecond : 0;
}

// "1h30m" -> its length; none when it is not made of numbers with units.
std::optional<Milliseconds> length_of(std::string_view text) {
  constexpr double kLongest = 1000.0 * 366.0 * static_cast<double>(kDay);
  double total = 0.0;
  while (!text.empty()) {
    double number = 0.0;
    const auto parsed = std::from_chars(text.data(), text.data() + text.size(), number, std::chars_format::fixed);
    const auto taken = static_cast<std::size_t>(parsed.ptr - text.data());
    if (parsed.ec != std::errc() || taken == text.size() || unit_of(text[taken]) == 0 || number < 0.0) {
      return std::nullopt;
    }
    total += number * static_cast<double>(unit_of(text[taken]));
    text.remove_prefix(taken + 1);
  }
  return total <= kLongest ? std::optional(static_cast<Milliseconds>(std::llround(total))) : std::nullopt;
}

}  // namespace

Milliseconds midnight_of(const CivilDate& date) {
  const chrono::sys_days days = chrono::year(date.year) / chrono::month(static_cast<unsigned>(date.month)) /
                                chrono::day(static_cast<unsigned>(date.day));
  return static_cast<Milliseconds>(days.time_since_epoch().count()) * kDay;
}

CivilDate date_of(Milliseconds local) {
  const chrono::sys_days days =
      chrono::floor<chrono::days>(chrono::sys_time<chrono::milliseconds>(chrono::milliseconds(local)));
  const chrono::year_month_day date(days);
  return {static_cast<int>(date.year()), static_cast<int>(static_cast<unsigned>(date.month())),
          static_cast<int>(static_cast<unsigned>(date.day()))};
}

Milliseconds parse_date(std::string_view text, const std::string& option) {
  const std::vector<std::string> parts = split(text, '-');
  const auto part = [&](std::size_t i, std::size_t width) {
    return parts.size() == 3 ? digits(parts[i], width, width) : std::nullopt;
  };
  const std::optional<int> year = part(0, 4);
  const std::optional<int> month = part(1, 2);
  const std::optional<int> day = part(2, 2);
  if (!year || !month || !day) {
    throw InputError(option + ": " + quote(text) + " is not a date; write YYYY-MM-DD, for example 2026-06-21");
  }
  const chrono::year_month_day date(chrono::year(*year), chrono::month(static_cast<unsigned>(*month)),
                                    chrono::day(static_cast<unsigned>(*day)));
  if (!date.ok()) {
    throw InputError(option + ": the calendar has no day " + quote(text) + "; write YYYY-MM-DD");
  }
  if (*year < kFirstYear || *year > kLastYear) {
    throw InputError(option + ": the year " + std::to_string(*year) + " is outside " + std::to_string(kFirstYear) +
                     " to " + std::to_string(kLastYear) + ", for which the sun's path is good to 0.01 degrees");
  }
  return midnight_of({*year, *month, *day});
}

Milliseconds parse_time_of_day(std::string_view text, const std::string& option) {
  const std::vector<std::string> parts = split(text, ':');
  std::optional<int> hours, minutes, seconds = 0;
  if (parts.size() == 2 || parts.size() == 3) {
    hours = digits(parts[0], 1, 2);
    minutes = digits(parts[1], 2, 2);
    seconds = parts.size() == 3 ? digits(parts[2], 2, 2) : seconds;
  }
  const Milliseconds time =
      hours && minutes && seconds ? *hours * kHour + *minutes * kMinute + *seconds * kSecond : kDay + 1;
  if (time > kDay || *minutes > 59 || *seconds > 59) {
    throw InputError(option + ": " + quote(text) + " is not a time of day; write HH:MM or HH:MM:SS, 00:00 to 24:00");
  }
  return time;
}

Milliseconds parse_step(std::string_view text, const std::string& option) {
  const std::optional<Milliseconds> length = length_of(text);
  if (!length || text.empty()) {
    throw InputError(option + ": " + quote(text) +
                     " is not a length of time; write a number with h, m or s, for example 5m or 1h30m");
  }
  if (*length == 0) {
    throw InputError(option + ": " + quote(text) + " never gets from --from to --to; write at least 0.001s");
  }
  return *length;
}

std::string iso_text(Milliseconds utc, int offset_seconds) {
  const Milliseconds local = utc + offset_seconds * kSecond;
  const CivilDate date = date_of(local);
  const Milliseconds time = local - midnight_of(date);
  char text[64];
  std::snprintf(text, sizeof text, "%04d-%02d-%02dT%02d:%02d:%02d", date.year, date.month, date.day,
                static_cast<int>(time / kHour), static_cast<int>(time / kMinute % 60),
                static_cast<int>(time / kSecond % 60));
  std::string result = text;
  if (time % kSecond != 0) {
    std::snprintf(text, sizeof text, ".%03d", static_cast<int>(time % kSecond));
    result += text;
  }
  if (offset_seconds == 0) {
    return result + "Z";
  }
  const int offset = std::abs(offset_seconds);
  std::snprintf(text, sizeof text, "%c%02d:%02d", offset_seconds < 0 ? '-' : '+', offset / 3600, offset / 60 % 60);
  result += text;
  if (offset % 60 != 0) {  // local mean times of before the zones
    std::snprintf(text, sizeof text, ":%02d", offset % 60);
    result += text;
  }
  return result;
}

std::string clock_text(Milliseconds utc, int offset_seconds) {
  const std::string iso = iso_text(utc, offset_seconds);
  return iso.substr(11, iso.substr(16, 3) == ":00" ? 5 : 8);
}

}  // namespace airlight::sequence
