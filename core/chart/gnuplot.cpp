#include "core/chart/gnuplot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <sstream>
#include <string_view>
#include <utility>

#include "core/base/gnuplot_text.h"
#include "core/base/text.h"
#include "core/chart/labels.h"
#include "core/chart/qualities.h"

namespace airlight::chart {
namespace {

// Okabe and Ito's palette, which colour-blind people can tell apart too.
constexpr std::array<std::string_view, 7> kColours{"#999999", "#E69F00", "#0072B2", "#009E73",
                                                   "#D55E00", "#CC79A7", "#56B4E9"};

// Shares of a canvas of 1200 x 1200, from its lower left corner.
struct Area {
  double left, bottom, right, top;
};
constexpr double kCanvas = 1200.0;
constexpr Area kLarge{0.07, 0.53, 0.98, 0.91};
constexpr Area kLargeAlone{0.07, 0.07, 0.98, 0.91};
constexpr int kColumns = 4;

std::string array_of(const std::string& name, const std::vector<std::string>& values) {
  return "array " + name + "[" + std::to_string(values.size()) + "] = [" + joined_of(values, gnuplot_text) + "]\n";
}

// A time in the unit that keeps it short: "20 \xC2\xB5s", "100 ms", "2 s".
std::string time_text(double ms) {
  if (ms < 1.0) {
    return rounded(1e3 * ms, 3) + " \xC2\xB5s";
  }
  return ms < 1e3 ? rounded(ms, 3) + " ms" : rounded(1e-3 * ms, 3) + " s";
}

// Marks of times with their labels. The marks are 1, 2 and 5 in each decade if about `most` labels hold them, otherwise
// whole decades. If there are more than `most` decades, only each second or third one has a label.
std::string time_marks(double low, double high, int most) {
  const auto first = static_cast<int>(std::floor(std::log10(low)));
  const auto last = static_cast<int>(std::floor(std::log10(high)));
  const int stride = (last - first + most) / most;
  const std::vector<double> in_decade = 3 * (last - first) < most ? std::vector{1.0, 2.0, 5.0} : std::vector{1.0};
  std::vector<std::string> marks;
  for (int decade = first; decade <= last; ++decade) {
    for (const double factor : in_decade) {
      const double ms = factor * std::pow(10.0, decade);
      const bool labelled = (last - decade) % stride == 0;
      marks.push_back(gnuplot_text(labelled ? time_text(ms) : "") + " " + rounded(ms, 3));
    }
  }
  return "set xtics (" + joined(marks, ", ") + ")\n";
}

// The ranges of the axes: all that is shown, with some room.
struct Ranges {
  double x_low = std::numeric_limits<double>::infinity();
  double x_high = 0.0;
  double y_low = std::numeric_limits<double>::infinity();  // percent
  double y_high = 0.0;

