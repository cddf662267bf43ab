#include <algorithm>
#include <memory>
#include <set>

#include "app/cli/preset_source.h"
#include "app/cli/progress.h"
#include "app/cli/sampling_options.h"
#include "app/cli/scene_options.h"
#include "app/cli/terminal.h"
#include "app/commands/chart_files.h"
#include "app/commands/commands.h"
#include "app/render/table_files.h"
#include "core/base/error.h"
#include "core/gpu/kept_files.h"
#include "core/library/built_in.h"
#include "core/library/embedded_presets.h"
#include "core/methods/method.h"
#include "core/output/last_words.h"
#include "core/scene/thing_kinds.h"

namespace airlight::cli {
namespace {

namespace fs = std::filesystem;

struct ChartGiven {
  SceneOptions scene;  // of each preset
  std::vector<std::string> presets;
  std::vector<std::string> methods;
  std::string folder;
  std::string truth_folder;
  std::optional<double> budget;
  std::optional<double> truth_error;
  bool json = false;
  bool quiet = false;
};

std::vector<std::string> chosen_methods(const ChartGiven& given) {
  std::vector<std::string> known;
  for (const SkyMethod& method : methods()) {
    known.emplace_back(method.info.name);
  }
  for (const std::string& name : given.methods) {
    if (std::ranges::find(known, name) == known.end()) {
      throw InputError("chart: --method: no method '" + name + "'" + did_you_mean(name, known) +
                       "; 'airlight methods' lists them");
    }
  }
  std::vector<std::string> chosen;
  for (const std::string& name : known) {
    if (given.methods.empty() || std::ranges::find(given.methods, name) != given.methods.end()) {
      chosen.push_back(name);
    }
  }
  return chosen;
}

// The user's cache folder, since truths serve every chart; beside the chart where there is none.
fs::path truth_folder(const ChartGiven& given) {
  if (!given.truth_folder.empty()) {
    return given.truth_folder;
  }
  const fs::path cache = given.scene.no_cache ? fs::path() : user_cache_folder();
  return cache.empty() ? fs::path(given.folder) / "truth" : cache / "truth";
}

void make_folders(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error || !fs::is_directory(folder)) {
    throw InputError("chart: " + folder.string() + ": the folder cannot be made: " + error.message() +
                     "; name another with -o or --truth");
  }
}

std::string whole_points(std::size_t count) {
  return std::to_string(count) + (count == 1 ? " point of the chart is" : " points of the chart are") +
         " whole; the same command goes on from there";
}

chart::Settings settings_of(const ChartGiven& given) {
  chart::Settings settings = chart::parse_settings(embedded_chart_list(), "presets/chart.json");
  if (!given.presets.empty()) {
    settings.scenes = given.presets;
    std::set<std::string> seen;
    for (const std::string& preset : given.presets) {
      if (!seen.insert(preset).second) {
        throw InputError("chart: the preset '" + preset + "' is named twice; name it once");
      }
    }
  }
  if (given.truth_error) {
    settings.truth_error = *given.truth_error;
  }
  return settings;
}

void require_knows(const SkyMethod& method, const Scene& scene, const std::string& place) {
  for (const ThingKind& kind : kThingKinds) {
    if (kind.stands_in(scene) && !(method.info.*kind.known)) {
      throw InputError(place + " knows no " + std::string(kind.name) + "; choose a preset without");
    }
  }
}

chart::RunOrder order_of(const ChartGiven& given, chart::Settings& settings) {
  chart::RunOrder order;
  order.methods = chosen_methods(given);
  for (const std::string& preset : settings.scenes) {
    SceneOptions options = given.scene;
    options.preset = preset;
    if (!options.size) {
      options.size = std::to_string(settings.image.width) + "x" + std::to_string(settings.image.height);
    }
    Scene scene = load_scene(options);
    for (const std::string& name : given.methods) {
      require_knows(*find_method(name), scene, "chart: " + preset + ": --method " + name);
    }
    settings.image = scene.image;
    order.scenes.push_back({preset, std::move(scene)});
  }
  order.settings = settings;
  order.budget_s = given.budget.value_or(0.0);
  order.truth_folder = truth_folder(given);
  order.known = read_points(given.folder);
  order.version = AIRLIGHT_VERSION;
  DeviceOptions wanted = wanted_device(given.scene);
  wanted.stores_tables = false;  // the tables' times are measured
  order.open_device = [wanted] { return std::make_unique<Executor>(wanted); };
  order.keep = [folder = fs::path(given.folder)](const std::vector<chart::Point>& points) {
    write_points(folder, points);
    say_when_ended(whole_points(points.size()));
  };
  say_when_ended(whole_points(order.known.size()));
  if (!given.quiet) {
    order.progress = terminal_progress();
  }
  return order;
}

int run_chart_command(const ChartGiven& given) {
  if (given.folder.empty()) {
    throw InputError("chart: no folder given; write -o DIR");
  }
  chart::Settings settings = settings_of(given);
  const chart::RunOrder order = order_of(given, settings);
  const MadeFolder made(given.folder);
  make_folders(order.truth_folder);
  const chart::RunOutcome outcome = chart::run_chart(order);
  clear_progress();
  require_valid_vulkan();
  const ChartFiles files{given.folder, settings.scenes, order.methods, settings};
  const auto say = [&](const std::vector<std::string>& lines) {
    for (const std::string& line : lines) {
      tell(given.quiet ? "" : line + "\n");
    }
  };
  if (outcome.resumed > 0 && !given.quiet) {
    tell(std::to_string(outcome.resumed) + " of " + std::to_string(outcome.points.size()) +
         " points were there already\n");
  }
  if (!outcome.left_out.empty() && !given.quiet) {
    complain("warning: " + std::to_string(outcome.left_out.size()) +
             " points were left out for want of time, the first: " + outcome.left_out.front() +
             "; the same command goes on with them");
  }
  say(write_chart(files, outcome));
  if (given.json) {
    print(chart_json(files, outcome));
  }
  say(plot_chart(files));
  return 0;
}

}  // namespace

