#include "app/cli/choice_options.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string_view>
#include <vector>

#include "app/cli/progress.h"
#include "core/base/clock.h"
#include "core/base/error.h"
#include "core/base/text.h"
#include "core/chart/timing.h"
#include "core/gpu/kept_values.h"
#include "core/measure/sample_error.h"
#include "core/output/exr.h"
#include "core/output/half_block.h"
#include "core/scene/preset.h"

namespace airlight::cli {
namespace {

using choice::Choice;
using choice::Tried;

void refuse_departures(const Scene& scene) {
  const auto& parameters = scene.render.parameters;
  const auto fade = parameters.find("sun_fade");
  const bool fades = fade != parameters.end() && std::holds_alternative<SunFade>(fade->second);
  const auto scale = parameters.find("multiple_scattering_scale");
  const bool scaled = scale != parameters.end() && std::get<double>(scale->second) != 1.0;
  if (fades || scaled) {
    throw InputError(
        std::string("render: --tolerance and --time-limit measure against physics, from which the preset ") +
        "departs by /render/" + (fades ? "sun_fade" : "multiple_scattering_scale") +
        "; leave that key out, or choose method and quality yourself");
  }
}

// Time was up: what is known of the best so far, and how more may be known.
std::string what_ran_out(const ChoiceReport& report, const std::string& best) {
  const double error = report.choice.best->error;
  const bool told = error < measure::kWorstError;
  std::string text = "in " + rounded(report.patience_s, 2) + " CPU-s ";
  if (report.choice.traced == 0) {
    text += "nothing was found that is sure to be that accurate; " + best + " is at most " + percent(error, 3) +
            " off here; allow that, ";
  } else {
    text += told ? "path-trace told no more than that " + best + " is at most " + percent(error, 3) +
                       " off here; allow that, "
                 : "path-trace could not tell how accurate " + best + " is here; ";
  }
  if (told && report.wish.keeps_traces) {
    text += "give the same command again, which goes on from there, ";
  }
  return text + (told ? "or " : "") + "allow more time, as by --judge-time " +
         rounded(std::ceil(4.0 * report.patience_s), 4) + "s";
}

[[noreturn]] void refuse_unreached(const ChoiceReport& report) {
  const Choice& choice = report.choice;
  const std::string methods =
      report.wish.method.empty() ? "no method" : "method " + report.wish.method + " at no quality";
  if (!choice.best) {
    throw InputError("render: " + methods + " claims to hold for this scene; choose another with --method");
  }
  const std::string best = choice.best->method + ", " + choice.best->quality;
  if (report.wish.limit_ms > 0.0) {
    throw InputError("render: --time-limit " + rounded(report.wish.limit_ms, 4) + "ms: " + methods +
                     " is that fast here; the fastest is " + best + ", with " + rounded(choice.best->ms, 4) +
                     " ms; give it that, or a smaller picture with --size");
  }
  const std::string wished = "render: --tolerance " + percent(report.wish.tolerance, 3) + ": ";
  if (choice.ran_out) {
    throw InputError(wished + what_ran_out(report, best));
  }
  throw InputError(wished + methods + " is sure to be that accurate here; the best is " + best +
                   ", with an error of at most " + percent(choice.best->error, 3) +
                   "; allow that, or use --method path-trace with --target-error");
}

// Of the plain picture's CPU time, for paths and what is tried after them, and for a search as a whole. With what is
// rendered to measure that, and the plain picture in the end, a command takes about 20 times as long at most, unless
// more is allowed.
constexpr double kPatience = 16.0;
constexpr double kLeastPatience = 2.0;  // CPU-seconds: starting the program is most of a small picture's time

// CPU time of all threads that the whole picture and its EXR take by `orders` at its defaults once shaders and tables
// are there: the lesser of two goes', kept for later starts. Of pictures too large to be held, half of what the
// cheapest whole command of 3840x2160 took on an H200 (1170 ms).
double plain_cpu_ms(const DeviceOnDemand& device, const Stage& stage) {
  constexpr double kMostPixels = 1 << 23;
  constexpr double kOfMore = 600.0;
  const Stage plain = choice::default_candidate(stage).stage;
  const ImageSize size = plain.scene().image;
  if (1.0 * size.width * size.height > kMostPixels) {
    return kOfMore;
  }
  const auto measure = [&] {
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 2; ++i) {
      const double start = process_cpu_ms();
      const Rendering rendering = render(device, plain, {});
      std::vector<ExrChannel> channels;
      add_channels(channels, "", rendering.radiance);
      ExrOptions options;
      options.half = half_loss(rendering.radiance, rendering.picture.metered_luminance).empty();
      encode_exr(size.width, size.height, channels, options);
      least = std::min(least, process_cpu_ms() - start);
    }
    return std::vector<float>{static_cast<float>(least)};
  };
  const std::string key = "time of the plain picture\n" + device().device().name + "\n" + to_json(plain.scene());
  return kept_floats(key, measure).front();
}

chart::TimingRules quick() {
  chart::TimingRules rules;
  rules.most_runs = 5;
  rules.enough_s = 0.05;
  rules.long_s = 0.2;
  rules.warm_s = 0.0;
  return rules;
}

}  // namespace

