#pragma once
// Reports on a finished render: for people, and as JSON for programs.

#include <optional>
#include <string>
#include <vector>

#include "app/cli/choice_options.h"
#include "app/cli/stopwatch.h"
#include "core/output/exr.h"
#include "core/render/render.h"
#include "core/spectra/colour.h"

namespace airlight::cli {

struct RenderReport {
  const Scene& scene;
  const Rendering& rendering;
  const Plan& plan;  // for the tables' sizes
  std::optional<DeviceInfo> device;
  std::vector<std::string> files;
  std::optional<ExrCounts> exr;
  std::string exr_format;              // "half" or "float"
  std::string view;                    // of the PNG: "DISPLAY / VIEW"; empty: no PNG
  std::optional<ChoiceReport> choice;  // for --tolerance and --time-limit
  const Stopwatch& watch;
  std::optional<ImageSize> tile = {};  // for a picture rendered in tiles
};

// One object with a line feed.
std::string json_report(const RenderReport& report);

// Every stretch of the run by name, with the parts of the render below it.
std::string timings_table(const RenderReport& report);

// Output of -v: device, method, parts left out, the picture's numbers.
std::string details(const RenderReport& report);

// One line each: values clamped on conversion to half, and other values that the files could not hold.
std::vector<std::string> exr_warnings(const ExrCounts& counts);

// Output of --dry-run --json: names of the files, the resolved preset, the passes. `wavelengths`: of --spectral, nm;
// each group of three has these passes.
std::string json_of_plan(const Scene& scene, const Plan& plan, const std::vector<std::string>& files,
                         const std::optional<ChoiceReport>& choice, const std::vector<double>& wavelengths = {});

// Output of --dry-run about --spectral.
std::string spectral_text(const Nodes& wavelengths);

// The passes of a plan with what each reads and writes, for --dry-run.
std::string plan_text(const Plan& plan);

}  // namespace airlight::cli
