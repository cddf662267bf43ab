#include "core/chart/gnuplot.h"

#include <array>
#include <string_view>

#include "core/chart/points.h"

namespace airlight::chart {
namespace {

// Okabe and Ito's palette: told apart by everyone.
constexpr std::array<std::string_view, 7> kColours{"#999999", "#E69F00", "#0072B2", "#009E73",
                                                   "#D55E00", "#CC79A7", "#56B4E9"};

// In single quotes gnuplot takes everything as it stands but a quote, which is doubled.
std::string quoted(const std::string& text) {
  std::string out = "'";
  for (const char c : text) {
    out += c == '\'' ? std::string("''") : std::string(1, c);
  }
  return out + "'";
}

std::string array_of(const std::string& name, const std::vector<std::string>& values) {
  std::string list;
  for (const std::string& value : values) {
    list += (list.empty() ? "" : ", ") + quoted(value);
  }
  return "array " + name + "[" + std::to_string(values.size()) + "] = [" + list + "]\n";
}

constexpr std::string_view kHead = R"(# Draws chart.svg and chart.png from chart.csv in this folder: gnuplot chart.gp
if (!exists("out")) out = "chart"
set encoding utf8
set datafile separator ","
set datafile columnheaders
set datafile missing NaN
)";

// A row shows where its scene and method are those of the panel and the curve.
constexpr std::string_view kBody = R"(
is(name, value) = stringcolumn(name) eq value
percent(name) = 100 * column(name)
short(text) = text[1:longest]
at(s, m, v) = is("scene", s) && is("method", m) ? v : NaN
front(s, v) = is("scene", s) && column("frontier") == 1 ? v : NaN
inside(s, v) = is("scene", s) ? v : NaN

set logscale xy
set format x "%.0s%c"
set format y "%g %%"
set grid xtics ytics mytics lc rgb "#dddddd", lc rgb "#eeeeee"
set tics nomirror
set border 3 lc rgb "#666666"
set key noautotitle
set bars 0

# One panel: what a curve's mean leaves to its 95th percentile as thin bars, the frontier, the truth's own noise dashed,
# the points, and labels at all of them or at the frontier's.
panel = "plot \
  for [m = 1:|methods|] 'chart.csv' using (at(s, methods[m], column('time_ms'))):(percent('error_mean')):(percent('error_mean')):(percent('error_p95')) with yerrorbars pt -1 lw 1 lc rgb colours[m].'' , \
  'chart.csv' using (inside(s, column('time_ms'))):(percent('floor')) with lines dt (8, 6) lw 1 lc rgb '#444444', \
  'chart.csv' using (front(s, column('time_ms'))):(percent('error_mean')) with lines lw 2 lc rgb '#000000', \
  for [m = 1:|methods|] 'chart.csv' using (at(s, methods[m], column('time_ms'))):(percent('error_mean')) with points pt 7 ps size lc rgb colours[m], \
  'chart.csv' using (labelled(s, column('time_ms'))):(percent('error_mean')):(short(stringcolumn('label'))) with labels left rotate by -25 offset 0.5,-0.3 font small noenhanced"

do for [kind in "svg png"] {
  if (kind eq "svg") {
    set terminal svg size 1500,1500 font "Helvetica,14" background "#ffffff" dynamic
  } else {
    set terminal pngcairo size 1200,1200 font "Sans,9"
  }
  set output out.".".kind
  small = kind eq "svg" ? ",10" : ",7"
  set multiplot title heading noenhanced
)";

constexpr std::string_view kTail = R"(  unset multiplot
  set output
}
)";

}  // namespace

std::string gnuplot_script(const PlotText& text) {
  std::vector<std::string> colours;
  for (std::size_t i = 0; i < text.methods.size(); ++i) {
    colours.emplace_back(kColours[i % kColours.size()]);
  }
  const std::string large = text.over_all ? std::string(kAllScenes) : text.scenes.front();
  std::vector<std::string> small = text.scenes;
  if (!text.over_all) {
    small.erase(small.begin());
  }
  std::string script(kHead);
  script += "heading = " + quoted(text.title) + "\ntime_label = " + quoted(text.time_label) + "\n";
  script += array_of("methods", text.methods) + array_of("colours", colours);
  script += small.empty() ? "" : array_of("scenes", small);
  script += kBody;
  script += "  labelled(s, v) = inside(s, v)\n  longest = 60\n  size = 0.8\n  set xlabel time_label\n";
  script += "  set ylabel 'mean relative error; bars to the 95th percentile'\n";
  script += "  set key outside right top\n";
  script += "  s = " + quoted(large) + "\n";
  script += "  set title " + quoted(text.over_all ? "all scenes, geometric means" : large) + " noenhanced font ',13'\n";
  script += small.empty() ? "  set origin 0, 0\n  set size 1, 0.97\n" : "  set origin 0, 0.50\n  set size 1, 0.47\n";
  script += R"(  legend = ", for [m = 1:|methods|] NaN with points pt 7 ps 1 lc rgb colours[m] title methods[m]"
  legend = legend.", NaN with lines lw 2 lc rgb '#000000' title 'frontier', NaN with lines dt (8, 6) lc rgb '#444444' title 'noise of the truth'"
  eval(panel.legend)
)";
  if (!small.empty()) {
    script += R"(  labelled(s, v) = front(s, v)
  longest = 16
  size = 0.5
  unset key
  unset ylabel
  unset xlabel
  columns = 4
  rows = int((|scenes| + columns - 1) / columns)
  do for [i = 1:|scenes|] {
    s = scenes[i]
    set title s noenhanced font ",11"
    set origin ((i - 1) % columns) * 1.0 / columns, 0.5 - 0.5 * (int((i - 1) / columns) + 1) / rows
    set size 1.0 / columns, 0.5 / rows
    eval(panel)
  }
)";
  }
  return script + std::string(kTail);
}

}  // namespace airlight::chart
