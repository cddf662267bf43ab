#include "core/scene/phase_file.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <sstream>
#include <string_view>
#include <vector>

#include "core/base/text.h"
#include "core/scene/json_format.h"
#include "core/scene/named_file.h"

namespace airlight {
namespace {

constexpr double kPicometres = 1e12;  // in a metre

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kSpace = " \t\r";
  const std::size_t first = text.find_first_not_of(kSpace);
  return first == std::string_view::npos ? std::string_view()
                                         : text.substr(first, text.find_last_not_of(kSpace) - first + 1);
}

std::vector<std::string_view> fields_of(std::string_view line) {
  std::vector<std::string_view> fields;
  for (std::size_t from = 0; from <= line.size();) {
    const std::size_t to = std::min(line.find_first_of(",;", from), line.size());
    fields.push_back(trimmed(line.substr(from, to - from)));
    from = to + 1;
  }
  return fields;
}

struct Column {
  double angle = 0.0;
  double nm = 0.0;
};

// "1.7100[442nm]"
std::optional<Column> column_of(std::string_view field) {
  const std::size_t bracket = field.find('[');
  if (bracket == std::string_view::npos || !field.ends_with("nm]")) {
    return std::nullopt;
  }
  const auto angle = number_from<double>(field.substr(0, bracket));
  const auto nm = number_from<double>(field.substr(bracket + 1, field.size() - bracket - 4));
  return angle && nm ? std::optional(Column{*angle, *nm}) : std::nullopt;
}

class PhaseFile {
 public:
  PhaseFile(std::string name, PhaseTable& table) : name_(std::move(name)), table_(table) {}

  std::string read(std::istream& stream) {
    std::string text;
    while (problem_.empty() && std::getline(stream, text)) {
      ++line_;
      const std::string_view line = trimmed(text);
      if (!line.empty() && line.front() != '#') {
        take(fields_of(line));
      }
    }
    if (!problem_.empty()) {
      return problem_;
    }
    if (form_ == Form::aeronet) {
      finish_aeronet();
    }
    if (table_.rows.empty()) {
      return name_ +
             ": no table in it; expected CosmoScout's CSV (a heading that begins with lambda), AERONET's .pfn (columns "
             "ANGLE[NNNnm]), or lines of angle,value";
    }
    return {};
  }

 private:
  enum class Form { unknown, cosmoscout, aeronet, plain };

  void refuse(const std::string& what) { problem_ = name_ + ":" + std::to_string(line_) + ": " + what; }

  // Empty where one of them is no number, which is reported.
  std::vector<double> numbers(const std::vector<std::string_view>& fields, std::size_t first, std::size_t count) {
    std::vector<double> values;
    for (std::size_t i = first; i < first + count; ++i) {
      const auto value = i < fields.size() ? number_from<double>(fields[i]) : std::nullopt;
      if (!value) {
        refuse((i < fields.size() ? json_string(std::string(fields[i].substr(0, 40))) + " in field "
                                  : "nothing in field ") +
               std::to_string(i + 1) + "; expected a number");
        return {};
      }
      values.push_back(*value);
    }
    return values;
  }

  void take(const std::vector<std::string_view>& fields) {
    switch (form_) {
      case Form::unknown:
        recognise(fields);
        break;
      case Form::cosmoscout:
        take_wavelength(fields);
        break;
      case Form::aeronet:
        take_retrieval(fields);
        break;
      case Form::plain:
        take_angle(fields);
        break;
    }
  }

  void recognise(const std::vector<std::string_view>& fields) {
    if (fields.front() == "lambda") {
      form_ = Form::cosmoscout;
      table_.angles_deg = numbers(fields, 1, fields.size() - 1);
    } else if (std::ranges::any_of(fields, [](auto field) { return column_of(field).has_value(); })) {
      form_ = Form::aeronet;
      for (std::size_t i = 0; i < fields.size(); ++i) {
        if (const auto column = column_of(fields[i])) {
          columns_.emplace(i, *column);
        }
      }
      sums_.resize(columns_.size());
    } else if (fields.size() == 2 && number_from<double>(fields[0]) && number_from<double>(fields[1])) {
      form_ = Form::plain;
      table_.rows.emplace_back();
      take_angle(fields);
    } else if (fields.size() == 2 && (number_from<double>(fields[0]) || number_from<double>(fields[1]))) {
      numbers(fields, 0, 2);  // tells which of the two is none
    }
  }

  void take_wavelength(const std::vector<std::string_view>& fields) {
    const std::size_t count = table_.angles_deg.size() + 1;
    if (fields.size() != count) {
      refuse(std::to_string(fields.size()) + " fields; expected " + std::to_string(count) + ", as the heading has");
      return;
    }
    std::vector<double> values = numbers(fields, 0, count);
    if (!values.empty()) {
      table_.wavelengths_nm.push_back(std::round(values.front() * kPicometres) / 1000.0);
      values.erase(values.begin());
      table_.rows.push_back(std::move(values));
    }
  }

  void take_retrieval(const std::vector<std::string_view>& fields) {
    std::size_t k = 0;
    for (const auto& [field, column] : columns_) {
      const std::vector<double> value = numbers(fields, field, 1);
      if (value.empty()) {
        return;
      }
      sums_[k++] += value.front();
    }
    ++retrievals_;
  }

  void finish_aeronet() {
    std::size_t k = 0;
    for (const auto& [field, column] : columns_) {
      if (table_.wavelengths_nm.empty() || table_.wavelengths_nm.back() != column.nm) {
        table_.wavelengths_nm.push_back(column.nm);
        table_.rows.emplace_back();
      }
      if (table_.rows.size() == 1) {
        table_.angles_deg.push_back(column.angle);
      }
      table_.rows.back().push_back(sums_[k++] / retrievals_);
    }
    if (retrievals_ == 0) {
      table_.rows.clear();
    }
  }

  void take_angle(const std::vector<std::string_view>& fields) {
    const std::vector<double> pair = numbers(fields, 0, 2);
    if (!pair.empty()) {
      table_.angles_deg.push_back(pair[0]);
      table_.rows.front().push_back(pair[1]);
    }
  }

  std::string name_;
  PhaseTable& table_;
  Form form_ = Form::unknown;
  int line_ = 0;
  std::string problem_;
  std::map<std::size_t, Column> columns_;  // by field
  std::vector<double> sums_;               // of the retrievals, by column
  int retrievals_ = 0;
};

}  // namespace

std::string read_phase_file(const std::filesystem::path& file, PhaseTable& table) {
  const NamedText named = read_named_text(file);
  if (!named.problem.empty()) {
    return file.string() + " cannot be read: " + named.problem + "; expected a table of a phase function";
  }
  std::istringstream stream(named.text);
  return PhaseFile(file.string(), table).read(stream);
}

}  // namespace airlight
