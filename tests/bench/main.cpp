// airlight_bench: checks every method's pictures on a device, then times its passes. $AIRLIGHT_DEVICE chooses the
// device.

#include <benchmark/benchmark.h>

#include <cstdio>
#include <exception>
#include <filesystem>
#include <iostream>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "tests/bench/benchmarks.h"
#include "tests/bench/checksums.h"
#include "tests/bench/pictures.h"

namespace airlight::bench {
namespace {

struct Options {
  std::string checksums;  // empty: checksums.txt beside the program
  std::string update;     // empty: check and time
};

void print_help() {
  std::puts(
      "airlight_bench [--checksums FILE | --update-checksums FILE] [--benchmark_...]\n"
      "\n"
      "Renders every method in every scene at 256x144 and compares the pictures' moments with the checksums, then "
      "times\n"
      "sky/METHOD/SCENE/SIZE, frame/METHOD/SCENE/SIZE, air/METHOD-march-STEPS/SCENE/SIZE, "
      "air/METHOD-volume-SLICES/SCENE/SIZE\n"
      "and tables/METHOD/SCENE by device timestamps.\n"
      "AIRLIGHT_DEVICE=part-of-its-name chooses the device.\n"
      "Exit codes: 0 done, 1 a picture differs or the device fails, 2 bad usage.\n"
      "\n"
      "  --checksums FILE         the checksums; by default checksums.txt beside the program\n"
      "  --update-checksums FILE  write the pictures' checksums instead, and time nothing\n"
      "\n"
      "Example: AIRLIGHT_DEVICE=NVIDIA airlight_bench --benchmark_filter='sky/march/.*/1920x1080'\n");
  benchmark::PrintDefaultHelp();
}

// "--name VALUE" or "--name=VALUE" at argument i, which moves on to the value.
std::optional<std::string> value_of(std::string_view name, const std::vector<std::string>& arguments, std::size_t& i) {
  const std::string& argument = arguments[i];
  if (argument.starts_with(std::string(name) + '=')) return argument.substr(name.size() + 1);
  if (argument != name) return std::nullopt;
  if (i + 1 == arguments.size()) throw InputError(argument + ": expected a file name after it; see --help");
  return arguments[++i];
}

// Parses the arguments that Google Benchmark has left.
Options parse(const std::vector<std::string>& arguments) {
  Options options;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    if (const auto checksums = value_of("--checksums", arguments, i)) {
      options.checksums = *checksums;
    } else if (const auto update = value_of("--update-checksums", arguments, i)) {
      options.update = *update;
    } else {
      throw InputError(arguments[i] +
                       ": unknown option; expected --checksums FILE, --update-checksums FILE or one of " +
                       "Google Benchmark's; see --help");
    }
  }
  if (options.checksums.empty()) {
    options.checksums = std::filesystem::read_symlink("/proc/self/exe").replace_filename("checksums.txt");
  }
  return options;
}

bool lists_only(const std::vector<std::string>& arguments) {
  for (const std::string& argument : arguments) {
    if (argument == "--benchmark_list_tests" || argument == "--benchmark_list_tests=true") return true;
  }
  return false;
}

std::string device_text(const DeviceInfo& device) {
  return device.name + ", " + device.driver + ", Vulkan " + device.api_version;
}

// Returns the number of pictures that differ.
std::size_t check_pictures(Session& session, const std::string& file) {
  const Checksums expected = read_checksums(file);
  const Checksums found = render_checked_pictures(session.pictures());
  const std::vector<std::string> lines = differences(expected, found);
  for (const std::string& line : lines) std::cerr << line << '\n';
  std::cerr << found.size() << " pictures rendered on " << device_text(session.pictures().device()) << "; "
            << lines.size() << " differ from " << file << " by more than " << kMeanTolerance
            << " of a mean or in a mean logarithm\n";
  return lines.size();
}

int run(int argc, char** argv) {
  const bool list_only = lists_only({argv + 1, argv + argc});
  benchmark::Initialize(&argc, argv, print_help);
  const Options options = parse({argv + 1, argv + argc});
  Session session;
  if (!options.update.empty()) {
    Executor& executor = session.pictures();
    write_checksums(options.update, render_checked_pictures(executor), device_text(executor.device()));
    return 0;
  }
  std::size_t different = 0;
  if (!list_only) {
    different = check_pictures(session, options.checksums);
    benchmark::AddCustomContext("device", device_text(session.pictures().device()));
    benchmark::AddCustomContext("pictures_that_differ", std::to_string(different));
  }
  register_benchmarks(session);
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  if (different > 0) {
    std::cerr << "airlight_bench: " << different << " pictures differ from their checksums, listed above the timings\n";
  }
  return different > 0 || session.failed ? 1 : 0;
}

}  // namespace
}  // namespace airlight::bench

int main(int argc, char** argv) {
  try {
    return airlight::bench::run(argc, argv);
  } catch (const airlight::InputError& error) {
    std::cerr << "airlight_bench: " << error.what() << '\n';
    return 2;
  } catch (const std::exception& error) {
    std::cerr << "airlight_bench: " << error.what() << '\n';
    return 1;
  }
}
