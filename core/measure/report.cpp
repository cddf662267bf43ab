#include "core/measure/report.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <tuple>

#include "core/measure/words.h"
#include "core/scene/printable.h"

namespace airlight::measure {
namespace {

constexpr std::size_t kKeysShown = 40;
constexpr std::size_t kKeysShownBriefly = 5;

std::string padded(std::string text, std::size_t width) {
  if (text.size() < width) text.insert(0, width - text.size(), ' ');
  return text;
}

std::string row(const std::string& name, const std::vector<std::string>& cells) {
  std::string line = "  " + name + std::string(name.size() < 14 ? 14 - name.size() : 0, ' ');
  for (const std::string& cell : cells) line += padded(cell, 11);
  return line + "\n";
}

// Mean, median, percentiles and largest, then the `more` cells.
std::vector<std::string> cells(const ErrorSummary& e, std::string (*text)(double),
                               std::initializer_list<std::string> more) {
  std::vector<std::string> all{text(e.mean), text(e.p50), text(e.p95), text(e.p99), text(e.max)};
  all.insert(all.end(), more);
  return all;
}

std::vector<std::string> relative_cells(const ChannelReport& channel) {
  return cells(channel.relative, percent, {percent(channel.deviation.bias())});
}

std::vector<std::string> absolute_cells(const ChannelReport& channel) {
  return cells(channel.absolute, number, {number(channel.deviation.rms()), number(channel.deviation.psnr())});
}

std::vector<std::string> sigma_cells(const ChannelReport& channel) {
  return cells(*channel.sigma, number,
               {number(channel.chi_square->per_value()), std::to_string(channel.chi_square->unequal_exact)});
}

// A line for each key that differs, at most `most`.
std::string describe_keys(const ComparisonReport& report, std::size_t most) {
  std::string text;
  for (std::size_t i = 0; i < std::min(most, report.preset_keys.size()); ++i) {
    const KeyDifference& key = report.preset_keys[i];
    text += "  " + shortened(key.pointer) + ": A " + (key.a.empty() ? "absent" : shortened(key.a)) + ", B " +
            (key.b.empty() ? "absent" : shortened(key.b)) + "\n";
  }
  if (report.preset_keys.size() > most) {
    text += "  and " + std::to_string(report.preset_keys.size() - most) + " more keys\n";
  }
  return text;
}

std::string describe_presets(const ComparisonReport& report) {
  if (!report.presets_known) return "";
  if (report.preset_keys.empty()) return "The presets are equal.\n";
  return "The presets differ:\n" + describe_keys(report, kKeysShown);
}

std::string describe_nonfinite(const ComparisonReport& report) {
  std::string text;
  for (const NonfiniteCount& entry : report.nonfinite) {
    text += "Channel " + entry.channel + ": A holds " + std::to_string(entry.nan_a) + " NaN and " +
            std::to_string(entry.infinite_a) + " infinite, B " + std::to_string(entry.nan_b) + " NaN and " +
            std::to_string(entry.infinite_b) + " infinite\n";
  }
  const auto add = [&](const char* picture, const std::optional<NonfinitePlace>& place) {
    if (place) {
      text += std::string("The first of ") + picture + " is at column " + std::to_string(place->x) + ", row " +
              std::to_string(place->y) + ", channel " + place->channel + "\n";
    }
  };
  add("A", report.first_nonfinite_a);
  add("B", report.first_nonfinite_b);
  return text;
}

bool all_equal(const AreaReport& area) {
  return std::ranges::all_of(area.channels, [](const ChannelReport& channel) { return channel.absolute.max == 0.0; });
}

std::string describe_figures(const ComparisonReport& report) {
  const AreaReport& whole = report.areas.front();
  std::string text = row("relative", {"mean", "median", "95 %", "99 %", "max", "bias"});
  for (const ChannelReport& channel : whole.channels) text += row(channel.name, relative_cells(channel));
  text += row("absolute", {"mean", "median", "95 %", "99 %", "max", "RMS", "PSNR dB"});
  for (const ChannelReport& channel : whole.channels) text += row(channel.name, absolute_cells(channel));
  if (whole.channels.back().sigma) {
    text += row("in sigmas", {"mean", "median", "95 %", "99 %", "max", "chi2/value", "exact off"});
    for (const ChannelReport& channel : whole.channels) {
      if (channel.sigma) text += row(channel.name, sigma_cells(channel));
    }
  }
  if (report.areas.size() == 1) return text;
  const bool has_sigma = whole.channels.back().sigma.has_value();
  std::vector<std::string> heads = {"mean", "median", "95 %", "99 %", "max", "bias", "pixels"};
  if (has_sigma) heads.push_back("chi2/value");
  text += row("by region", heads);
  for (std::size_t i = 1; i < report.areas.size(); ++i) {
    const ChannelReport& pooled = report.areas[i].channels.back();
    std::vector<std::string> cells = relative_cells(pooled);
    cells.push_back(std::to_string(report.areas[i].pixels));
    if (pooled.chi_square) cells.push_back(number(pooled.chi_square->per_value()));
    text += row(report.areas[i].name, cells);
  }
  return text;
}

std::string describe_pixel(const char* what, double error, const PixelReport& pixel) {
  std::string text = std::string("Largest ") + what + " error " + number(error) + " in " + pixel.channel +
                     " at pixel (" + std::to_string(pixel.x) + ", " + std::to_string(pixel.y) + ")";
  if (pixel.elevation_deg && pixel.azimuth_deg) {
    text += ", elevation " + number(*pixel.elevation_deg) + ", azimuth " + number(*pixel.azimuth_deg) + " degrees";
  }
  std::array<char, 80> values{};
  std::snprintf(values.data(), values.size(), ": A %.7g, B %.7g\n", pixel.a, pixel.b);
  return text + values.data();
}

std::string describe_counts(const ComparisonReport& report, const Limits& in_force) {
  const auto line = [&](const char* option, const std::optional<double>& limit, std::size_t count) {
    return limit ? "Pixels above " + std::string(option) + " " + number(*limit) + ": " + std::to_string(count) +
                       " of " + std::to_string(report.pixels) + "\n"
                 : std::string();
  };
  return line("--fail", in_force.fail, report.pixels_over_fail) +
         line("--warn", in_force.warn, report.pixels_over_warn);
}

std::string capitals(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::toupper(letter)); });
  return text;
}

