#pragma once
// Numbers and verdicts in words for people.

#include <string>

#include "core/measure/compare.h"

namespace airlight::measure {

// Four significant digits, shortest form: "0.0123", "1.5e-07", "inf".
std::string number(double value);

// A fraction in percent, three digits: "1.25%".
std::string percent(double fraction);

// "pass", "pass with warnings", "differ", "cannot compare".
std::string verdict_words(Verdict verdict);

}  // namespace airlight::measure
