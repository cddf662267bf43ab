#pragma once
// --tolerance and --time-limit: the method and quality chosen for the picture at hand.

#include <optional>
#include <string>

#include "app/cli/json_writer.h"
#include "core/choice/choose.h"
#include "core/render/render.h"

namespace airlight::cli {

struct ChoiceWish {
  double tolerance = 0.0;  // mean relative error; 0: none given
  double limit_ms = 0.0;   // 0: none given
  double judge_s = 0.0;    // CPU-seconds that the search may take; 0: by the plain picture's own
  bool keeps_traces = true;
  std::string method;  // the only one allowed; empty: any
};

struct ChoiceReport {
  ChoiceWish wish;
  choice::Choice choice;
  double probing_ms = 0.0;      // by the clock, with the time for compiling shaders and making near-truth tables
  double probing_cpu_ms = 0.0;  // of all threads
  double patience_s = 0.0;      // CPU-seconds that path-trace had, or a search without it; 0: nobody asked
};

// "50ms", "2s", "1min", "1h" in ms. Throws InputError: "PLACE: ...".
double milliseconds_from(const std::string& text, const std::string& place);

// Throws InputError where the preset asks for something that no tolerance measures (render.sun_fade, another scale of
// multiple scattering), or where nothing reaches the tolerance or fits the time; the message names the best possible.
ChoiceReport choose_rendering(const Stage& stage, const ChoiceWish& wish, const DeviceOnDemand& device, bool quiet);

// One line: the choice and its error.
std::string summary(const ChoiceReport& report);

// The candidates tried and the parts left out, for --dry-run and -v; ends with a line feed.
std::string explanation(const ChoiceReport& report);

// The value of "choice" in --json.
void write_choice(JsonWriter& json, const ChoiceReport& report);

}  // namespace airlight::cli
