#include "core/plan/table_text.h"

#include "core/base/text.h"

namespace airlight {

std::string table_constant(std::string_view name, double value) {
  return std::string(name) + " = " + shortest(value) + "\n";
}

std::string table_constant(std::string_view name, const std::vector<double>& values) {
  std::string text = std::string(name) + " = [";
  for (const double value : values) {
    text += (text.back() == '[' ? "" : ", ") + shortest(value);
  }
  return text + "]\n";
}

}  // namespace airlight
