#pragma once
// Description of a table's numbers and texels, in words and as a program that a reader can run. Each text stands beside
// the pass that makes its table; presets/README.md, "Tables", tells users how to read it.

#include <string>
#include <string_view>
#include <vector>

namespace airlight {

// One direction of a table, or a number that changes from block to block of one.
struct TableAxis {
  std::string along;    // "x", "y", or "block" where several tables of one size stand side by side
  std::string name;     // of the quantity, as `decode` computes it: "altitude_km"
  std::string unit;     // "km"
  std::string mapping;  // in words
};

struct TableText {
  std::string quantity;  // the same for red, green and blue
  std::string unit;
  std::vector<TableAxis> axes;
  // Assignments, one a line, that compute the axes' quantities for the texel in column i and row j of a table of width
  // x height texels. `constants` come first. Operators + - * / < >= and parentheses, numbers, `pi`, lists in brackets,
  // and of numpy's functions: abs, arctan2, clip, exp, floor, log, maximum, minimum, sin, sinh, sqrt, take, where.
  std::string constants;
  std::string decode;
};

// "name = 6360\n".
std::string table_constant(std::string_view name, double value);
// "name = [0, 1.5, 100]\n".
std::string table_constant(std::string_view name, const std::vector<double>& values);

}  // namespace airlight
