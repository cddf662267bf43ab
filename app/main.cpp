// Registers the commands; the only place that turns an error into an exit code.
#include <exception>
#include <memory>
#include <new>
#include <system_error>

#include "app/cli/terminal.h"
#include "app/commands/commands.h"
#include "core/base/error.h"
#include "core/base/huge_pages.h"
#include "core/base/memory_limit.h"
#include "core/output/ending.h"

namespace airlight::cli {
namespace {

constexpr int kFailed = 1;
constexpr int kBadUsage = 2;

Command root_command(Tool& tool) {
  struct Given {
    bool version = false;
    bool verbose = false;
  };
  const auto given = std::make_shared<Given>();
  Command command;
  command.name = tool.name;
  command.summary = tool.summary;
  command.description =
      "airlight computes the sky of a planet from a preset. A preset is a JSON file that describes air, sun, camera "
      "and method. airlight runs on any Vulkan device or on the processor alone, and needs no display. It writes "
      "scene-linear radiance as OpenEXR and a picture for people as PNG.\n\n"
      "airlight writes what another program may read to standard output, and everything for people to standard error.";
  command.examples = {{"airlight render earth-sunset", "Write out/earth-sunset.exr and out/earth-sunset.png"},
                      {"airlight presets", "List the built-in presets"}};
  command.options = {
      {"--version", "", "Print the version; with -v also the versions of the libraries", &given->version},
      {"-v,--verbose", "", "Print more detail with --version", &given->verbose}};
  command.run = [given, &tool] {
    if (given->version) {
      print(tool.name + " " + tool.version + "\n" + (given->verbose ? library_versions() : ""));
      return 0;
    }
    tell(help_text(tool, colour_on_stderr()));
    complain("no command given");
    return kBadUsage;
  };
  return command;
}

int run(int argc, char** argv) {
  Tool tool;
  tool.name = "airlight";
  tool.version = AIRLIGHT_VERSION;
  tool.summary = "physically based skies from a JSON preset to EXR and PNG";
  tool.commands = {render_command(), sequence_command(),  composite_command(),      luts_command(),    probe_command(),
                   check_command(),  methods_command(),   devices_command(),        presets_command(), diff_command(),
                   chart_command(),  stability_command(), completion_command(tool), man_command(tool)};
  tool.commands.push_back(help_command(tool));
  tool.root = root_command(tool);
  tool.environment = {
      {"AIRLIGHT_DEVICE", "Part of the name of the Vulkan device to use if --device is not given"},
      {"AIRLIGHT_CACHE",
       "Folder that keeps prepared shaders and tables from start to start (default: $XDG_CACHE_HOME/airlight); off "
       "keeps none"},
      {"AIRLIGHT_VALIDATION", "1 loads the Vulkan validation layer; if it gives any message, the run fails"},
      {"OCIO", "OpenColorIO config to use if --ocio-config is not given"},
      {"NO_COLOR", "Any value that is not empty turns off colour on the terminal"}};
  const int code = run_tool(tool, argc, argv);
  finish_stdout();
  return code;
}

}  // namespace
}  // namespace airlight::cli

int main(int argc, char** argv) {
  using namespace airlight;
  prefer_huge_heap();
  cli::ignore_broken_pipes();
  end_in_good_order_on_signals();
  try {
    return cli::run(argc, argv);
  } catch (const InputError& error) {
    cli::complain(error);
    return cli::kBadUsage;
  } catch (const RunError& error) {
    cli::complain(error);
  } catch (const std::bad_alloc&) {
    cli::complain("out of memory; ask for a smaller picture with --size" + memory_limit_words());
  } catch (const std::system_error& error) {
    const bool memory =
        error.code() == std::errc::resource_unavailable_try_again || error.code() == std::errc::not_enough_memory;
    cli::complain(memory ? "out of memory: no further thread can be started; ask for a smaller picture with --size, or "
                           "permit more processes (ulimit -u)" +
                               memory_limit_words()
                         : std::string("internal error: ") + error.what());
  } catch (const std::exception& error) {
    cli::complain(std::string("internal error: ") + error.what());
  }
  return cli::kFailed;
}
