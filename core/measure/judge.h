#pragma once
// Figures and limits -> a verdict with its reasons.

#include "core/measure/compare.h"

namespace airlight::measure {

inline constexpr double kDefaultFail = 1e-6;      // idiff's
inline constexpr double kDefaultSigmaFail = 4.0;  // standard errors: 0.006 % of values by chance
inline constexpr double kDefaultSigmaPercent = 0.5;
inline constexpr double kDefaultChiSquare = 1.5;

// The limits in force. Limits of idiff's family get --fail's default unless only relative ones are given. With a
// standard error and no limit at all, the defaults are in standard errors.
Limits limits_in_force(const Limits& given, bool in_sigmas);

// Fills verdict, reasons and checks. Unequal NaN or infinity fails under all limits.
void judge(const Limits& limits, bool in_sigmas, ComparisonReport& report);

}  // namespace airlight::measure
