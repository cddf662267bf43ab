#include "app/cli/sampling_options.h"

#include <charconv>
#include <cmath>

#include "app/cli/choice_options.h"
#include "app/cli/progress.h"
#include "core/error.h"
#include "core/output/atomic_file.h"
#include "core/scene/json_format.h"

namespace airlight::cli {
double relative_error(const std::string& text, const std::string& place) {
  const bool percent = text.ends_with('%');
  const char* last = text.data() + text.size() - (percent ? 1 : 0);
  double value = 0.0;
  const auto parsed = std::from_chars(text.data(), last, value);
  if (parsed.ec != std::errc() || parsed.ptr != last || !(value > 0.0) || !std::isfinite(value)) {
    throw InputError(place + ": '" + text + "' is no relative error; write for example 0.5% or 0.005");
  }
  return percent ? value / 100.0 : value;
}

std::vector<Option> sampling_options(SamplingOptions& options) {
  return {{"--samples", "N", "Samples a pixel, of a method that samples; short for --set /render/samples=N",
           &options.samples, Completes::nothing, Range{1.0, 2147483647.0}},
          {"--time-limit", "TIME",
           "E.g. 50ms, 2s, 1min, or seconds; choose the most accurate method and quality whose tables and picture take "
           "the device no longer; with a method that samples: stop sampling after so long, short for --set "
           "/render/time_limit_s=SECONDS",
           &options.time_limit},
          {"--target-error", "ERROR",
           "Stop sampling when the mean standard error is this small, e.g. 0.5%; short for --set "
           "/render/target_error=0.005",
           &options.target_error},
          {"--checkpoint", "FILE", "Keep the samples in this file, and go on from it when it is there",
           &options.checkpoint, Completes::file}};
}

std::vector<std::string> overrides(const SamplingOptions& options, bool samples) {
  std::vector<std::string> assignments;
  if (options.samples) {
    assignments.push_back("/render/samples=" + std::to_string(*options.samples));
  }
  if (options.time_limit && samples) {
    const double ms = milliseconds_from(*options.time_limit, "render: --time-limit");
    assignments.push_back("/render/time_limit_s=" + format_number(1e-3 * ms));
  }
  if (options.target_error) {
    assignments.push_back("/render/target_error=" +
                          format_number(relative_error(*options.target_error, "render: --target-error")));
  }
  return assignments;
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
  return host;
}

}  // namespace airlight::cli
