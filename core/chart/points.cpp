#include "core/chart/points.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <functional>
#include <limits>
#include <set>
#include <sstream>
#include <utility>

#include "core/base/error.h"
#include "core/base/member.h"
#include "core/scene/json_format.h"

namespace airlight::chart {
namespace {

// One row of the table: how a member becomes a cell and comes back.
struct Column {
  std::string_view name;
  std::function<std::string(const Point&)> write;
  std::function<bool(Point&, const std::string&)> read;
};

bool parse(const std::string& cell, double& value) {
  const auto end = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  return end.ec == std::errc() && end.ptr == cell.data() + cell.size();
}

Column text_column(std::string_view name, MemberOf<Point, std::string> member) {
  return {name,
          [member](const Point& p) {
            std::string quoted = "\"";
            for (const char c : p.*member) {
              quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
            }
            return quoted + "\"";
          },
          [member](Point& p, const std::string& cell) {
            p.*member = cell;
            return true;
          }};
}

Column number_column(std::string_view name, MemberOf<Point, double> member) {
  return {name, [member](const Point& p) { return format_number(p.*member); },
          [member](Point& p, const std::string& cell) { return parse(cell, p.*member); }};
}

const std::vector<Column>& columns() {
  static const std::vector<Column> all{
      text_column("scene", &Point::scene),
      text_column("method", &Point::method),
      text_column("quality", &Point::quality),
      number_column("time_ms", &Point::time_ms),
      number_column("error_mean", &Point::error_mean),
      number_column("error_p95", &Point::error_p95),
      {"frontier", [](const Point& p) { return std::string(p.frontier ? "1" : "0"); },
       [](Point& p, const std::string& cell) {
         p.frontier = cell == "1";
         return cell == "0" || cell == "1";
       }},
      number_column("floor", &Point::floor),
      number_column("cpu_ms", &Point::cpu_ms),
      number_column("device_ms", &Point::device_ms),
      number_column("tables_ms", &Point::tables_ms),
      number_column("first_ms", &Point::first_ms),
      {"runs", [](const Point& p) { return std::to_string(p.runs); },
       [](Point& p, const std::string& cell) {
         double value = 0.0;
         const bool good = parse(cell, value) && value >= 0.0 && value < 1e6;
         p.runs = good ? static_cast<int>(value) : 0;
         return good;
       }},
      number_column("share_timed", &Point::share_timed),
      text_column("key", &Point::key),
      // A column for gnuplot, which cuts a quoted text at its first comma.
      {"label",
       [](const Point& p) {
         std::string label = p.quality;
         std::ranges::replace(label, ',', ';');
         std::ranges::replace(label, '"', '\'');
         return "\"" + label + "\"";
       },
       [](Point&, const std::string&) { return true; }},
  };
  return all;
}

// Cells of one line; quoted ones may hold commas and doubled quotes. Nothing when a quote is left open.
std::vector<std::string> split(const std::string& line, bool& closed) {
  std::vector<std::string> cells(1);
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (quoted && c == '"' && i + 1 < line.size() && line[i + 1] == '"') {
      cells.back() += c;
      ++i;
    } else if (c == '"') {
      quoted = !quoted;
    } else if (c == ',' && !quoted) {
      cells.emplace_back();
    } else {
      cells.back() += c;
    }
  }
  closed = !quoted;
  return cells;
}

std::string headings() {
  std::string line;
  for (const Column& column : columns()) {
    line += (line.empty() ? "" : ",") + std::string(column.name);
  }
  return line;
}

double geometric_mean(const std::vector<const Point*>& points, MemberOf<Point, double> member) {
  constexpr double kSmallest = 1e-9;
  double sum = 0.0;
  for (const Point* point : points) {
    sum += std::log(std::max(point->*member, kSmallest));
  }
  return std::exp(sum / static_cast<double>(points.size()));
}

}  // namespace

