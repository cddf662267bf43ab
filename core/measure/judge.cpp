#include "core/measure/judge.h"

#include <algorithm>

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

std::string percent_words(double percent) {
  return number(percent) + " % of pixels";
}

// --fail and --warn: a share of pixels may exceed the limit.
LimitCheck pixel_check(const char* option, double limit, double allowed, std::size_t count,
                       const ComparisonReport& report, const std::string& unit) {
  LimitCheck check;
  check.limit = std::string("pixels above ") + number(limit) + unit + " (" + option + ")";
  check.allowed = percent_words(allowed);
  check.measured = percent_words(percent_of(count, report.pixels));
  check.holds = !(percent_of(count, report.pixels) > allowed);
  check.reason = count_words(count, report, limit, allowed, unit);
  return check;
}

LimitCheck largest_check(const char* option, const char* what, double limit, const ComparisonReport& report,
                         const std::string& unit) {
  LimitCheck check;
  check.limit = "largest difference" + unit + " (" + option + ")";
  check.allowed = number(limit);
  check.measured = number(report.largest);
  check.holds = report.largest <= limit;
  check.reason =
      "the largest difference, " + number(report.largest) + unit + ", is above the " + what + " " + number(limit);
  return check;
}

void check_relative(const Limits& limits, const ChannelReport& pooled, std::vector<LimitCheck>& checks) {
  const auto check = [&](const std::optional<double>& limit, double value, const std::string& what,
                         const char* option) {
    if (!limit) return;
    checks.push_back({.limit = what + " (" + option + ")",
                      .allowed = number(*limit),
                      .measured = number(value),
                      .holds = value <= *limit,
                      .only_warns = false,
                      .reason = what + " " + number(value) + " is above " + number(*limit)});
  };
  check(limits.relative_mean, pooled.relative.mean, "mean relative error", "--rel-mean");
  check(limits.relative_p95, pooled.relative.p95, "95th percentile of the relative error", "--rel-p95");
  check(limits.relative_max, pooled.relative.max, "largest relative error", "--rel-max");
  if (pooled.chi_square && pooled.chi_square->count > 0) {
    check(limits.chi_square, pooled.chi_square->per_value(), "chi-square per value", "--chi-square");
  }
}

std::vector<LimitCheck> check_limits(const Limits& limits, bool in_sigmas, const ComparisonReport& report) {
  const std::string unit = in_sigmas ? " standard errors" : "";
  std::vector<LimitCheck> checks = {{.limit = "pixels with unequal NaN or infinity",
                                     .allowed = "0",
                                     .measured = std::to_string(report.unequal_nonfinite),
                                     .holds = report.unequal_nonfinite == 0,
                                     .only_warns = false,
                                     .reason = std::to_string(report.unequal_nonfinite) + " of " +
                                               std::to_string(report.pixels) +
                                               " pixels hold NaN or infinity, which equal nothing"}};
  if (limits.fail) {
    checks.push_back(pixel_check("--fail", *limits.fail, limits.fail_percent, report.pixels_over_fail, report, unit));
  }
  if (limits.hard_fail) {
    checks.push_back(largest_check("--hardfail", "hard limit", *limits.hard_fail, report, unit));
  }
  check_relative(limits, report.areas.front().channels.back(), checks);
  const std::size_t judging = checks.size();
  if (limits.warn) {
    checks.push_back(pixel_check("--warn", *limits.warn, limits.warn_percent, report.pixels_over_warn, report, unit));
  }
  if (limits.hard_warn) {
    checks.push_back(largest_check("--hardwarn", "hard warning limit", *limits.hard_warn, report, unit));
  }
  for (std::size_t i = judging; i < checks.size(); ++i) checks[i].only_warns = true;
  return checks;
}

std::vector<std::string> broken(const std::vector<LimitCheck>& checks, bool warnings) {
  std::vector<std::string> reasons;
  for (const LimitCheck& check : checks) {
    if (!check.holds && check.only_warns == warnings) reasons.push_back(check.reason);
  }
  return reasons;
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
  report.checks = check_limits(limits, in_sigmas, report);
  report.reasons = broken(report.checks, false);
  report.verdict = Verdict::differ;
  if (!report.reasons.empty()) return;
  report.reasons = broken(report.checks, true);
  report.verdict = report.reasons.empty() ? Verdict::pass : Verdict::warn;
}

}  // namespace airlight::measure
