#pragma once
// Words beside the points of a panel, few enough that none lies on another.

#include <string>
#include <vector>

namespace airlight::chart {

// A panel with logarithmic axes.
struct Frame {
  double x_low, x_high;  // ranges of the axes
  double y_low, y_high;
  double width, height;  // of the panel, pixels
  double letter, line;   // width of a letter and height of a line, pixels
};

struct Spot {
  double x, y;
};

struct Label {
  std::string text;
  Spot at;           // the point that it names
  bool left = true;  // the text begins at `text_at`; else it ends there
  Spot text_at{};    // of the text's middle line
};

// Places labels in the order given, each right above its point, below, or on the left, where it covers no point, no
// line between two neighbours of `line`, no other label, and stays in the panel. Those that find no place are left out,
// as are those beyond `most`.
std::vector<Label> place_labels(const std::vector<Label>& wanted, const std::vector<Spot>& points,
                                const std::vector<Spot>& line, const Frame& frame, std::size_t most);

}  // namespace airlight::chart