void mark_frontier(std::vector<Point>& points) {
  std::map<std::string, std::vector<Point*>> scenes;
  for (Point& point : points) {
    point.frontier = false;
    scenes[point.scene].push_back(&point);
  }
  for (auto& [scene, of_scene] : scenes) {
    std::ranges::stable_sort(of_scene, {}, [](const Point* p) { return std::pair(p->time_ms, p->error_mean); });
    double best = std::numeric_limits<double>::infinity();
    for (Point* point : of_scene) {
      point->frontier = point->error_mean < best;
      best = std::min(best, point->error_mean);
    }
  }
}

std::vector<Point> over_all_scenes(const std::vector<Point>& points) {
  std::set<std::string> scenes;
  std::map<std::pair<std::string, std::string>, std::vector<const Point*>> qualities;
  std::vector<std::pair<std::string, std::string>> order;
  for (const Point& point : points) {
    if (point.scene == kAllScenes) {
      continue;
    }
    scenes.insert(point.scene);
    auto& of_quality = qualities[{point.method, point.quality}];
    if (of_quality.empty()) {
      order.emplace_back(point.method, point.quality);
    }
    of_quality.push_back(&point);
  }
  std::vector<Point> means;
  for (const auto& quality : order) {
    const std::vector<const Point*>& of_quality = qualities[quality];
    if (of_quality.size() != scenes.size()) {
      continue;
    }
    Point mean;
    mean.scene = kAllScenes;
    mean.method = quality.first;
    mean.quality = quality.second;
    for (const MemberOf<Point, double> member : {&Point::time_ms, &Point::error_mean, &Point::error_p95, &Point::floor,
                                                 &Point::cpu_ms, &Point::device_ms, &Point::share_timed}) {
      mean.*member = geometric_mean(of_quality, member);
    }
    for (const Point* point : of_quality) {
      const auto count = static_cast<double>(of_quality.size());
      mean.tables_ms += point->tables_ms / count;
      mean.first_ms += point->first_ms / count;
      mean.runs += point->runs;
    }
    means.push_back(std::move(mean));
  }
  return means;
}

void sort_points(std::vector<Point>& points, const std::vector<std::string>& scenes) {
  const auto place = [&](const Point& p) {
    const auto found = std::ranges::find(scenes, p.scene);
    return p.scene == kAllScenes ? scenes.size() + 1 : static_cast<std::size_t>(found - scenes.begin());
  };
  std::ranges::stable_sort(points, [&](const Point& a, const Point& b) {
    return std::tuple(place(a), a.scene, a.time_ms) < std::tuple(place(b), b.scene, b.time_ms);
  });
}

std::string csv_text(const std::vector<Point>& points) {
  std::string text = headings() + "\n";
  for (const Point& point : points) {
    std::string line;
    for (const Column& column : columns()) {
      line += (line.empty() ? "" : ",") + column.write(point);
    }
    text += line + "\n";
  }
  return text;
}

std::vector<Point> read_csv(const std::string& text, const std::string& name) {
  const std::string remedy = "; expected a chart's table; remove the file or choose another folder";
  std::istringstream in(text);
  std::string line;
  if (!std::getline(in, line) || line != headings()) {
    throw InputError(name + ":1: is not the line of headings" + remedy);
  }
  std::vector<Point> points;
  for (int at = 2; std::getline(in, line); ++at) {
    bool closed = false;
    const std::vector<std::string> cells = split(line, closed);
    if (!closed || cells.size() != columns().size()) {
      throw InputError(name + ":" + std::to_string(at) + ": has " + std::to_string(cells.size()) + " cells, not " +
                       std::to_string(columns().size()) + remedy);
    }
    Point point;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      if (!columns()[i].read(point, cells[i])) {
        throw InputError(name + ":" + std::to_string(at) + ": '" + cells[i] + "' is no " +
                         std::string(columns()[i].name) + remedy);
      }
    }
    points.push_back(std::move(point));
  }
  return points;
}

}  // namespace airlight::chart
