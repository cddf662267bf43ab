#pragma once
// The options of a method that samples: when to stop, and a file to continue from.

#include <optional>
#include <string>
#include <vector>

#include "app/cli/cli.h"
#include "app/cli/scene_options.h"
#include "core/methods/method.h"

namespace airlight::cli {

struct SamplingOptions {
  std::optional<int> samples;
  std::optional<std::string> time_limit;  // for a method that samples; for the others see app/cli/choice_options.h
  std::optional<double> target_error;
  std::string checkpoint;
};

// A relative error above 0, up to 100 %: "0.5%" or "0.005".
Option share_option(const std::string& name, const std::string& help, std::optional<double>& target);

std::vector<Option> sampling_options(SamplingOptions& options);

// `samples`: the preset's method samples, so a time limit is its own. Throws InputError when the limit is no time.
std::vector<Override> overrides(const SamplingOptions& options, bool samples);

// Options for running the method: its checkpoint, with which it stops at an Interruption, and a line of progress on the
// terminal unless `quiet`. Throws InputError when the checkpoint cannot be written.
HostOptions host_options(const SamplingOptions& options, bool quiet);

}  // namespace airlight::cli
