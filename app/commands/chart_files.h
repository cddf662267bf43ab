#pragma once
// A chart as files in a folder: chart.csv, chart.json, chart.gp, and from gnuplot chart.svg and chart.png.

#include <filesystem>
#include <string>
#include <vector>

#include "core/chart/run.h"

namespace airlight::cli {

struct ChartFiles {
  std::filesystem::path folder;
  std::vector<std::string> scenes;
  std::vector<std::string> methods;
  chart::Settings settings;
};

// The points with those over all scenes, sorted, the frontier marked, as in all files.
std::vector<chart::Point> finished(std::vector<chart::Point> points, const std::vector<std::string>& scenes);

// The points in an earlier run's chart.csv; none when there is no such file. Throws InputError when it is damaged.
std::vector<chart::Point> read_points(const std::filesystem::path& folder);

void write_points(const std::filesystem::path& folder, const std::vector<chart::Point>& points);

// chart.csv, chart.json and chart.gp. Returns their names.
std::vector<std::string> write_chart(const ChartFiles& files, const chart::RunOutcome& outcome);

// Runs gnuplot on them. Throws RunError when gnuplot is missing (says how to get it) or fails; then neither picture is
// new.
std::vector<std::string> plot_chart(const ChartFiles& files);

// The whole chart as JSON.
std::string chart_json(const ChartFiles& files, const chart::RunOutcome& outcome);

}  // namespace airlight::cli
