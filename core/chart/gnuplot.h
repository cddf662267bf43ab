#pragma once
// The picture of a chart as a gnuplot script, to be run beside chart.csv and restyled at will.

#include <string>
#include <vector>

#include "core/chart/points.h"

namespace airlight::chart {

struct PlotText {
  std::vector<std::string> scenes;   // one panel each; every one has points
  std::vector<std::string> methods;  // one colour each
  bool over_all = false;   // there are points of kAllScenes: a large panel; else the first scene is the large one
  std::string title;       // device, version, sizes
  std::string time_label;  // what the horizontal axis shows
};

// Reads chart.csv; writes OUT.svg and OUT.png, OUT being "chart" unless `gnuplot -e 'out="..."'` says otherwise.
// `points`: those of chart.csv, for the ranges of the axes and the places of the labels. Needs gnuplot 5.4.
std::string gnuplot_script(const PlotText& text, const std::vector<Point>& points);

}  // namespace airlight::chart
