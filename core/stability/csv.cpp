#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <sstream>

#include "core/stability/report.h"

namespace airlight::stability {
namespace {

constexpr std::string_view kHeading =
    "method,sweep,x,y,not_finite,negative,error_mean,error_p95,rounding_mean,jump,energy,brightness,symptoms";
constexpr std::string_view kComplete = "# complete\n";
constexpr std::size_t kColumns = 13;

std::string first_line(const Examination& e) {
  return "# " + e.version + ", stability, " + e.form + ", " + e.device + "\n";
}

// Shortest form that reads back as the same number; a NaN ("not taken") is written as nothing.
std::string text_of(double value) {
  if (std::isnan(value)) {
    return {};
  }
  char text[40];
  const auto end = std::to_chars(text, text + sizeof text, value);
  return {text, end.ptr};
}

double number_of(const std::string& text) {
  double value = std::numeric_limits<double>::quiet_NaN();
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream stream(line + ",");
  for (std::string cell; std::getline(stream, cell, ',');) {
    cells.push_back(cell);
  }
  return cells;
}

Cell cell_of(const std::vector<std::string>& row) {
  Cell cell;
  cell.x = number_of(row[2]);
  cell.y = number_of(row[3]);
  cell.not_finite = static_cast<int>(number_of(row[4]));
  cell.negative = static_cast<int>(number_of(row[5]));
  cell.error = number_of(row[6]);
  cell.error95 = number_of(row[7]);
  cell.rounding = number_of(row[8]);
  cell.jump = number_of(row[9]);
  cell.energy = number_of(row[10]);
  cell.brightest = number_of(row[11]);
  cell.symptoms = row[12];
  return cell;
}

bool fits(const Block& block, const Examination& now) {
  const auto known = [&](const Subject& subject) { return subject.name == block.subject; };
  const auto sweep =
      std::find_if(now.sweeps.begin(), now.sweeps.end(), [&](const Sweep& one) { return one.name == block.sweep; });
  return std::any_of(now.subjects.begin(), now.subjects.end(), known) && sweep != now.sweeps.end() &&
         block.cells.size() == sweep->xs.size() * sweep->ys.size();
}

}  // namespace

std::string csv_text(const Examination& examination, bool complete) {
  std::string text = first_line(examination) + std::string(kHeading) + "\n";
  for (const Block& block : examination.blocks) {
    for (const Cell& c : block.cells) {
      text += block.subject + ',' + block.sweep + ',' + text_of(c.x) + ',' + text_of(c.y) + ',' +
              std::to_string(c.not_finite) + ',' + std::to_string(c.negative) + ',' + text_of(c.error) + ',' +
              text_of(c.error95) + ',' + text_of(c.rounding) + ',' + text_of(c.jump) + ',' + text_of(c.energy) + ',' +
              text_of(c.brightest) + ',' + c.symptoms + '\n';
    }
  }
  return complete ? text + std::string(kComplete) : text;
}

std::vector<Block> unfinished_blocks(const std::string& csv, const Examination& now) {
  std::vector<Block> blocks;
  const std::string head = first_line(now) + std::string(kHeading) + "\n";
  if (csv.rfind(head, 0) != 0 || csv.ends_with(kComplete)) {
    return blocks;
  }
  std::istringstream stream(csv.substr(head.size()));
  for (std::string line; std::getline(stream, line);) {
    const std::vector<std::string> row = split(line);
    if (row.size() != kColumns) {
      return {};
    }
    if (blocks.empty() || blocks.back().subject != row[0] || blocks.back().sweep != row[1]) {
      blocks.push_back({row[0], row[1], {}});
    }
    blocks.back().cells.push_back(cell_of(row));
  }
  std::erase_if(blocks, [&](const Block& block) { return !fits(block, now); });
  return blocks;
}

}  // namespace airlight::stability
