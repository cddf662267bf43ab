#pragma once
// The language of TableText::constants and TableText::decode: assignments that numpy would read.

#include <map>
#include <string>
#include <vector>

namespace airlight::test {

class TableProgram {
 public:
  explicit TableProgram(const std::string& text);

  // Every name that the program assigns, for a texel of a table of this size. Throws std::runtime_error with the line
  // that cannot be read.
  std::map<std::string, double> at(int i, int j, int width, int height) const;

 private:
  std::vector<std::string> lines_;
};

}  // namespace airlight::test