  void hold(const Point& point) {
    x_low = std::min(x_low, point.time_ms);
    x_high = std::max(x_high, point.time_ms);
    for (const double y : {100.0 * point.error_mean, 100.0 * point.floor}) {
      if (y > 0.0) {
        y_low = std::min(y_low, y);
        y_high = std::max(y_high, y);
      }
    }
  }
  Ranges with_room() const {
    const double wide = std::pow(x_high / x_low, 0.04) * 1.2;
    const double high = std::pow(y_high / y_low, 0.05) * 1.2;
    return {x_low / wide, x_high * wide, y_low / high, y_high * high};
  }
  std::string text(bool large) const {
    std::ostringstream out;
    // A small panel, or many decades: marks at whole decades alone.
    const bool few = y_high / y_low < (large ? 3000.0 : 300.0);
    out << "set ytics " << (few ? "(0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100)" : "autofreq") << "\n";
    out << time_marks(x_low, x_high, large ? 12 : 3);
    out << "set xrange [" << x_low << ":" << x_high << "]\nset yrange [" << y_low << ":" << y_high << "]\n";
    return out.str();
  }
};

// Name of the method each of whose points takes more than a hundred times as long as any point of another method; empty
// if there is none. It would leave most of the axis empty, so the chart tells its points in a line of text.
std::string far_method(const std::vector<Point>& points) {
  constexpr double kFar = 100.0;
  std::map<std::string, std::pair<double, double>> times;  // least and greatest
  for (const Point& point : points) {
    const auto [place, is_new] = times.try_emplace(point.method, point.time_ms, point.time_ms);
    place->second.first = std::min(place->second.first, point.time_ms);
    place->second.second = std::max(place->second.second, point.time_ms);
  }
  for (const auto& own : times) {
    const bool is_far = times.size() > 1 && std::ranges::all_of(times, [&](const auto& other) {
                          return other.first == own.first || other.second.second * kFar < own.second.first;
                        });
    if (is_far) {
      return own.first;
    }
  }
  return {};
}

std::vector<Point> without_method(const std::vector<Point>& points, const std::string& far) {
  std::vector<Point> shown;
  std::ranges::copy_if(points, std::back_inserter(shown), [&](const Point& point) { return point.method != far; });
  return shown;
}

// Tells the points of the far method in that scene at the right edge, at the height of their errors.
std::string far_label(const std::string& far, const std::vector<Point>& points, const std::string& scene,
                      const Ranges& ranges) {
  Ranges own;
  for (const Point& point : points) {
    if (point.method == far && point.scene == scene) {
      own.x_low = std::min(own.x_low, point.time_ms);
      own.x_high = std::max(own.x_high, point.time_ms);
      own.y_low = std::min(own.y_low, 100.0 * point.error_mean);
      own.y_high = std::max(own.y_high, 100.0 * point.error_mean);
    }
  }
  if (own.x_high == 0.0) {
    return {};
  }
  const double middle = std::clamp(std::sqrt(own.y_low * own.y_high), ranges.y_low, ranges.y_high);
  return "set label " +
         gnuplot_text(far + ": " + time_text(own.x_low) + " to " + time_text(own.x_high) + " for " +
                      rounded(own.y_high, 2) + " to " + rounded(own.y_low, 2) + " % \xE2\x86\x92") +
         " at graph 0.99, first " + rounded(middle, 6) + " right noenhanced front font words tc rgb '#666666'\n";
}

Ranges ranges_of(const std::vector<Point>& points, bool over_all) {
  Ranges ranges;
  for (const Point& point : points) {
    if ((point.scene == kAllScenes) == over_all) {
      ranges.hold(point);
    }
  }
  return ranges.with_room();
}

std::string margins(const Area& area) {
  std::ostringstream out;
  out << "set lmargin at screen " << area.left << "; set rmargin at screen " << area.right << "\nset bmargin at screen "
      << area.bottom << "; set tmargin at screen " << area.top << "\n";
  return out.str();
}

// Points of the frontier in the order of their claim to a label: the two ends, then always the one farthest from those
// that already have one.
std::vector<Label> wanted_labels(const std::vector<Point>& points, const std::string& scene) {
  std::vector<Label> wanted;
  std::vector<const Point*> rest;
  for (const Point& point : points) {
    if (point.scene != scene) {
      continue;
    }
    if (point.quality == kThreeChannels) {
      wanted.push_back({point.quality, {point.time_ms, 100.0 * point.error_mean}});
    } else if (point.frontier) {
      rest.push_back(&point);
    }
  }
  std::vector<const Point*> chosen;
  const auto distance = [](const Point* a, const Point* b) {
    return std::abs(std::log(a->time_ms / b->time_ms)) + 2.0 * std::abs(std::log(a->error_mean / b->error_mean));
  };
  while (!rest.empty()) {
    auto next = rest.begin();  // the fastest
    if (chosen.size() == 1) {
      next = rest.end() - 1;  // the most accurate
    } else if (chosen.size() > 1) {
      const auto nearest = [&](const Point* p) {
        double least = std::numeric_limits<double>::infinity();
        for (const Point* other : chosen) {
          least = std::min(least, distance(p, other));
        }
        return least;
      };
      next = std::ranges::max_element(rest, {}, nearest);
    }
    chosen.push_back(*next);
    rest.erase(next);
  }
  for (const Point* point : chosen) {
    wanted.push_back({point->method + ": " + point->quality, {point->time_ms, 100.0 * point->error_mean}});
  }
  return wanted;
}

std::string label_commands(const std::vector<Point>& points, const std::string& scene, const Ranges& ranges,
                           const Area& area, std::size_t most) {
  constexpr double kLetter = 6.4;
  constexpr double kLine = 17.0;
  const Frame frame{ranges.x_low,
                    ranges.x_high,
                    ranges.y_low,
                    ranges.y_high,
                    kCanvas * (area.right - area.left),
                    kCanvas * (area.top - area.bottom),
                    kLetter,
                    kLine};
  std::vector<Spot> spots;
  std::vector<Spot> front;
  for (const Point& point : points) {
    if (point.scene == scene) {
      spots.push_back({point.time_ms, 100.0 * point.error_mean});
      if (point.frontier) {
        front.push_back(spots.back());
      }
    }
  }
  std::ostringstream out;
  for (const Label& label : place_labels(wanted_labels(points, scene), spots, front, frame, most)) {
    out << "set label " << gnuplot_text(label.text) << " at " << label.text_at.x << "," << label.text_at.y
        << (label.left ? " left" : " right") << " noenhanced front font words\n";
  }
  return out.str();
}

constexpr std::string_view kHead = R"(# Draws chart.svg and chart.png from chart.csv in this folder: gnuplot chart.gp
if (!exists("out")) out = "chart"
set encoding utf8
set datafile separator ","
set datafile columnheaders
set datafile missing NaN
)";

// A row is drawn where its scene is the panel's and its method the curve's.
constexpr std::string_view kBody = R"(
is(name, value) = stringcolumn(name) eq value
percent(name) = 100 * column(name)
at(s, m, v) = is("scene", s) && is("method", m) && !is("quality", three) ? v : NaN
channels(s, v) = is("scene", s) && is("quality", three) ? v : NaN
front(s, v) = is("scene", s) && column("frontier") == 1 ? v : NaN
inside(s, v) = is("scene", s) ? v : NaN

set logscale xy
set format y "%g %%"
set grid xtics ytics lc rgb "#e4e4e4" lt 1
set tics nomirror
set border 3 lc rgb "#666666"
set key noautotitle

# One panel: the truth's own noise dashed, the points, those on the frontier joined and ringed, three channels a diamond.
panel = "plot \
  'chart.csv' using (inside(s, column('time_ms'))):(percent('floor')) with lines dt (8, 6) lw 1 lc rgb '#888888', \
  'chart.csv' using (front(s, column('time_ms'))):(percent('error_mean')) with lines lw 2 lc rgb '#000000', \
  for [m = 1:|methods|] 'chart.csv' using (at(s, methods[m], column('time_ms'))):(percent('error_mean')) with points pt 7 ps size lc rgb colours[m], \
  'chart.csv' using (front(s, column('time_ms'))):(percent('error_mean')) with points pt 6 ps 1.3 * size lw 1.5 lc rgb '#000000', \
  'chart.csv' using (channels(s, column('time_ms'))):(percent('error_mean')) with points pt 13 ps 1.6 * size lc rgb '#000000'"

do for [kind in "svg png"] {
  if (kind eq "svg") {
    set terminal svg size 1200,1200 font "Helvetica,13" background "#ffffff" dynamic
  } else {
    set terminal pngcairo size 1200,1200 font "Sans,10"
  }
  words = kind eq "svg" ? ",12" : ",9"
  set output out.".".kind
  set multiplot
  unset label
  set label heading at screen 0.07, screen 0.975 left noenhanced font kind eq "svg" ? ",12" : ",9" tc rgb "#666666"
)";

constexpr std::string_view kLegend =
    R"(  legend = ", for [m = 1:|methods|] NaN with points pt 7 ps 1.2 lc rgb colours[m] title methods[m]"
  legend = legend.", NaN with linespoints lw 2 pt 6 lc rgb '#000000' title 'frontier'"
  legend = legend.", NaN with lines dt (8, 6) lc rgb '#888888' title 'noise of the truth'"
)";

