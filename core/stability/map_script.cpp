#include <algorithm>
#include <cmath>
#include <sstream>

#include "core/base/gnuplot_text.h"
#include "core/base/text.h"
#include "core/measure/colour_map.h"
#include "core/stability/report.h"

namespace airlight::stability {
namespace {

constexpr double kLowError = 1e-5;  // of the colours; smaller errors have the darkest
constexpr int kAcross = 2;          // panels in a row
constexpr int kPanelWidth = 520;
constexpr int kPanelHeight = 330;
constexpr int kTitleHeight = 60;

std::string palette() {
  constexpr int kParts = 9;
  std::string text = "set palette defined (";
  for (int i = 0; i <= kParts; ++i) {
    const measure::Colour c = measure::error_colour(static_cast<double>(i) / kParts);
    char code[16];
    std::snprintf(code, sizeof code, "'#%02x%02x%02x'", c[0], c[1], c[2]);
    text += (i > 0 ? ", " : "") + std::to_string(i) + " " + code;
  }
  return text + ")\n";
}

// Rows "column row error letter", with the letter of the worst symptom, "-" for none.
std::string data_block(const std::string& name, const Sweep& sweep, const Block& block) {
  std::ostringstream out;
  out << "$" << name << " << EOD\n";
  for (std::size_t i = 0; i < block.cells.size(); ++i) {
    const Cell& cell = block.cells[i];
    out << i % sweep.xs.size() << " " << i / sweep.xs.size() << " ";
    if (cell.not_finite > 0 || !std::isfinite(cell.error)) {
      out << "NaN";
    } else {
      out << std::max(cell.error, kLowError);
    }
    out << " " << (cell.symptoms.empty() ? "-" : cell.symptoms.substr(0, 1)) << "\n";
  }
  out << "EOD\n";
  return out.str();
}

// Numbers at the middles of cells, at most about a dozen.
std::string tics(const char* axis, const std::vector<double>& values) {
  const std::size_t stride = values.size() / 12 + 1;
  std::string text = std::string("  set ") + axis + "tics (";
  for (std::size_t i = 0; i < values.size(); i += stride) {
    text += (i > 0 ? ", " : "") + gnuplot_text(rounded(values[i], 3)) + " " + std::to_string(i);
  }
  return text + ")\n  set " + axis + "range [-0.5:" + rounded(static_cast<double>(values.size()) - 0.5, 6) + "]\n";
}

std::string map_of(const Sweep& sweep, const std::vector<const Block*>& blocks) {
  std::string data;
  std::string panels;
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const std::string name = "block" + std::to_string(i);
    data += data_block(name, sweep, *blocks[i]);
    panels += "  set title " + gnuplot_text(blocks[i]->subject) + " noenhanced\n  plot $" + name +
              " using 1:2:3 with image, $" + name +
              " using 1:2:($3 < 0.02 ? letter(strcol(4)) : '') with labels tc rgb '#ffffff', $" + name +
              " using 1:2:($3 < 0.02 ? '' : letter(strcol(4))) with labels tc rgb '#000000'\n";
  }
  const int down = (static_cast<int>(blocks.size()) + kAcross - 1) / kAcross;
  const std::string size =
      std::to_string(kAcross * kPanelWidth) + "," + std::to_string(kTitleHeight + down * kPanelHeight);
  return "\n" + data + "do for [kind in \"svg png\"] {\n  if (kind eq \"svg\") {\n    set terminal svg size " + size +
         " font \"Helvetica,12\" background \"#ffffff\" dynamic\n  } else {\n    set terminal pngcairo size " + size +
         " font \"Sans,9\"\n  }\n  set output out." + gnuplot_text(sweep.name + ".") + ".kind\n" + tics("x", sweep.xs) +
         tics("y", sweep.ys) + "  set xlabel " + gnuplot_text(quantity_name(sweep.x)) + " noenhanced\n  set ylabel " +
         gnuplot_text(quantity_name(sweep.y)) + " noenhanced\n  set multiplot layout " + std::to_string(down) + "," +
         std::to_string(kAcross) + " title " + gnuplot_text(sweep.name + ": " + sweep.title) +
         ".\"\\n\".letters noenhanced\n" + panels + "  unset multiplot\n  set output\n}\n";
}

}  // namespace

std::string map_script(const Examination& examination) {
  std::vector<std::string> letters;
  for (const Symptom& symptom : kSymptoms) {
    letters.push_back(std::string(1, symptom.letter) + " " + std::string(symptom.name));
  }
  std::string script =
      "# Draws SWEEP.svg and SWEEP.png of each sweep: gnuplot stability.gp\n"
      "if (!exists(\"out\")) out = \"\"\nset encoding utf8\nletters = " +
      gnuplot_text("Colour: mean relative error. Letters: " + joined(letters)) + "\n" + palette() +
      "set logscale cb\nset cbrange [1e-5:1]\nset format cb '%g'\n"
      "set tics nomirror out scale 0.5\nset xtics rotate\nunset key\nletter(text) = text eq '-' ? '' : text\n";
  for (const Sweep& sweep : examination.sweeps) {
    std::vector<const Block*> shown;
    for (const Block& block : examination.blocks) {
      if (block.sweep == sweep.name) {
        shown.push_back(&block);
      }
    }
    script += shown.empty() ? std::string() : map_of(sweep, shown);
  }
  return script;
}

}  // namespace airlight::stability
