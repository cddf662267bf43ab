#pragma once
// Reads one value by one rule. A wrong value is reported, and `out` keeps its value.

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

#include "core/scene/preset.h"
#include "core/scene/problems.h"
#include "core/scene/rules.h"
#include "core/scene/scene.h"

namespace airlight {

// The place of a value and its rule.
struct Site {
  Problems& problems;
  const PresetValue& value;
  std::string pointer;
  const Rule& rule;

  void complain(std::string_view message) const { problems.add(value, pointer, message); }
};

void read_number(const Site& site, double& out);
void read_integer(const Site& site, int& out);
void read_boolean(const Site& site, bool& out);
void read_text(const Site& site, std::string& out);
void read_spectrum(const Site& site, Spectrum& out);
void read_pair(const Site& site, std::array<double, 2>& out);
// The index in the rule's choices; false when the value is none of them.
bool read_choice(const Site& site, std::size_t& out);

// "1.2 is outside -0.99 to 0.99", "180 is not above 0 and below 180 degrees".
std::string out_of_range(double value, const Rule& rule);

// "; did you mean \"march\"?", or empty when no name is near.
std::string did_you_mean(std::string_view typed, std::span<const std::string> names);

}  // namespace airlight
