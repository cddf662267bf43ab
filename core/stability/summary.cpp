#include <algorithm>
#include <cstdio>
#include <map>

#include "core/stability/report.h"

namespace airlight::stability {
namespace {

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

std::string percent(double share) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2g %%", 100.0 * share);
  return text;
}

const Sweep& sweep_named(const Examination& e, const std::string& name) {
  return *std::find_if(e.sweeps.begin(), e.sweeps.end(), [&](const Sweep& sweep) { return sweep.name == name; });
}

std::string range(double low, double high) {
  return low == high ? number(low) : number(low) + " to " + number(high);
}

std::string worst_text(const Region& region) {
  switch (region.symptom) {
    case 'F':
    case 'N':
      return number(region.worst) + " values in a cell";
    case 'G':
      return number(region.worst) + " of what arrives";
    default:
      return percent(region.worst);
  }
}

std::string short_name(Quantity q) {
  const std::string_view name = quantity_name(q);
  return std::string(name.substr(0, name.find(',')));
}

// Regions of one method, sweep, symptom and cause in one row of the page.
struct Row {
  Region region;
  std::size_t parts = 0;
};

std::vector<Row> rows_of(const std::vector<Region>& regions) {
  std::vector<Row> rows;
  for (const Region& region : regions) {
    const auto same = std::find_if(rows.begin(), rows.end(), [&](const Row& row) {
      return row.region.subject == region.subject && row.region.sweep == region.sweep &&
             row.region.symptom == region.symptom && row.region.cause == region.cause;
    });
    if (same == rows.end()) {
      rows.push_back({region, 1});
      continue;
    }
    Region& all = same->region;
    all.cells += region.cells;
    all.x_low = std::min(all.x_low, region.x_low);
    all.x_high = std::max(all.x_high, region.x_high);
    all.y_low = std::min(all.y_low, region.y_low);
    all.y_high = std::max(all.y_high, region.y_high);
    all.worst = std::max(all.worst, region.worst);
    ++same->parts;
  }
  return rows;
}

std::string row_text(const Examination& e, const Row& row) {
  const Region& r = row.region;
  const Sweep& sweep = sweep_named(e, r.sweep);
  return "| " + r.sweep + " | " + std::string(symptom_name(r.symptom)) + " | " + short_name(sweep.x) + " " +
         range(r.x_low, r.x_high) + ", " + short_name(sweep.y) + " " + range(r.y_low, r.y_high) + " | " +
         std::to_string(r.cells) + " of " + std::to_string(r.of) + " | " + worst_text(r) + " | " +
         (r.cause.empty() ? "**not explained**" : r.cause) + " |\n";
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
  const std::string median = errors.empty() ? "" : percent(errors[errors.size() / 2]);
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
  const std::vector<Row> rows = rows_of(all_regions(e));
  const auto unexplained = std::count_if(rows.begin(), rows.end(), [](const Row& r) { return r.region.cause.empty(); });
  std::string text = "# Where methods fail\n\n`airlight stability`, " + e.form + " form, " + e.version + " on " +
                     e.device + ". Each cell of a sweep is looked at in many directions and compared with the same " +
                     "method at a converged quality (`sky-view` and `analytic`: with `march`), and the device's 32 " +
                     "bits with the same formulas in double. stability.csv has every number, SWEEP.png a map.\n\n";
  text += unexplained == 0 ? "Every failing region has a known cause.\n"
                           : "**" + std::to_string(unexplained) + " failing regions are not explained.**\n";
  for (const Subject& subject : e.subjects) {
    const std::string sound = sound_text(e, subject);
    if (sound.empty()) {
      continue;
    }
    text += "\n## " + subject.name + "\n\n" + sound + "; it fails where the error exceeds " +
            percent(subject.method->validity.error) + ".\n";
    std::string table;
    for (const Row& row : rows) {
      table += row.region.subject == subject.name ? row_text(e, row) : "";
    }
    if (!table.empty()) {
      text += "\n| sweep | symptom | where | cells | worst | cause |\n|---|---|---|---|---|---|\n" + table;
    }
  }
  text += "\n## Sweeps\n\n";
  for (const Sweep& sweep : e.sweeps) {
    text += "- " + sweep.name + ": " + sweep.title + "; " + std::string(quantity_name(sweep.x)) + " (" +
            number(sweep.xs.front()) + " to " + number(sweep.xs.back()) + ") by " +
            std::string(quantity_name(sweep.y)) + " (" + number(sweep.ys.front()) + " to " + number(sweep.ys.back()) +
            ").\n";
  }
  text += "\n## Left out\n\n";
  for (const LeftOut& one : subjects_left_out()) {
    text += "- " + one.name + ": " + one.reason + ".\n";
  }
  return text;
}

}  // namespace airlight::stability
