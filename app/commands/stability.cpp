#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>

#include "app/cli/json_writer.h"
#include "app/cli/progress.h"
#include "app/cli/scene_options.h"
#include "app/cli/terminal.h"
#include "app/commands/commands.h"
#include "app/commands/gnuplot.h"
#include "app/render/table_files.h"
#include "core/base/error.h"
#include "core/output/atomic_file.h"
#include "core/output/last_words.h"
#include "core/output/png.h"
#include "core/stability/examine.h"
#include "core/stability/report.h"

namespace airlight::cli {
namespace {

namespace fs = std::filesystem;
using namespace stability;

struct StabilityGiven {
  std::string folder;
  std::vector<std::string> methods;
  std::vector<std::string> sweeps;
  bool quick = false;
  bool brief = false;
  bool full = false;
  bool json = false;
  bool quiet = false;
  SceneOptions scene;  // for the device's options
};

std::vector<std::string> subject_names() {
  std::vector<std::string> names;
  for (const Subject& subject : subjects()) {
    names.push_back(subject.name);
  }
  return names;
}

std::vector<std::string> sweep_names() {
  std::vector<std::string> names;
  for (const Sweep& sweep : sweeps(Form::quick)) {
    names.push_back(sweep.name);
  }
  return names;
}

bool wanted(const std::vector<std::string>& chosen, const std::string& name) {
  return chosen.empty() || std::ranges::find(chosen, name) != chosen.end();
}

Form form_of(const StabilityGiven& given) {
  if (given.quick + given.brief + given.full > 1) {
    throw InputError("stability: --quick, --short and --full exclude each other; give one");
  }
  return given.quick ? Form::quick : given.full ? Form::full : Form::brief;
}

Examination wanted_examination(const StabilityGiven& given, const DeviceInfo& device) {
  const Form form = form_of(given);
  Examination e;
  e.version = std::string("airlight ") + AIRLIGHT_VERSION;
  e.device = device.name + ", " + device.driver;
  std::replace(e.device.begin(), e.device.end(), '\n', ' ');
  e.form = form == Form::quick ? "quick" : form == Form::full ? "full" : "short";
  for (Sweep& sweep : sweeps(form)) {
    if (wanted(given.sweeps, sweep.name)) {
      e.sweeps.push_back(std::move(sweep));
    }
  }
  for (Subject& subject : subjects()) {
    if (wanted(given.methods, subject.name)) {
      e.subjects.push_back(std::move(subject));
    }
  }
  return e;
}

std::string contents_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

std::vector<std::string> map_names(const Examination& e) {
  std::vector<std::string> names;
  for (const Sweep& sweep : e.sweeps) {
    const bool shown = std::ranges::any_of(e.blocks, [&](const Block& block) { return block.sweep == sweep.name; });
    for (const char* ending : {".svg", ".png"}) {
      if (shown) {
        names.push_back(sweep.name + ending);
      }
    }
  }
  return names;
}

const Block* block_of(const std::vector<Block>& blocks, const Subject& subject, const Sweep& sweep) {
  const auto found = std::ranges::find_if(
      blocks, [&](const Block& block) { return block.subject == subject.name && block.sweep == sweep.name; });
  return found == blocks.end() ? nullptr : &*found;
}

std::string whole_maps(double done, double all) {
  return std::to_string(static_cast<int>(done)) + " of " + std::to_string(static_cast<int>(all)) +
         " maps are whole; the same command goes on from there";
}

// Examines every block that is missing. At any time the file of numbers is complete up to the last block.
void examine_all(Examination& e, const fs::path& csv, const DeviceOnDemand& device, bool quiet) {
  const std::vector<Block> before = unfinished_blocks(contents_of(csv), e);
  if (!before.empty() && !quiet) {
    tell("going on after " + std::to_string(before.size()) + " maps that an interrupted run left in " + csv.string() +
         "\n");
  }
  double all = 0.0;
  for (const Sweep& sweep : e.sweeps) {
    for (const Subject& subject : e.subjects) {
      all += takes_part(subject, sweep) ? 1.0 : 0.0;
    }
  }
  const std::function<bool(double)> progress = quiet ? nullptr : terminal_progress();
  double done = 0.0;
  say_when_ended(whole_maps(static_cast<double>(before.size()), all));
  for (const Sweep& sweep : e.sweeps) {
    ConvergedShots converged;
    for (const Subject& subject : e.subjects) {
      if (!takes_part(subject, sweep)) {
        continue;
      }
      const Block* old = block_of(before, subject, sweep);
      e.blocks.push_back(old != nullptr ? *old : examine(device, subject, sweep, converged, [&](double part) {
        if (progress) {
          progress((done + part) / all);
        }
      }));
      done += 1.0;
      write_file(csv, csv_text(e, false));
      say_when_ended(whole_maps(done, all));
    }
  }
  clear_progress();
}

std::string stability_json(const Examination& e, const fs::path& folder) {
  JsonWriter json;
  json.begin_object().key("form").value(e.form).key("device").value(e.device).key("maps").begin_array();
  for (const Block& block : e.blocks) {
    json.begin_object().key("sweep").value(block.sweep).key("method").value(block.subject).end_object();
  }
  json.end_array().key("files").begin_array();
  for (const char* name : {"stability.md", "stability.csv", "stability.gp"}) {
    json.value((folder / name).string());
  }
  for (const std::string& name : map_names(e)) {
    json.value((folder / name).string());
  }
  return json.end_array().end_object().take();
}

int run_stability(const StabilityGiven& given) {
  if (given.folder.empty()) {
    throw InputError("stability: no folder given; write -o DIR");
  }
  form_of(given);
  require_folder(given.folder);
  std::unique_ptr<Executor> executor;
  const DeviceOnDemand device = device_on_demand(given.scene, executor);
  Examination e = wanted_examination(given, device().device());
  const MadeFolder made(given.folder);
  const fs::path folder = given.folder;
  examine_all(e, folder / "stability.csv", device, given.quiet);
  require_valid_vulkan();
  const std::string summary = summary_text(e);
  write_file(folder / "stability.md", summary);
  write_file(folder / "stability.csv", csv_text(e, true));
  write_file(folder / "stability.gp", map_script(e));
  plot("stability", folder, "stability.gp", "", map_names(e));
  if (!given.quiet) {
    tell((folder / "stability.md").string() + "\n");
  }
  if (given.json) {
    print(stability_json(e, folder));
  }
  return 0;
}

}  // namespace

Command stability_command() {
  const auto given = std::make_shared<StabilityGiven>();
  Command command;
  command.name = "stability";
  command.summary = "Map where each method fails: over sun, altitude, horizon, air, planet, steps and tables";
  command.description =
      "airlight examines each cell of a sweep. It looks for values that are negative or not finite. It measures the "
      "error against a converged quality of the same method (analytic and sky-view: of march). It looks for steps "
      "between neighbours that the slope of the radiance does not explain, and for energy gained or lost. It measures "
      "what the 32 bits of the device lose against the same formulas in double.\n\n"
      "DIR/stability.md is the summary. DIR/stability.csv has every number. DIR/SWEEP.svg and .png are a map for each "
      "sweep; gnuplot draws them from DIR/stability.gp. If a run was interrupted, start it again with the same folder "
      "and options: it continues where it stopped.";
  command.examples = {{"airlight stability -o stability --quick --sweep steps --method march",
                       "One small map of one method, in seconds"}};
  command.options = {{"-o,--output", "DIR", "Folder for the results; airlight makes it if it is missing",
                      &given->folder, Completes::folder},
                     {"--short", "", "Use a coarse grid: minutes on two processor cores (the default)", &given->brief},
                     {"--full", "", "Use a fine grid: an hour or more on two processor cores", &given->full},
                     {"--quick", "", "Use the coarsest grid, to check a change", &given->quick},
                     {.names = "--sweep",
                      .metavar = "NAME",
                      .help = "Examine only this sweep",
                      .target = &given->sweeps,
                      .choices = sweep_names()},
                     {.names = "--method",
                      .metavar = "NAME",
                      .help = "Examine only this method",
                      .target = &given->methods,
                      .choices = subject_names()},
                     {"--json", "", "Print one JSON object with the maps made and the files written", &given->json},
                     {"-q,--quiet", "", "Print no progress and no notes", &given->quiet}};
  append(command.options, device_options(given->scene));
  command.run = [given] { return run_stability(*given); };
  return command;
}

}  // namespace airlight::cli