std::string verdict_lines(const ComparisonReport& report) {
  std::string text = capitals(verdict_words(report.verdict)) + "\n";
  if (!report.problem.empty()) text += "  " + report.problem + "\n";
  for (const std::string& reason : report.reasons) text += "  " + reason + "\n";
  return text;
}

}  // namespace

std::string describe(const NamedReport& entry, const Limits& in_force) {
  const ComparisonReport& report = entry.report;
  std::string text = "A " + entry.a + "\nB " + entry.b + " (the reference)\n" + describe_presets(report);
  for (const std::string& note : report.notes) text += note + "\n";
  if (report.areas.empty()) return text + verdict_lines(report);
  text += std::to_string(report.width) + "x" + std::to_string(report.height) + "; relative error is |a-b| / max(|b|, " +
          number(kRelativeFloor) + " mean|b|); pooled: colour channels together\n";
  text += describe_nonfinite(report);
  if (all_equal(report.areas.front())) return text + "Every value is equal.\n" + verdict_lines(report);
  text += describe_figures(report);
  const ChannelReport& pooled = report.areas.front().channels.back();
  text += describe_pixel("relative", pooled.relative.max, pooled.worst_relative);
  text += describe_pixel("absolute", pooled.absolute.max, pooled.worst_absolute);
  return text + describe_counts(report, in_force) + verdict_lines(report);
}

std::string describe_causes(const NamedReport& entry) {
  std::string text = describe_keys(entry.report, kKeysShownBriefly);
  if (!entry.report.areas.empty()) {
    const ChannelReport& pooled = entry.report.areas.front().channels.back();
    if (pooled.relative.max > 0.0) {
      text += "  " + describe_pixel("relative", pooled.relative.max, pooled.worst_relative);
    }
  }
  for (const std::string& picture : entry.pictures) text += "  Picture: " + picture + "\n";
  return text;
}

std::string describe_briefly(const NamedReport& entry) {
  const ComparisonReport& report = entry.report;
  std::string text = entry.name + ": " + verdict_words(report.verdict);
  if (!report.areas.empty()) {
    const ErrorSummary& relative = report.areas.front().channels.back().relative;
    text += ", relative error mean " + percent(relative.mean) + ", 95 % " + percent(relative.p95) + ", max " +
            percent(relative.max);
  }
  text += "\n";
  if (!report.problem.empty()) text += "  " + report.problem + "\n";
  for (const std::string& reason : report.reasons) text += "  " + reason + "\n";
  return report.verdict == Verdict::pass ? text : text + describe_causes(entry);
}

std::string describe_all(const std::vector<NamedReport>& entries) {
  std::string text = std::to_string(entries.size()) + (entries.size() == 1 ? " pair" : " pairs");
  const char* between = ": ";
  for (const Verdict verdict : {Verdict::pass, Verdict::warn, Verdict::differ, Verdict::cannot_compare}) {
    const auto count =
        std::ranges::count_if(entries, [&](const NamedReport& entry) { return entry.report.verdict == verdict; });
    if (count == 0) continue;
    text += between + std::to_string(count) + " " + verdict_words(verdict);
    between = ", ";
  }
  const std::vector<const NamedReport*> sorted = worst_first(entries);
  const auto compared =
      std::ranges::find_if(sorted, [](const NamedReport* entry) { return !entry->report.areas.empty(); });
  if (compared != sorted.end()) {
    const NamedReport* worst = *compared;
    const ChannelReport& pooled = worst->report.areas.front().channels.back();
    text += "; largest relative error " + percent(pooled.relative.max) + " in " + worst->name + " at pixel (" +
            std::to_string(pooled.worst_relative.x) + ", " + std::to_string(pooled.worst_relative.y) + ")";
  }
  return text + "\n";
}

std::vector<const NamedReport*> worst_first(const std::vector<NamedReport>& entries) {
  std::vector<const NamedReport*> sorted;
  for (const NamedReport& entry : entries) sorted.push_back(&entry);
  // A pair without a known error comes before one with an infinite error.
  const auto error = [](const NamedReport* entry) {
    if (entry->report.areas.empty()) return std::tuple(1, 0.0, 0.0);
    const ErrorSummary& relative = entry->report.areas.front().channels.back().relative;
    return std::tuple(0, relative.max, relative.mean);
  };
  std::ranges::stable_sort(sorted, [&](const NamedReport* x, const NamedReport* y) { return error(x) > error(y); });
  return sorted;
}

Verdict overall(const std::vector<NamedReport>& entries) {
  Verdict worst = Verdict::pass;
  for (const NamedReport& entry : entries) worst = std::max(worst, entry.report.verdict);
  return worst;
}

}  // namespace airlight::measure