double milliseconds_from(const std::string& text, const std::string& place) {
  struct Unit {
    std::string_view name;
    double ms;
  };
  constexpr std::array kUnits{Unit{"ms", 1.0}, Unit{"s", 1e3}, Unit{"min", 6e4}, Unit{"h", 3.6e6}};
  double value = 0.0;
  const char* end = text.data() + text.size();
  const auto parsed = std::from_chars(text.data(), end, value);
  const std::string_view rest(parsed.ptr, static_cast<std::size_t>(end - parsed.ptr));
  for (const Unit& unit : kUnits) {
    if (parsed.ec == std::errc() && rest == unit.name && value >= 0.0 && std::isfinite(value)) {
      return value * unit.ms;
    }
  }
  if (parsed.ec == std::errc() && rest.empty()) {
    throw InputError(place + ": '" + text + "' has no unit; write " + text + "s, " + text + "ms or " + text + "min");
  }
  throw InputError(place + ": '" + text + "' is no time; write for example 50ms, 2s or 1min");
}

ChoiceReport choose_rendering(const Stage& stage, const ChoiceWish& wish, const DeviceOnDemand& device, bool quiet) {
  refuse_departures(stage.scene());
  ChoiceReport report;
  report.wish = wish;
  const Clock::time_point start = Clock::now();
  const double cpu = process_cpu_ms();
  std::optional<TerminalStatus> status;
  if (!quiet) {
    status.emplace();
  }
  int tried = 0;
  const auto tell_what = [&](const char* doing, const Stage& candidate) {
    if (status) {
      status->say("choosing method and quality: " + std::string(doing) + " " + candidate.scene().render.method + " (" +
                  std::to_string(++tried) + " so far)");
    }
  };
  choice::Looks looks;
  looks.probe = [&](const Stage& candidate, const choice::Probes& probes) {
    tell_what("probing", candidate);
    return probe_picture(device, candidate, probes.directions);
  };
  looks.patience = [&] {
    if (report.patience_s == 0.0) {
      report.patience_s = wish.judge_s > 0.0
                              ? wish.judge_s
                              : std::max(1e-3 * kPatience * (cpu + plain_cpu_ms(device, stage)), kLeastPatience);
    }
    return report.patience_s;
  };
  looks.is_up = [&] {
    const auto spent_s = [&] { return 1e-3 * (process_cpu_ms() - cpu); };
    const bool may_be = spent_s() > (wish.judge_s > 0.0 ? wish.judge_s : kLeastPatience);
    return may_be && spent_s() > looks.patience();
  };
  looks.trace = [&](const Stage& whole, const choice::Probes& probes, const choice::TraceOrder& order) {
    if (status) {
      status->say("choosing method and quality: path-trace judges " + std::to_string(probes.directions.size()) +
                  " pixels");
    }
    return choice::trace_probes(whole, probes, order);
  };
  if (wish.limit_ms > 0.0) {
    chart::TableTimes tables;
    const choice::TimeFunction time = [&](const Stage& candidate) {
      tell_what("timing", candidate);
      const chart::Timing timing = chart::time_on_device(device(), candidate, {}, quick(), tables);
      return timing.device_ms + timing.tables_ms;
    };
    report.choice = choice::choose_for_time(stage, wish.limit_ms, wish.method, looks, time);
  } else {
    report.choice = choice::choose_for_tolerance(stage, wish.tolerance, wish.method, looks);
  }
  report.probing_ms = milliseconds_since(start);
  report.probing_cpu_ms = process_cpu_ms() - cpu;
  if (!report.choice.chosen) {
    refuse_unreached(report);
  }
  return report;
}

