#include <algorithm>
#include <utility>

#include "core/base/text.h"
#include "core/stability/report.h"

namespace airlight::stability {
namespace {

const Sweep& sweep_named(const Examination& e, const std::string& name) {
  return *std::find_if(e.sweeps.begin(), e.sweeps.end(), [&](const Sweep& sweep) { return sweep.name == name; });
}

std::string range(double low, double high) {
  return low == high ? rounded(low, 3) : rounded(low, 3) + " to " + rounded(high, 3);
}

std::string short_name(Quantity q) {
  const std::string_view name = quantity_name(q);
  return std::string(name.substr(0, name.find(',')));
}

std::string worst_text(char symptom, double worst) {
  const std::string name(symptom_name(symptom));
  switch (symptom) {
    case 'F':
    case 'N':
      return name + " (" + rounded(worst, 3) + " values in a cell)";
    case 'G':
    case 'L':
      return name + " (" + rounded(worst, 3) + " of what arrives)";
    default:
      return name + (worst < 10.0 ? " " + percent(worst, 2) : " over 1000 %");
  }
}

// All that one cause explains, over sweeps and symptoms: one row of the page.
struct Row {
  std::string cause;
  std::vector<std::pair<char, double>> worst;  // by symptom
  std::vector<Region> where;                   // one a sweep
  std::size_t cells = 0;
};

void add_symptom(Row& row, const Region& region) {
  const auto same =
      std::find_if(row.worst.begin(), row.worst.end(), [&](const auto& one) { return one.first == region.symptom; });
  if (same == row.worst.end()) {
    row.worst.emplace_back(region.symptom, region.worst);
  } else {
    same->second = region.symptom == 'L' ? std::min(same->second, region.worst) : std::max(same->second, region.worst);
  }
}

void add_place(Row& row, const Region& region) {
  const auto same =
      std::find_if(row.where.begin(), row.where.end(), [&](const Region& one) { return one.sweep == region.sweep; });
  if (same == row.where.end()) {
    row.where.push_back(region);
    return;
  }
  same->x_low = std::min(same->x_low, region.x_low);
  same->x_high = std::max(same->x_high, region.x_high);
  same->y_low = std::min(same->y_low, region.y_low);
  same->y_high = std::max(same->y_high, region.y_high);
}

std::vector<Row> rows_of(const std::vector<Region>& regions, const std::string& subject) {
  std::vector<Row> rows;
  for (const Region& region : regions) {
    if (region.subject != subject) {
      continue;
    }
    auto row = std::find_if(rows.begin(), rows.end(), [&](const Row& one) { return one.cause == region.cause; });
    if (row == rows.end()) {
      row = rows.insert(rows.end(), Row{region.cause, {}, {}, 0});
    }
    add_symptom(*row, region);
    add_place(*row, region);
    row->cells += region.cells;
  }
  return rows;
}

std::string row_text(const Examination& e, const Row& row) {
  std::string worst;
  for (const auto& [symptom, value] : row.worst) {
    worst += (worst.empty() ? "" : ", ") + worst_text(symptom, value);
  }
  std::string where;
  for (const Region& r : row.where) {
    const Sweep& sweep = sweep_named(e, r.sweep);
    where += (where.empty() ? "" : "; ") + r.sweep + ": " + short_name(sweep.x) + " " + range(r.x_low, r.x_high) +
             ", " + short_name(sweep.y) + " " + range(r.y_low, r.y_high);
  }
  return "| " + (row.cause.empty() ? "**not explained**" : row.cause) + " | " + worst + " | " + where + " |\n";
}

// The typical and the worst error of one subject, over the cells that do not fail.
std::string sound_text(const Examination& e, const Subject& subject) {
  std::vector<double> errors;
  std::size_t cells = 0;
  for (const Block& block : e.blocks) {
    for (const Cell& cell : block.subject == subject.name ? block.cells : std::vector<Cell>()) {
      ++cells;
      if (cell.symptoms.empty()) {
        errors.push_back(cell.error);
      }
    }
  }
  if (cells == 0) {
    return {};
  }
  std::sort(errors.begin(), errors.end());
  const std::string median = errors.empty() ? "" : percent(errors[errors.size() / 2], 2);
  return std::to_string(errors.size()) + " of " + std::to_string(cells) + " cells hold" +
         (errors.empty() ? "" : ", with a median error of " + median);
}

}  // namespace

std::vector<Region> all_regions(const Examination& e) {
  std::vector<Region> list;
  for (const Block& block : e.blocks) {
    const auto subject = std::find_if(e.subjects.begin(), e.subjects.end(),
                                      [&](const Subject& one) { return one.name == block.subject; });
    const std::vector<Region> found = regions(block, sweep_named(e, block.sweep), *subject);
    list.insert(list.end(), found.begin(), found.end());
  }
  return list;
}

std::string summary_text(const Examination& e) {
  const std::vector<Region> found = all_regions(e);
  const auto unexplained = std::count_if(found.begin(), found.end(), [](const Region& r) { return r.cause.empty(); });
  std::string text = "# Where methods fail\n\n`airlight stability`, " + e.form + " form, " + e.version + " on " +
                     e.device + ". Each cell of a sweep is looked at in many directions and compared with a " +
                     "converged quality of the same method (`sky-view` and `analytic`: of `march`), and the device's " +
                     "32 bits with the same formulas in double. What a method leaves out by design is no failure " +
                     "here; `airlight methods` has that.\n\n";
  text += unexplained == 0 ? "Every failing region has a known cause.\n"
                           : "**" + std::to_string(unexplained) + " failing regions are not explained.**\n";
  for (const Subject& subject : e.subjects) {
    const std::string sound = sound_text(e, subject);
    if (sound.empty()) {
      continue;
    }
    text += "\n## " + subject.name + "\n\n" + sound + "; it fails where the mean error exceeds " +
            percent(subject.method->validity.error, 2) + ".\n";
    std::string table;
    for (const Row& row : rows_of(found, subject.name)) {
      table += row_text(e, row);
    }
    if (!table.empty()) {
      text += "\n| cause | symptoms, the worst of each | where |\n|---|---|---|\n" + table;
    }
  }
  text += "\n## Sweeps\n\n";
  for (const Sweep& sweep : e.sweeps) {
    text += "- " + sweep.name + ": " + sweep.title + "; " + std::string(quantity_name(sweep.x)) + " (" +
            rounded(sweep.xs.front(), 3) + " to " + rounded(sweep.xs.back(), 3) + ") by " +
            std::string(quantity_name(sweep.y)) + " (" + rounded(sweep.ys.front(), 3) + " to " +
            rounded(sweep.ys.back(), 3) + ").\n";
  }
  text += "\n## Left out\n\n";
  for (const LeftOut& one : subjects_left_out()) {
    text += "- " + one.name + ": " + one.reason + ".\n";
  }
  return text;
}

}  // namespace airlight::stability