Command chart_command() {
  const auto given = std::make_shared<ChartGiven>();
  Command command;
  command.name = "chart";
  command.summary = "Chart the error of every method against its time";
  command.description =
      "airlight times every method on each preset, at every quality of the method's list. It compares the pictures "
      "with those of path-trace, which are the truth. The error is the mean relative error and its 95th percentile "
      "over the sky, without the sun's disc. From above the air, without sky in the picture, or with things in the "
      "scene, it is that over everything that is not black. Methods that do not know such things are left out. If a "
      "preset has spectra, the truth has 48 wavelengths. Methods that render any number of wavelengths in one pass are "
      "then charted at 3 to 24 wavelengths and in three channels.\n\n"
      "airlight writes chart.csv, chart.json and the gnuplot script chart.gp into the folder. gnuplot draws chart.svg "
      "and chart.png: one panel for each preset and, with several presets, one for all of them. A line joins the "
      "points on the frontier. A diamond marks the three channels.\n\n"
      "The time is that of a picture whose kept tables are already made. It is the median of several pictures, by "
      "device timestamps. On a software device it is the CPU time of all threads, which other programs disturb less. "
      "The files also hold what the tables and the first picture cost. path-trace is timed at the compared pixels "
      "only, and its time is scaled up.\n\n"
      "airlight keeps the truths in the folder truth of its cache folder ($XDG_CACHE_HOME/airlight), or of the chart's "
      "folder with --no-cache. If a run was interrupted, or had no time for every point, the same command continues "
      "from chart.csv.";
  command.examples = {{"airlight chart my-sky.json -o chart --size 64x36 --method orders --method march --budget 5",
                       "Two methods on a preset of your own, in a few seconds"}};
  command.positionals = {{.metavar = "PRESET",
                          .help = "presets to chart (default: those of presets/chart.json)",
                          .target = &given->presets,
                          .required = false,
                          .offers = built_in_names()}};
  command.options = {
      {"-o,--output", "DIR", "Folder for the chart; airlight makes it if it is missing", &given->folder,
       Completes::folder},
      {"--budget", "SECONDS",
       "Take about this long (default: no limit). At most half of it is for the truth. The points that cost most are "
       "left out",
       &given->budget, Completes::nothing, Range{1.0, 1e6}},
      {"--method", "NAME", "Chart only this method", &given->methods},
      share_option("--truth-error", "Mean standard error of the truth, e.g. 0.1% (default: that of presets/chart.json)",
                   given->truth_error),
      {"--truth", "DIR", "Folder that keeps the truths from run to run", &given->truth_folder, Completes::folder},
      {"--size", "WxH", "Size in pixels of the timed pictures (default: that of presets/chart.json)",
       &given->scene.size},
      {"--set", "POINTER=JSON", "Change any key of every preset, e.g. /sun/elevation_deg=3", &given->scene.set},
      {"--json", "", "Also print chart.json on standard output", &given->json},
      {"-q,--quiet", "", "Say nothing but errors", &given->quiet}};
  append(command.options, device_options(given->scene));
  command.run = [given] { return run_chart_command(*given); };
  return command;
}

}  // namespace airlight::cli
