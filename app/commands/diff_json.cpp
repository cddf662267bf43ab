#include "app/commands/diff_json.h"

#include "app/cli/json_writer.h"
#include "core/measure/words.h"

namespace airlight::cli {
namespace {

using namespace measure;

void write(JsonWriter& json, const char* key, const std::optional<double>& value) {
  if (value) json.key(key).value(*value);
}

void write(JsonWriter& json, const char* key, const ErrorSummary& summary) {
  json.key(key).begin_object();
  json.key("mean").value(summary.mean).key("p50").value(summary.p50).key("p95").value(summary.p95);
  json.key("p99").value(summary.p99).key("max").value(summary.max);
  json.key("values").value(summary.count).key("infinite").value(summary.infinite);
  json.end_object();
}

void write(JsonWriter& json, const char* key, const PixelReport& pixel) {
  json.key(key).begin_object();
  json.key("x").value(pixel.x).key("y").value(pixel.y).key("channel").value(pixel.channel);
  json.key("a").value(pixel.a).key("b").value(pixel.b);
  write(json, "elevation_deg", pixel.elevation_deg);
  write(json, "azimuth_deg", pixel.azimuth_deg);
  json.end_object();
}

void write(JsonWriter& json, const ChannelReport& channel) {
  json.begin_object().key("name").value(channel.name);
  write(json, "absolute", channel.absolute);
  write(json, "relative", channel.relative);
  if (channel.sigma) write(json, "standard_errors", *channel.sigma);
  if (channel.chi_square) {
    json.key("chi_square_per_value").value(channel.chi_square->per_value());
    json.key("differ_where_standard_error_is_0").value(channel.chi_square->unequal_exact);
  }
  json.key("rms").value(channel.deviation.rms()).key("psnr_db").value(channel.deviation.psnr());
  json.key("relative_bias").value(channel.deviation.bias());
  json.key("over_fail").value(channel.over_fail).key("over_warn").value(channel.over_warn);
  if (channel.absolute.count > 0) {
    write(json, "worst_absolute", channel.worst_absolute);
    write(json, "worst_relative", channel.worst_relative);
  }
  json.end_object();
}

void write_presets(JsonWriter& json, const ComparisonReport& report) {
  if (!report.presets_known) return;
  json.key("preset_differences").begin_array();
  for (const KeyDifference& difference : report.preset_keys) {
    json.begin_object().key("pointer").value(difference.pointer);
    json.key("a").value(difference.a).key("b").value(difference.b).end_object();
  }
  json.end_array();
}

void write_checks(JsonWriter& json, const ComparisonReport& report) {
  json.key("checks").begin_array();
  for (const LimitCheck& check : report.checks) {
    json.begin_object().key("limit").value(check.limit).key("allowed").value(check.allowed);
    json.key("measured").value(check.measured).key("holds").value(check.holds);
    json.key("only_warns").value(check.only_warns).end_object();
  }
  json.end_array();
}

void write_nonfinite(JsonWriter& json, const ComparisonReport& report) {
  json.key("nonfinite").begin_array();
  for (const NonfiniteCount& count : report.nonfinite) {
    json.begin_object().key("channel").value(count.channel);
    json.key("nan_a").value(count.nan_a).key("infinite_a").value(count.infinite_a);
    json.key("nan_b").value(count.nan_b).key("infinite_b").value(count.infinite_b).end_object();
  }
  json.end_array();
  const auto write_first = [&](const char* key, const std::optional<NonfinitePlace>& place) {
    json.key(key);
    if (!place) {
      json.null();
      return;
    }
    json.begin_object().key("x").value(place->x).key("y").value(place->y);
    json.key("channel").value(place->channel).end_object();
  };
  write_first("first_nonfinite_a", report.first_nonfinite_a);
  write_first("first_nonfinite_b", report.first_nonfinite_b);
}

void write_figures(JsonWriter& json, const ComparisonReport& report) {
  json.key("width").value(report.width).key("height").value(report.height);
  json.key("channels").values(report.channels);
  json.key("pixels").value(report.pixels).key("pixels_over_fail").value(report.pixels_over_fail);
  json.key("pixels_over_warn").value(report.pixels_over_warn);
  json.key("pixels_with_unequal_nonfinite").value(report.unequal_nonfinite);
  json.key("largest").value(report.largest);
  write_checks(json, report);
  write_nonfinite(json, report);
  json.key("areas").begin_array();
  for (const AreaReport& area : report.areas) {
    json.begin_object().key("name").value(area.name).key("pixels").value(area.pixels).key("channels").begin_array();
    for (const ChannelReport& channel : area.channels) write(json, channel);
    json.end_array().end_object();
  }
  json.end_array();
}

void write(JsonWriter& json, const NamedReport& entry) {
  const ComparisonReport& report = entry.report;
  json.begin_object().key("name").value(entry.name).key("a").value(entry.a).key("b").value(entry.b);
  json.key("verdict").value(verdict_words(report.verdict));
  if (!report.problem.empty()) json.key("problem").value(report.problem);
  write_presets(json, report);
  json.key("reasons").values(report.reasons);
  json.key("pictures").values(entry.pictures);
  json.key("notes").values(report.notes);
  if (!report.areas.empty()) write_figures(json, report);
  json.end_object();
}

void write(JsonWriter& json, const Limits& limits) {
  json.key("limits").begin_object();
  write(json, "fail", limits.fail);
  json.key("failpercent").value(limits.fail_percent);
  write(json, "hardfail", limits.hard_fail);
  write(json, "warn", limits.warn);
  json.key("warnpercent").value(limits.warn_percent);
  write(json, "hardwarn", limits.hard_warn);
  write(json, "rel_mean", limits.relative_mean);
  write(json, "rel_p95", limits.relative_p95);
  write(json, "rel_max", limits.relative_max);
  write(json, "chi_square", limits.chi_square);
  json.key("relative_floor").value(kRelativeFloor).end_object();
}

}  // namespace

std::string diff_json(const std::vector<NamedReport>& entries, const Limits& in_force,
                      const std::vector<std::string>& files_written,
                      const std::vector<std::string>& references_replaced) {
  JsonWriter json;
  json.begin_object().key("verdict").value(verdict_words(overall(entries)));
  write(json, in_force);
  json.key("pairs").begin_array();
  for (const NamedReport& entry : entries) write(json, entry);
  json.end_array();
  json.key("files_written").values(files_written);
  json.key("references_replaced").values(references_replaced);
  json.end_object();
  return json.take();
}

}  // namespace airlight::cli
