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
};

// Everything about one pair: presets first, then notes, figures and the verdict. Several lines.
std::string describe(const NamedReport& entry, const Limits& in_force);

// One line, and one for each reason.
std::string describe_briefly(const NamedReport& entry);

// "3 pairs: 1 pass, 1 differs, 1 cannot be compared; largest relative error ... in ..."
std::string describe_all(const std::vector<NamedReport>& entries);

// The worst of all: a pair that cannot be compared weighs more than one that differs.
Verdict overall(const std::vector<NamedReport>& entries);

// A JUnit test suite: a case for each pair, a <failure> where they differ, an <error> where they cannot be compared.
std::string junit_xml(const std::vector<NamedReport>& entries);

// Text for XML 1.0 as attribute or content: markup escaped, characters that XML forbids and broken UTF-8 replaced.
std::string xml_escaped(std::string_view text);

}  // namespace airlight::measure
