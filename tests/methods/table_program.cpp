#include "tests/methods/table_program.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <numbers>
#include <sstream>
#include <stdexcept>

namespace airlight::test {
namespace {

using Value = std::vector<double>;  // a list, or one number
using Names = std::map<std::string, Value>;

class TableExpression {
 public:
  TableExpression(const std::string& line, const Names& names) : text_(line), names_(names) {}

  Value value() {
    const Value found = comparison();
    if (skipped() != '\0') {
      refuse("an operator");
    }
    return found;
  }

 private:
  [[noreturn]] void refuse(const std::string& expected) const {
    throw std::runtime_error(text_ + ": expected " + expected + " at column " + std::to_string(at_));
  }

  char skipped() {
    while (at_ < text_.size() && text_[at_] == ' ') {
      ++at_;
    }
    return at_ < text_.size() ? text_[at_] : '\0';
  }

  bool take(std::string_view symbol) {
    skipped();
    const bool there = std::string_view(text_).substr(at_).starts_with(symbol);
    at_ += there ? symbol.size() : 0;
    return there;
  }

  static double number(const Value& value) {
    if (value.size() != 1) {
      throw std::runtime_error("a list where a number was expected");
    }
    return value.front();
  }

  Value comparison() {
    const Value left = sum();
    if (take("<")) {
      return {number(left) < number(sum()) ? 1.0 : 0.0};
    }
    if (take(">=")) {
      return {number(left) >= number(sum()) ? 1.0 : 0.0};
    }
    return left;
  }

  Value sum() {
    Value left = product();
    while (skipped() == '+' || skipped() == '-') {
      const bool plus = text_[at_++] == '+';
      const double right = number(product());
      left = {number(left) + (plus ? right : -right)};
    }
    return left;
  }

  Value product() {
    Value left = factor();
    while (skipped() == '*' || skipped() == '/') {
      const bool times = text_[at_++] == '*';
      const double right = number(factor());
      left = {times ? number(left) * right : number(left) / right};
    }
    return left;
  }

  Value factor() {
    if (take("-")) {
      return {-number(factor())};
    }
    if (take("(")) {
      const Value inside = comparison();
      if (!take(")")) {
        refuse(")");
      }
      return inside;
    }
    if (take("[")) {
      return list("]");
    }
    const char first = skipped();
    if (std::isdigit(static_cast<unsigned char>(first)) != 0) {
      std::size_t used = 0;
      const double found = std::stod(text_.substr(at_), &used);
      at_ += used;
      return {found};
    }
    std::string name;
    while (at_ < text_.size() && (std::isalnum(static_cast<unsigned char>(text_[at_])) != 0 || text_[at_] == '_')) {
      name += text_[at_++];
    }
    if (take("(")) {
      std::vector<Value> arguments;
      do {
        arguments.push_back(comparison());
      } while (take(","));
      if (!take(")")) {
        refuse(")");
      }
      return {called(name, arguments)};
    }
    const auto found = names_.find(name);
    if (found == names_.end()) {
      refuse("a number or a known name");
    }
    return found->second;
  }

  Value list(std::string_view end) {
    Value all;
    do {
      all.push_back(number(comparison()));
    } while (take(","));
    if (!take(end)) {
      refuse(std::string(end));
    }
    return all;
  }

  double called(const std::string& name, const std::vector<Value>& arguments) const {
    if (name == "take" && arguments.size() == 2) {
      return arguments[0].at(static_cast<std::size_t>(number(arguments[1])));
    }
    std::vector<double> x;
    for (const Value& argument : arguments) {
      x.push_back(number(argument));
    }
    if (x.size() == 1) {
      using Function = double (*)(double);
      static const std::map<std::string, Function> of_one = {
          {"abs", std::fabs}, {"exp", std::exp},   {"floor", std::floor}, {"log", std::log},
          {"sin", std::sin},  {"sinh", std::sinh}, {"sqrt", std::sqrt}};
      if (const auto found = of_one.find(name); found != of_one.end()) {
        return found->second(x[0]);
      }
    }
    if (x.size() == 2 && name == "arctan2") {
      return std::atan2(x[0], x[1]);
    }
    if (x.size() == 2 && (name == "minimum" || name == "maximum")) {
      return name == "minimum" ? std::min(x[0], x[1]) : std::max(x[0], x[1]);
    }
    if (x.size() == 3 && name == "clip") {
      return std::clamp(x[0], x[1], x[2]);
    }
    if (x.size() == 3 && name == "where") {
      return x[0] != 0.0 ? x[1] : x[2];
    }
    refuse("a function of the list in core/plan/table_text.h before");
  }

  std::string text_;
  const Names& names_;
  std::size_t at_ = 0;
};

}  // namespace

TableProgram::TableProgram(const std::string& text) {
  std::istringstream all(text);
  for (std::string line; std::getline(all, line);) {
    lines_.push_back(line);
  }
}

std::map<std::string, double> TableProgram::at(int i, int j, int width, int height) const {
  Names names = {{"i", {static_cast<double>(i)}},
                 {"j", {static_cast<double>(j)}},
                 {"width", {static_cast<double>(width)}},
                 {"height", {static_cast<double>(height)}},
                 {"pi", {std::numbers::pi}}};
  for (const std::string& line : lines_) {
    const std::size_t sign = line.find(" = ");
    if (sign == std::string::npos) {
      throw std::runtime_error(line + ": expected an assignment");
    }
    names.insert_or_assign(line.substr(0, sign), TableExpression(line.substr(sign + 3), names).value());
  }
  std::map<std::string, double> numbers;
  for (const auto& [name, value] : names) {
    if (value.size() == 1) {
      numbers[name] = value.front();
    }
  }
  return numbers;
}

}  // namespace airlight::test
