#include "core/scene/phase_reader.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/text.h"
#include "core/scene/json_format.h"
#include "core/scene/phase_file.h"
#include "core/spectra/drops.h"

namespace airlight {
namespace {

constexpr double kMostOff = 0.05;  // of an integral from what it should be
constexpr double kExact = 1e-9;
constexpr double kTold = 1e-5;

std::string row_name(const PhaseTable& table, std::size_t row) {
  return table.wavelengths_nm.empty() ? "" : "at " + format_number(table.wavelengths_nm[row]) + " nm ";
}

// The first of the values that is out of range; empty: none.
std::string outside_problem(const std::vector<double>& list, const Range& range, std::string_view unit) {
  const auto outside = std::ranges::find_if(list, [&](double x) { return !range.contains(x); });
  return outside == list.end() ? std::string() : format_number(*outside) + " is outside " + range_text(range, unit);
}

// The error in an ascending list of values; empty: none.
std::string list_problem(const std::vector<double>& list, const Range& range, std::string_view unit) {
  if (list.size() < 2 || list.size() > kMostPhaseAngles) {
    return std::to_string(list.size()) + " of them; expected 2 to " + std::to_string(kMostPhaseAngles);
  }
  if (std::string outside = outside_problem(list, range, unit); !outside.empty()) {
    return outside;
  }
  const auto descent = std::ranges::adjacent_find(list, [](double a, double b) { return b <= a; });
  if (descent != list.end()) {
    return format_number(descent[1]) + " " + std::string(unit) + " does not follow " + format_number(descent[0]) +
           "; expected ascending numbers";
  }
  return {};
}

std::string angles_problem(const std::vector<double>& angles, const Range& range) {
  const std::string problem = list_problem(angles, range, "degrees");
  if (!problem.empty()) {
    return problem;
  }
  if (angles.front() != 0.0) {
    return "begins at " + format_number(angles.front()) + " degrees; expected angles from 0 to 180";
  }
  if (angles.back() != 180.0) {
    return "ends at " + format_number(angles.back()) + " degrees; expected angles from 0 to 180";
  }
  return {};
}

std::string values_problem(const PhaseTable& table, std::size_t row, const Range& range) {
  const std::vector<double>& values = table.rows[row];
  const std::string name = row_name(table, row);
  if (values.size() != table.angles_deg.size()) {
    return name + std::to_string(values.size()) + " values for " + std::to_string(table.angles_deg.size()) +
           " angles; expected as many of both";
  }
  const auto outside = std::ranges::find_if(values, [&](double x) { return !range.contains(x); });
  if (outside != values.end()) {
    return name + format_number(*outside) + " is outside " + range_text(range, {});
  }
  if (std::ranges::count(values, 0.0) == std::ssize(values)) {
    return name + "0 at all angles; expected light at some";
  }
  return {};
}

// Divides each row by its integral.
std::string normalise(PhaseTable& table) {
  constexpr double kMean = 4.0 * std::numbers::pi;  // of a function whose mean is 1
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    const double integral = sphere_integral(table, row);
    const double whole = std::abs(integral / kMean - 1.0) < std::abs(integral - 1.0) ? kMean : 1.0;
    if (!(std::abs(integral / whole - 1.0) <= kMostOff)) {
      return row_name(table, row) + "the integral over the sphere is " + rounded(integral, 5) +
             "; expected 1, or 4 pi where the mean is 1, to 5 %: divide the values by it, or look for angles that are "
             "missing in the peak";
    }
    if (std::abs(integral / whole - 1.0) > std::abs(table.integral - 1.0)) {
      table.integral = integral / whole;
    }
    // Repeated where small values count as more than they are, so that a written table reads back unchanged.
    for (double rest = integral; std::abs(rest - 1.0) > kExact; rest = sphere_integral(table, row)) {
      for (double& value : table.rows[row]) {
        value /= rest;
      }
    }
  }
  return {};
}

class TableReader {
 public:
  explicit TableReader(const Section& phase) : phase_(phase) {}

  // A table that is valid; after a reported problem one of equal values.
  PhaseTable read() {
    if (phase_.find("file") != nullptr) {
      read_file();
    } else {
      read_lists();
    }
    if (good_) {
      check();
    }
    return good_ ? table_ : PhaseTable{{0.0, 180.0}, {}, {{0.25 / std::numbers::pi, 0.25 / std::numbers::pi}}};
  }

 private:
  void complain(std::string_view key, const std::string& message) {
    const PresetValue* value = phase_.find(key);
    phase_.complain(key, value == nullptr ? phase_.context() : *value, message);
    good_ = false;
  }

  void read_file() {
    for (const char* key : {"angles_deg", "values", "wavelengths_nm"}) {
      const PresetValue* value = phase_.find(key);
      if (value != nullptr && !value->inherited) {
        complain(key, "stands beside a file that has the table; remove one of the two");
      }
    }
    const PresetValue& value = *phase_.find("file");
    const std::string name = phase_.text("file");
    if (name.empty()) {
      complain("file", quoted(value) + " is no file; expected the name of one");
      return;
    }
    const std::string problem = read_phase_file(file_beside(value, name), table_);
    place_ = name + ": ";
    if (!problem.empty()) {
      complain("file", problem);
    }
  }