constexpr std::string_view kTail = R"(  unset multiplot
  set output
}
)";

std::string small_panels(const std::vector<std::string>& scenes, const Ranges& ranges) {
  const int rows = (static_cast<int>(scenes.size()) + kColumns - 1) / kColumns;
  std::string script = "  unset key\n  unset xlabel\n  unset ylabel\n  size = 0.6\n" + ranges.text(false);
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    const auto column = static_cast<int>(i) % kColumns;
    const int row = static_cast<int>(i) / kColumns;
    const double height = 0.44 / rows;
    const double bottom = 0.45 - height * (row + 1);
    const double left = 0.07 + 0.235 * column;
    script += margins({left, bottom + 0.035, left + 0.205, bottom + height - 0.03});
    script += "  s = " + gnuplot_text(scenes[i]) + "\n  unset label\n  set title s noenhanced offset 0,-0.6\n";
    script += std::string("  set format y ") + (column == 0 ? "'%g %%'" : "''") + "\n  eval(panel)\n";
  }
  return script;
}

}  // namespace

std::string gnuplot_script(const PlotText& text, const std::vector<Point>& points) {
  std::vector<std::string> colours;
  const std::string far = far_method(points);
  std::vector<std::string> methods;  // with points in the panels
  for (std::size_t i = 0; i < text.methods.size(); ++i) {
    if (text.methods[i] != far) {
      methods.push_back(text.methods[i]);
      colours.emplace_back(kColours[i % kColours.size()]);
    }
  }
  const std::string large = text.over_all ? std::string(kAllScenes) : text.scenes.front();
  std::vector<std::string> small = text.scenes;
  if (!text.over_all) {
    small.erase(small.begin());
  }
  const Area area = small.empty() ? kLargeAlone : kLarge;
  const std::vector<Point> shown = without_method(points, far);
  const Ranges ranges = ranges_of(shown, text.over_all);
  std::string script(kHead);
  script += "heading = " + gnuplot_text(text.title) + "\ntime_label = " + gnuplot_text(text.time_label) + "\n";
  script += "three = " + gnuplot_text(std::string(kThreeChannels)) + "\n";
  script += array_of("methods", methods) + array_of("colours", colours);
  script += kBody;
  script +=
      "  size = 1.0\n  set format y '%g %%'\n  set xlabel time_label offset 0,0.4\n  set ylabel 'mean relative error' "
      "offset 1,0\n";
  script += "  set key at screen 0.53, screen 0.962 center top vertical maxrows 2 samplen 1.5\n";
  script += ranges.text(true) + margins(area);
  script += label_commands(shown, large, ranges, area, 7) + far_label(far, points, large, ranges);
  script +=
      "  set label 'faster, and nearer to the truth: \xE2\x86\x99' at graph 0.012, graph 0.035 left front font words"
      " tc rgb '#666666'\n";
  script += "  s = " + gnuplot_text(large) + "\n";
  script += "  set title " + gnuplot_text(text.over_all ? "all scenes: geometric means" : large) +
            " noenhanced offset 0,-0.6\n";
  script += kLegend;
  script += "  eval(panel.legend)\n";
  if (!small.empty()) {
    script += small_panels(small, ranges_of(shown, false));
  }
  return script + std::string(kTail);
}

}  // namespace airlight::chart
