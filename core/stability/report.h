#pragma once
// The examination's results: numbers for programs, one page for people, a map for each sweep.

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

// One row a cell. The first line names version, device and form; the last says whether the table is complete.
std::string csv_text(const Examination& examination, bool complete);

// The blocks of an earlier, incomplete csv_text() of the same version, device and form; otherwise none. Blocks that do
// not fit the sweeps are left out.
std::vector<Block> unfinished_blocks(const std::string& csv, const Examination& now);

// The page, in Markdown.
std::string summary_text(const Examination& examination);

// A gnuplot script that draws SWEEP.svg and SWEEP.png for each sweep: a panel for each subject, the error as colour,
// failing cells marked by the letter of their worst symptom, cells without a number blank. File names follow the text
// `out`. Needs gnuplot 5.4.
std::string map_script(const Examination& examination);

// The numbers of all blocks, in their order.
std::vector<Region> all_regions(const Examination& examination);

}  // namespace airlight::stability
