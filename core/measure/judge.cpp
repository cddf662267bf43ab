#include "core/measure/judge.h"

#include <algorithm>
#include <cmath>

#include "core/measure/words.h"

namespace airlight::measure {
namespace {

bool judges_relatively(const Limits& limits) {
  return limits.relative_mean || limits.relative_p95 || limits.relative_max || limits.chi_square;
}

double percent_of(std::size_t count, std::size_t all) {
  return 100.0 * static_cast<double>(count) / static_cast<double>(all);
}

// "12 of 2048 pixels (0.59 %) differ by more than 1e-06"
std::string count_words(std::size_t count, const ComparisonReport& report, double limit, double allowed,
                        const std::string& unit) {
  std::string words = std::to_string(count) + " of " + std::to_string(report.pixels) + " pixels (" +
                      number(percent_of(count, report.pixels)) + " %) differ by more than " + number(limit) + unit;
  if (allowed > 0.0) words += "; " + number(allowed) + " % may";
  return words;
}

void judge_relative(const Limits& limits, const ChannelReport& pooled, std::vector<std::string>& reasons) {
  const auto check = [&](const std::optional<double>& limit, double value, const char* what) {
    if (limit && !(value <= *limit)) {
      reasons.push_back(std::string(what) + " relative error " + number(value) + " is above " + number(*limit));
    }
  };
  check(limits.relative_mean, pooled.relative.mean, "mean");
  check(limits.relative_p95, pooled.relative.p95, "95th percentile of the");
  check(limits.relative_max, pooled.relative.max, "largest");
  if (limits.chi_square && pooled.chi_square && pooled.chi_square->count > 0 &&
      !(pooled.chi_square->per_value() <= *limits.chi_square)) {
    reasons.push_back("chi-square per value " + number(pooled.chi_square->per_value()) + " is above " +
                      number(*limits.chi_square));
  }
}

}  // namespace

Limits limits_in_force(const Limits& given, bool in_sigmas) {
  Limits limits = given;
  const bool none = !limits.fail && !limits.hard_fail && !judges_relatively(limits);
  if (in_sigmas) {
    if (!none) return limits;
    limits.fail = kDefaultSigmaFail;
    limits.fail_percent = std::max(limits.fail_percent, kDefaultSigmaPercent);
    limits.chi_square = kDefaultChiSquare;
  } else if (!limits.fail && (none || limits.hard_fail || limits.fail_percent > 0.0)) {
    limits.fail = kDefaultFail;
  }
  return limits;
}

void judge(const Limits& limits, bool in_sigmas, ComparisonReport& report) {
  const std::string unit = in_sigmas ? " standard errors" : "";
  std::vector<std::string> failures;
  if (report.unequal_nonfinite > 0) {
    failures.push_back(std::to_string(report.unequal_nonfinite) + " of " + std::to_string(report.pixels) +
                       " pixels hold NaN or infinity, which equal nothing");
  }
  if (limits.fail && percent_of(report.pixels_over_fail, report.pixels) > limits.fail_percent) {
    failures.push_back(count_words(report.pixels_over_fail, report, *limits.fail, limits.fail_percent, unit));
  }
  if (limits.hard_fail && !(report.largest <= *limits.hard_fail)) {
    failures.push_back("the largest difference, " + number(report.largest) + unit + ", is above the hard limit " +
                       number(*limits.hard_fail));
  }
  judge_relative(limits, report.areas.front().channels.back(), failures);
  if (!failures.empty()) {
    report.verdict = Verdict::differ;
    report.reasons = std::move(failures);
    return;
  }
  if (limits.warn && percent_of(report.pixels_over_warn, report.pixels) > limits.warn_percent) {
    report.reasons.push_back(count_words(report.pixels_over_warn, report, *limits.warn, limits.warn_percent, unit));
  }
  if (limits.hard_warn && !(report.largest <= *limits.hard_warn)) {
    report.reasons.push_back("the largest difference, " + number(report.largest) + unit +
                             ", is above the hard warning limit " + number(*limits.hard_warn));
  }
  report.verdict = report.reasons.empty() ? Verdict::pass : Verdict::warn;
}

}  // namespace airlight::measure
