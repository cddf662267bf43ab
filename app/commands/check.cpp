#include <memory>

#include "app/cli/preset_source.h"
#include "app/cli/terminal.h"
#include "app/commands/commands.h"
#include "core/error.h"
#include "core/methods/method.h"
#include "core/scene/resolve.h"

namespace airlight::cli {
namespace {

struct Given {
  std::vector<std::string> presets;
  std::vector<std::string> set;
  bool verbose = false;
  bool quiet = false;
};

// Every problem of every file is told before the command fails.
int check_presets(const Given& given) {
  bool all_good = true;
  for (const std::string& argument : given.presets) {
    try {
      Preset preset = find_preset(argument);
      for (const std::string& assignment : given.set) {
        apply_override(preset, assignment);
      }
      const Scene scene = resolve(preset, method_infos());
      if (!given.quiet) {
        print(preset.source + ": good\n" + (given.verbose ? describe(scene) : std::string()));
      }
    } catch (const InputError& error) {
      complain(error.what());
      all_good = false;
    }
  }
  return all_good ? 0 : 2;
}

}  // namespace

Command check_command() {
  const auto given = std::make_shared<Given>();
  Command command;
  command.name = "check";
  command.summary = "Find every problem of presets";
  command.description =
      "Each problem stands on a line of its own: file and line, the key as a JSON pointer, what is wrong, what was "
      "expected. Exit code 2 when there is any.";
  command.examples = {{"airlight check my-sky.json", "Say whether a preset is good, or everything that is not"},
                      {"airlight check -v earth-noon", "Also print the whole scene with its units"}};
  command.positionals = {{"PRESET",
                          "preset file, built-in preset, EXR of airlight's, or - for standard input",
                          &given->presets,
                          true,
                          Completes::file,
                          {},
                          built_in_names()}};
  command.options = {
      {"--set", "POINTER=JSON", "Check with a key changed, e.g. /camera/pitch_deg=20", &given->set, {}, {}, {}, {}},
      {"-q,--quiet", "", "Say nothing about good presets", &given->quiet, {}, {}, {}, {}},
      {"-v,--verbose", "", "Print the resolved scene with its units", &given->verbose, {}, {}, {}, {}}};
  command.run = [given] { return check_presets(*given); };
  return command;
}

}  // namespace airlight::cli
