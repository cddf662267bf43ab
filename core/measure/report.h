#pragma once
// A comparison's figures as text for people and as JUnit XML for CI.

#include <string>
#include <string_view>
#include <vector>

#include "core/measure/compare.h"

namespace airlight::measure {

struct NamedReport {
  std::string name;
  std::string a;
  std::string b;
  ComparisonReport report;
  std::vector<std::string> pictures = {};  // files that show this pair
};

// Everything about one pair: presets first, then notes, figures and the verdict. Several lines.
std::string describe(const NamedReport& entry, const Limits& in_force);

// One line; more lines with reasons and causes unless it is a plain pass.
std::string describe_briefly(const NamedReport& entry);

// Causes, a line each: the first preset keys that differ, the worst pixel, the pictures that show it. May be empty.
std::string describe_causes(const NamedReport& entry);

// Pairs that cannot be compared first, then by the largest and the mean relative error of the colour channels pooled.
std::vector<const NamedReport*> worst_first(const std::vector<NamedReport>& entries);

// "3 pairs: 1 pass, 1 differs, 1 cannot be compared; largest relative error ... in ..."
std::string describe_all(const std::vector<NamedReport>& entries);

// The worst verdict. A pair that cannot be compared is worse than one that differs.
Verdict overall(const std::vector<NamedReport>& entries);

// A JUnit test suite: a case for each pair, a <failure> where they differ, an <error> where they cannot be compared.
std::string junit_xml(const std::vector<NamedReport>& entries);

// Text for XML 1.0 or HTML as attribute or content: markup escaped, characters that XML forbids and broken UTF-8
// replaced.
std::string xml_escaped(std::string_view text);

}  // namespace airlight::measure
