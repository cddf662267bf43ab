#pragma once
// What the examination found: numbers for programs, one page for people, a map a sweep.

#include <string>
#include <vector>

#include "core/stability/judge.h"

namespace airlight::stability {

struct Examination {
  std::string version;  // "airlight 0.1.0"
  std::string device;
  std::string form;  // "short"
  std::vector<Sweep> sweeps;
  std::vector<Subject> subjects;
  std::vector<Block> blocks;
};

// One row a cell. The first line tells what made it, the last whether it is complete.
std::string csv_text(const Examination& examination, bool complete);

// The blocks of an earlier csv_text() of the same version, device and form that was left incomplete; none else.
// Blocks that do not fit the sweeps are left out.
std::vector<Block> unfinished_blocks(const std::string& csv, const Examination& now);

// The page, in Markdown.
std::string summary_text(const Examination& examination);

// A gnuplot script that draws SWEEP.svg and SWEEP.png of each sweep: a panel a subject, the error as colour, cells that
// fail marked by the letter of their worst symptom, those without a number blank. File names follow the text `out`.
// Needs gnuplot 5.4.
std::string map_script(const Examination& examination);

// The numbers of all blocks, in their order.
std::vector<Region> all_regions(const Examination& examination);

}  // namespace airlight::stability
