#include <memory>

#include "app/cli/json_writer.h"
#include "app/cli/scene_options.h"
#include "app/cli/terminal.h"
#include "app/commands/commands.h"
#include "app/render/table_files.h"
#include "core/base/error.h"
#include "core/methods/ready.h"
#include "core/output/finite.h"
#include "core/scene/preset.h"

namespace airlight::cli {
namespace {

struct LutsGiven {
  SceneOptions scene;
  std::string folder;
  bool json = false;
  bool quiet = false;
};

int run_luts(const LutsGiven& given) {
  if (given.folder.empty()) {
    throw InputError("luts: no folder given; write -o DIR");
  }
  const Scene scene = load_scene(given.scene);
  require_folder(given.folder);
  std::unique_ptr<Executor> executor;
  const std::vector<TableDump> tables = bake_tables(device_on_demand(given.scene, executor), ready(scene));
  require_valid_vulkan();
  if (tables.empty()) {
    throw InputError("luts: the method " + scene.render.method + " uses no tables; choose another with --method");
  }
  for (const TableDump& table : tables) {
    const std::string fault =
        finite_fault("the table " + table.name, table.rgba, static_cast<std::size_t>(table.width), 4);
    if (!fault.empty()) {
      throw RunError(given.scene.preset + ": " + fault + "; nothing was written");
    }
  }
  const Provenance provenance{to_json(scene), scene.render.method, AIRLIGHT_VERSION, executor->device().name};
  JsonWriter json;
  json.begin_object().key("method").value(scene.render.method).key("device").value(provenance.device);
  json.key("files").begin_array();
  for (const std::string& file : write_tables(given.folder, tables, provenance)) {
    tell(given.quiet ? "" : file + "\n");
    json.value(file);
  }
  json.end_array().end_object();
  if (given.json) {
    print(json.take());
  }
  return 0;
}

}  // namespace

Command luts_command() {
  const auto given = std::make_shared<LutsGiven>();
  Command command;
  command.name = "luts";
  command.summary = "Write every table of a preset's method as a float EXR and a picture";
  command.description =
      "The attributes of the EXR say what the numbers are (airlight:quantity, airlight:unit), what the axes stand for "
      "(airlight:axis:x, airlight:axis:y), and how to compute this for a texel (airlight:constants, airlight:decode). "
      "presets/README.md, section Tables, explains the language. The picture shows the largest value as white.";
  command.examples = {
      {"airlight luts earth-noon -o tables", "Write each table into the folder tables, as EXR and PNG"}};
  command.positionals = {preset_positional(given->scene)};
  command.options = {{"-o,--output", "DIR", "Folder for the tables; airlight makes it if it is missing", &given->folder,
                      Completes::folder}};
  append(command.options, scene_options(given->scene));
  command.options.push_back({"--json", "", "Print one JSON object with the names of the files", &given->json});
  command.options.push_back({"-q,--quiet", "", "Say nothing but errors", &given->quiet});
  command.run = [given] { return run_luts(*given); };
  return command;
}

}  // namespace airlight::cli
