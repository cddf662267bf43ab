#include "app/cli/sampling_options.h"

#include "app/cli/choice_options.h"
#include "app/cli/interruption.h"
#include "app/cli/progress.h"
#include "core/output/atomic_file.h"
#include "core/scene/json_format.h"

namespace airlight::cli {

Option share_option(const std::string& name, const std::string& help, std::optional<double>& target) {
  return {.names = name,
          .metavar = "ERROR",
          .help = help,
          .target = &target,
          .range = Range{1e-6, 1.0},
          .percent = Percent::share};
}

std::vector<Option> sampling_options(SamplingOptions& options) {
  return grouped(
      "Method",
      {{"--samples", "N", "Samples per pixel, for a method that samples", &options.samples, Completes::nothing,
        Range{1.0, 1e9}},
       {"--time-limit", "TIME",
        "Choose the most accurate method and quality whose tables and picture take the device no longer than this, "
        "e.g. 50ms, 2s, 1min. With a method that samples: stop sampling after this time, once each pixel has 32 "
        "samples",
        &options.time_limit},
       share_option("--target-error", "Stop sampling when the mean standard error is this small, e.g. 0.5%",
                    options.target_error),
       {"--checkpoint", "FILE", "Keep the samples in this file. If the file exists, continue from its samples",
        &options.checkpoint, Completes::file}});
}

std::vector<Override> overrides(const SamplingOptions& options, bool samples) {
  std::vector<Override> all;
  if (options.samples) {
    const std::string count = std::to_string(*options.samples);
    all.push_back({"/render/samples=" + count, "--samples " + count});
  }
  if (options.time_limit && samples) {
    const double ms = milliseconds_from(*options.time_limit, "--time-limit");
    all.push_back({"/render/time_limit_s=" + format_number(1e-3 * ms), "--time-limit " + *options.time_limit});
  }
  if (options.target_error) {
    const std::string error = format_number(*options.target_error);
    all.push_back({"/render/target_error=" + error, "--target-error " + error});
  }
  return all;
}

HostOptions host_options(const SamplingOptions& options, bool quiet) {
  HostOptions host;
  if (!options.checkpoint.empty()) {
    require_writable(options.checkpoint);
    host.checkpoint = options.checkpoint;
  }
  if (!quiet) {
    host.report = terminal_progress();
  }
  if (!options.checkpoint.empty()) {
    host.report = [shown = host.report](double done) { return (!shown || shown(done)) && Interruption::signal() == 0; };
  }
  return host;
}

}  // namespace airlight::cli
