#include "core/sequence/zone_rule.h"

#include <cctype>
#include <chrono>

#include "core/sequence/civil_time.h"

namespace airlight::sequence {
namespace {

namespace chrono = std::chrono;

// Takes the rule's text piece by piece; once something does not fit, `good` stays false.
class Reader {
 public:
  explicit Reader(std::string_view text) : text_(text) {}

  bool good = true;
  bool at_end() const { return text_.empty(); }
  bool take(char wanted) {
    if (text_.empty() || text_.front() != wanted) return false;
    text_.remove_prefix(1);
    return true;
  }
  void expect(char wanted) { good = take(wanted) && good; }

  // "CET" or "<+03>".
  void name() {
    std::size_t length = 0;
    if (take('<')) {
      length = text_.find('>');
      good = good && length != std::string_view::npos;
      text_.remove_prefix(good ? length + 1 : text_.size());
      return;
    }
    while (length < text_.size() && std::isalpha(static_cast<unsigned char>(text_[length])) != 0) ++length;
    good = good && length >= 3;
    text_.remove_prefix(length);
  }

  int number() {
    int value = 0;
    std::size_t length = 0;
    while (length < text_.size() && length < 4 && std::isdigit(static_cast<unsigned char>(text_[length])) != 0) {
      value = 10 * value + (text_[length++] - '0');
    }
    good = good && length > 0;
    text_.remove_prefix(length);
    return value;
  }

  // "[+-]hh[:mm[:ss]]", in s.
  int time() {
    const bool negative = take('-');
    if (!negative) take('+');
    int seconds = 3600 * number();
    if (take(':')) seconds += 60 * number();
    if (take(':')) seconds += number();
    return negative ? -seconds : seconds;
  }

  YearlyMoment moment() {
    YearlyMoment result;
    if (take('M')) {
      result.month = number();
      expect('.');
      result.week = number();
      expect('.');
      result.weekday = number();
      good = good && result.month >= 1 && result.month <= 12 && result.week >= 1 && result.week <= 5 &&
             result.weekday <= 6;
    } else {
      const bool julian = take('J');
      result.kind = julian ? YearlyMoment::Kind::julian : YearlyMoment::Kind::day_of_year;
      result.day = number();
      good = good && result.day >= (julian ? 1 : 0) && result.day <= 365;
    }
    if (take('/')) result.time = time();
    return result;
  }

 private:
  std::string_view text_;
};

chrono::sys_days day_of(const YearlyMoment& moment, chrono::year year) {
  const chrono::sys_days new_year = year / chrono::January / 1;
  switch (moment.kind) {
    case YearlyMoment::Kind::julian:
      return new_year + chrono::days(moment.day - 1 + (year.is_leap() && moment.day > 59 ? 1 : 0));
    case YearlyMoment::Kind::day_of_year:
      return new_year + chrono::days(moment.day);
    case YearlyMoment::Kind::month_week_day:
      break;
  }
  const chrono::year_month month = year / chrono::month(static_cast<unsigned>(moment.month));
  const chrono::weekday weekday(static_cast<unsigned>(moment.weekday));
  return moment.week == 5 ? chrono::sys_days(month / weekday[chrono::last])
                          : chrono::sys_days(month / weekday[static_cast<unsigned>(moment.week)]);
}

// s since 1970 UTC, when the clock until then is `offset` ahead.
std::int64_t seconds_of(const YearlyMoment& moment, chrono::year year, int offset) {
  return std::int64_t{day_of(moment, year).time_since_epoch().count()} * 86400 + moment.time - offset;
}

}  // namespace

std::optional<ZoneRule> parse_zone_rule(std::string_view text) {
  Reader reader(text);
  ZoneRule rule;
  reader.name();
  rule.standard_offset = -reader.time();  // POSIX counts west
  if (reader.good && !reader.at_end()) {
    rule.has_summer = true;
    rule.summer_offset = rule.standard_offset + 3600;
    reader.name();
    if (!reader.take(',')) {
      rule.summer_offset = -reader.time();
      reader.expect(',');
    }
    rule.summer_begins = reader.moment();
    reader.expect(',');
    rule.summer_ends = reader.moment();
  }
  return reader.good && reader.at_end() ? std::optional(rule) : std::nullopt;
}

int offset_at(const ZoneRule& rule, std::int64_t utc) {
  if (!rule.has_summer) return rule.standard_offset;
  const chrono::year year(date_of((utc + rule.standard_offset) * kSecond).year);
  const std::int64_t begin = seconds_of(rule.summer_begins, year, rule.standard_offset);
  const std::int64_t end = seconds_of(rule.summer_ends, year, rule.summer_offset);
  const bool summer = begin < end ? utc >= begin && utc < end : utc >= begin || utc < end;  // else: the south
  return summer ? rule.summer_offset : rule.standard_offset;
}

}  // namespace airlight::sequence
