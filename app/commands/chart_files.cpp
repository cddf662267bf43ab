#include "app/commands/chart_files.h"

#include <algorithm>
#include <fstream>
#include <iterator>

#include "app/cli/json_writer.h"
#include "app/commands/gnuplot.h"
#include "core/base/member.h"
#include "core/chart/gnuplot.h"
#include "core/output/atomic_file.h"

namespace airlight::cli {
namespace {

namespace fs = std::filesystem;
using chart::Point;

std::string size_text(ImageSize size) {
  return std::to_string(size.width) + " x " + std::to_string(size.height);
}

std::string plot_title(const ChartFiles& files, const chart::RunOutcome& outcome) {
  const chart::Settings& s = files.settings;
  return "airlight " AIRLIGHT_VERSION " on " + outcome.device.name + "; pictures of " + size_text(s.image) +
         ", compared with path-trace at up to " + size_text({s.compared_columns, s.compared_rows}) + " pixels";
}

void write_point(JsonWriter& json, const Point& p) {
  json.begin_object().key("scene").value(p.scene).key("method").value(p.method).key("quality").value(p.quality);
  json.key("time_ms").value(p.time_ms).key("cpu_ms").value(p.cpu_ms).key("device_ms").value(p.device_ms);
  json.key("tables_ms").value(p.tables_ms).key("first_ms").value(p.first_ms).key("runs").value(p.runs);
  json.key("share_timed").value(p.share_timed).key("error_mean").value(p.error_mean);
  json.key("error_p95").value(p.error_p95).key("floor").value(p.floor).key("frontier").value(p.frontier).end_object();
}

}  // namespace

std::vector<Point> finished(std::vector<Point> points, const std::vector<std::string>& scenes) {
  if (scenes.size() > 1) {
    const std::vector<Point> means = chart::over_all_scenes(points);
    points.insert(points.end(), means.begin(), means.end());
  }
  chart::mark_frontier(points);
  chart::sort_points(points, scenes);
  return points;
}

std::vector<Point> read_points(const fs::path& folder) {
  const fs::path file = folder / "chart.csv";
  std::ifstream in(file, std::ios::binary);
  if (!in) {
    return {};
  }
  const std::string text{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  return chart::read_csv(text, file.string());
}

void write_points(const fs::path& folder, const std::vector<Point>& points) {
  write_file(folder / "chart.csv", chart::csv_text(points));
}

std::string chart_json(const ChartFiles& files, const chart::RunOutcome& outcome) {
  JsonWriter json;
  json.begin_object().key("version").value(AIRLIGHT_VERSION).key("device").value(outcome.device.name);
  json.key("driver").value(outcome.device.driver);
  json.key("time").value(outcome.cpu_time ? "CPU time of the process" : "device timestamps");
  json.key("width").value(files.settings.image.width).key("height").value(files.settings.image.height);
  json.key("compared_columns").value(files.settings.compared_columns);
  json.key("compared_rows").value(files.settings.compared_rows).key("truth_error").value(files.settings.truth_error);
  json.key("points").begin_array();
  for (const Point& point : finished(outcome.points, files.scenes)) {
    write_point(json, point);
  }
  json.end_array().key("left_out").begin_array();
  for (const std::string& line : outcome.left_out) {
    json.value(line);
  }
  return json.end_array().end_object().take();
}

std::vector<std::string> write_chart(const ChartFiles& files, const chart::RunOutcome& outcome) {
  const std::vector<Point> points = finished(outcome.points, files.scenes);
  write_points(files.folder, points);
  write_file(files.folder / "chart.json", chart_json(files, outcome));
  const auto with_points = [&](const std::vector<std::string>& names, MemberOf<Point, std::string> member) {
    std::vector<std::string> kept;
    for (const std::string& name : names) {
      if (std::ranges::any_of(points, [&](const Point& p) { return p.*member == name; })) {
        kept.push_back(name);
      }
    }
    return kept;
  };
  chart::PlotText text;
  text.scenes = with_points(files.scenes, &Point::scene);
  text.methods = with_points(files.methods, &Point::method);
  text.over_all = std::ranges::any_of(points, [](const Point& p) { return p.scene == chart::kAllScenes; });
  text.title = plot_title(files, outcome);
  text.time_label = std::string("time of a picture whose kept tables are there, by ") +
                    (outcome.cpu_time ? "the CPU's clock, all threads added" : "device timestamps");
  write_file(files.folder / "chart.gp", chart::gnuplot_script(text, points));
  std::vector<std::string> names;
  for (const char* name : {"chart.csv", "chart.json", "chart.gp"}) {
    names.push_back((files.folder / name).string());
  }
  return names;
}

std::vector<std::string> plot_chart(const ChartFiles& files) {
  return plot("chart", files.folder, "chart.gp", "chart", {".svg", ".png"});
}

}  // namespace airlight::cli