std::string summary(const ChoiceReport& report) {
  const Choice& choice = report.choice;
  std::string text = "chose " + choice.chosen->method + ", " + choice.chosen->quality + ": mean error at most " +
                     percent(choice.error, 3);
  text += report.wish.limit_ms > 0.0
              ? ", " + rounded(choice.ms, 4) + " ms on the device of " + rounded(report.wish.limit_ms, 4) + " allowed"
              : " of " + percent(report.wish.tolerance, 3) + " allowed";
  if (choice.probes == 0) {
    return text + ", as is known of such air and sun";
  }
  const std::string judge = choice.traced > 0 ? " and path-trace at " + std::to_string(choice.traced) : "";
  return text + ", by " + std::to_string(choice.probes) + " probes" + judge + " in " +
         rounded(report.probing_cpu_ms, 4) + " CPU-ms";
}

std::string explanation(const ChoiceReport& report) {
  const Choice& choice = report.choice;
  std::string text = "tried, by rising cost:\n";
  if (report.wish.limit_ms > 0.0) {
    text = "tried, by rising error:\n";
  }
  for (const Tried& tried : choice.tried) {
    char line[200];
    std::snprintf(line, sizeof line, "  %-10s %-48s error at most %8s%s\n", tried.method.c_str(), tried.quality.c_str(),
                  percent(tried.error, 3).c_str(), tried.ms > 0.0 ? (", " + rounded(tried.ms, 4) + " ms").c_str() : "");
    text += line;
  }
  text += "  of it the reference's own and that of what was left out: " + percent(choice.reference_error, 3) + "\n";
  for (const std::string& line : choice.left_out) {
    text += "left out: " + line + "\n";
  }
  return text;
}

void write_choice(JsonWriter& json, const ChoiceReport& report) {
  const Choice& choice = report.choice;
  json.begin_object();
  json.key("tolerance");
  report.wish.tolerance > 0.0 ? json.value(report.wish.tolerance) : json.null();
  json.key("time_limit_ms");
  report.wish.limit_ms > 0.0 ? json.value(report.wish.limit_ms) : json.null();
  json.key("method").value(choice.chosen->method).key("quality").value(choice.chosen->quality);
  json.key("estimated_error").value(choice.error).key("reference_error").value(choice.reference_error);
  json.key("device_ms");
  choice.ms > 0.0 ? json.value(choice.ms) : json.null();
  json.key("probes").value(choice.probes).key("traced").value(choice.traced).key("probing_ms").value(report.probing_ms);
  json.key("probing_cpu_ms")
      .value(report.probing_cpu_ms)
      .key("left_out")
      .values(choice.left_out)
      .key("tried")
      .begin_array();
  for (const Tried& tried : choice.tried) {
    json.begin_object().key("method").value(tried.method).key("quality").value(tried.quality);
    json.key("cost").value(tried.cost).key("error").value(tried.error).end_object();
  }
  json.end_array().end_object();
}

}  // namespace airlight::cli
