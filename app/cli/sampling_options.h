#pragma once
// The options of a method that samples: when to stop, and a file to go on from.

#include <optional>
#include <string>
#include <vector>

#include "app/cli/cli.h"
#include "core/methods/method.h"

namespace airlight::cli {

struct SamplingOptions {
  std::optional<int> samples;
  std::optional<std::string> time_limit;  // of a method that samples; of the others app/cli/choice_options.h
  std::optional<std::string> target_error;
  std::string checkpoint;
};

// "0.5%" or "0.005" as a number. Throws InputError: "PLACE: ...".
double relative_error(const std::string& text, const std::string& place);

std::vector<Option> sampling_options(SamplingOptions& options);

// As overrides of the preset, "POINTER=JSON"; `samples`: its method samples, so a time limit is its own. Throws
// InputError when the target is no number or percentage, or the limit no time.
std::vector<std::string> overrides(const SamplingOptions& options, bool samples);

// How the method runs: its checkpoint, and a line on the terminal that tells how far it is unless `quiet`. Throws
// InputError when the checkpoint cannot be written.
HostOptions host_options(const SamplingOptions& options, bool quiet);

}  // namespace airlight::cli