  std::vector<double> numbers(std::string_view key, const PresetValue& value) {
    const auto* array = std::get_if<PresetArray>(&value.data);
    if (array == nullptr) {
      complain(key, quoted(value) + " is not an array; expected " + expectation(phase_.rule(key)));
      return {};
    }
    std::vector<double> list;
    for (const PresetValue& element : *array) {
      const auto* number = std::get_if<double>(&element.data);
      if (number == nullptr) {
        complain(key, quoted(element) + " is not a number; expected " + expectation(phase_.rule(key)));
        return {};
      }
      list.push_back(*number);
    }
    return list;
  }

  void read_lists() {
    const PresetValue* angles = phase_.find("angles_deg");
    const PresetValue* values = phase_.find("values");
    for (const char* key : {"angles_deg", "values"}) {
      if (phase_.find(key) == nullptr) {
        complain(key, "missing for \"table\"; expected " + expectation(phase_.rule(key)) + ", or a file");
      }
    }
    if (angles == nullptr || values == nullptr) {
      return;
    }
    table_.angles_deg = numbers("angles_deg", *angles);
    if (const PresetValue* wavelengths = phase_.find("wavelengths_nm")) {
      table_.wavelengths_nm = numbers("wavelengths_nm", *wavelengths);
    }
    const auto* array = std::get_if<PresetArray>(&values->data);
    const bool has_rows =
        array != nullptr && !array->empty() && std::holds_alternative<PresetArray>(array->front().data);
    if (!has_rows) {
      table_.rows.push_back(numbers("values", *values));
      return;
    }
    for (const PresetValue& row : *array) {
      table_.rows.push_back(numbers("values", row));
    }
  }

  void check() {
    const bool from_file = phase_.find("file") != nullptr;
    const auto key = [&](std::string_view list) { return from_file ? std::string_view("file") : list; };
    const auto refuse = [&](std::string_view list, const std::string& problem) {
      if (good_ && !problem.empty()) {
        complain(key(list), place_ + problem);
      }
    };
    refuse("angles_deg", angles_problem(table_.angles_deg, phase_.rule("angles_deg").range));
    const std::size_t wavelengths = table_.wavelengths_nm.size();
    if (wavelengths > 0 || table_.rows.size() > 1) {
      const Range& range = phase_.rule("wavelengths_nm").range;
      refuse("wavelengths_nm", wavelengths == 1 ? outside_problem(table_.wavelengths_nm, range, "nm")
                                                : list_problem(table_.wavelengths_nm, range, "nm"));
      if (wavelengths != table_.rows.size()) {
        refuse("values", std::to_string(table_.rows.size()) + " rows for " + std::to_string(wavelengths) +
                             " wavelengths; expected as many of both");
      }
    }
    for (std::size_t row = 0; good_ && row < table_.rows.size(); ++row) {
      refuse("values", values_problem(table_, row, phase_.rule("values").range));
    }
    if (good_) {
      refuse("values", normalise(table_));
    }
    if (good_ && wavelengths == 1) {
      table_.wavelengths_nm.clear();  // it stands for all
    }
  }

  const Section& phase_;
  PhaseTable table_;
  std::string place_;  // place in a file, put before a message
  bool good_ = true;
};

}  // namespace

void read_phase(const Section& section, Medium& medium) {
  Section phase = section;
  phase.refuse_unknown_keys();
  const auto function = phase.choice("function");
  const bool drops = function == kDropsPhase;
  medium.phase = drops ? PhaseFunction::table : static_cast<PhaseFunction>(function.value_or(0));
  if (function) {
    phase.choose(kPhaseNames.at(*function));
  }
  phase.fill(medium);
  if (!function) {
    return;
  }
  if (drops) {
    medium.phase_table = drops_phase(medium.effective_radius);
    medium.phase_wavelengths = kDropChannels;
    return;
  }
  if (medium.phase == PhaseFunction::table) {
    medium.phase_table = TableReader(phase).read();
    if (!medium.phase_table.wavelengths_nm.empty()) {
      phase.curves().add(phase.pointer_to(phase.find("file") != nullptr ? "file" : "wavelengths_nm"));
    }
  }
}

std::vector<std::string> phase_notes(const Scene& scene) {
  std::vector<std::string> lines;
  for (std::size_t i = 0; i < scene.media.size(); ++i) {
    const double integral = scene.media[i].phase_table.integral;
    if (scene.media[i].phase == PhaseFunction::table && std::abs(integral - 1.0) > kTold) {
      lines.push_back("/media/" + std::to_string(i) + "/phase: the table's integral is " + rounded(integral, 5) +
                      " of what it should be" +
                      (scene.media[i].phase_table.rows.size() > 1 ? ", in the row furthest off" : "") +
                      "; it is divided by it");
    }
  }
  return lines;
}

}  // namespace airlight
