#include "app/render/report.h"

#include <algorithm>
#include <cstdio>
#include <variant>

#include "app/cli/json_writer.h"
#include "core/base/text.h"
#include "core/output/spectral_layout.h"
#include "core/scene/json_format.h"
#include "core/scene/preset.h"

namespace airlight::cli {
namespace {

// A GPU's passes take a fraction of a millisecond.
std::string milliseconds(double value) {
  constexpr double kShort = 10.0;
  char text[32];
  std::snprintf(text, sizeof text, "%9.*f", value < kShort ? 3 : 1, value);
  return text;
}

std::string row(const std::string& name, const std::string& wall, const std::string& cpu) {
  constexpr std::size_t kNameWidth = 36;
  return name + std::string(kNameWidth - std::min(kNameWidth, name.size()), ' ') + wall + cpu + "\n";
}

std::string size_of(const Extent& extent) {
  std::string text = std::to_string(extent.width) + "x" + std::to_string(extent.height);
  return extent.depth > 1 ? text + "x" + std::to_string(extent.depth) : text;
}

void write_milestones(JsonWriter& json, const char* key, const std::vector<Milestone>& milestones) {
  json.key(key).begin_array();
  for (const Milestone& milestone : milestones) {
    json.begin_object().key("name").value(milestone.name).key("milliseconds").value(milestone.milliseconds);
    json.end_object();
  }
  json.end_array();
}

void write_tables(JsonWriter& json, const RenderReport& report) {
  json.key("tables").begin_array();
  for (const NamedStatistics& table : report.rendering.tables_statistics) {
    const auto image = std::find_if(report.plan.images().begin(), report.plan.images().end(),
                                    [&](const ImageDesc& candidate) { return candidate.name == table.name; });
    json.begin_object().key("name").value(table.name);
    if (image != report.plan.images().end()) {
      json.key("width").value(image->extent.width);
      json.key("height").value(image->extent.height);
      json.key("depth").value(image->extent.depth);
    }
    json.key("non_finite").value(table.statistics.not_finite);
    json.key("negative").value(table.statistics.negative).end_object();
  }
  json.end_array();
}

void write_timings(JsonWriter& json, const RenderReport& report) {
  json.key("passes").begin_array();
  for (const PassTiming& pass : report.rendering.passes) {
    json.begin_object().key("name").value(pass.name).key("milliseconds").value(pass.milliseconds).end_object();
  }
  json.end_array();
  write_milestones(json, "host", report.rendering.host);
  json.key("laps").begin_array();
  for (const Lap& lap : report.watch.laps()) {
    json.begin_object().key("name").value(lap.name).key("milliseconds").value(lap.wall_ms);
    json.key("cpu_milliseconds").value(lap.cpu_ms).end_object();
  }
  json.end_array();
  const Lap total = report.watch.total();
  json.key("total").begin_object().key("milliseconds").value(total.wall_ms);
  json.key("cpu_milliseconds").value(total.cpu_ms);
  json.key("peak_resident_mib").value(peak_resident_mib()).end_object();
}

std::string resource_name(const Plan& plan, const ResourceId& id) {
  if (const auto* image = std::get_if<ImageId>(&id)) {
    return plan.images()[image->index].name;
  }
  return plan.buffers()[std::get<BufferId>(id).index].name;
}

std::string names_of(const Plan& plan, const std::vector<Binding>& bindings) {
  return bindings.empty()
             ? "nothing"
             : joined_of(bindings, [&](const Binding& binding) { return resource_name(plan, binding.resource); });
}

// The parts of the time between two laps, each name once. A row for the rest makes the parts add up.
std::string parts_of_render(const RenderReport& report, double wall_ms) {
  std::string text;
  double rest = wall_ms;
  for (const Milestone& milestone : report.rendering.host) {
    text += row("  " + milestone.name, milliseconds(milestone.milliseconds), "");
    rest -= milestone.milliseconds;
    if (milestone.name != "execute") {
      continue;
    }
    double waiting = milestone.milliseconds;
    for (const PassTiming& pass : report.rendering.passes) {
      text += row("    pass " + pass.name, milliseconds(pass.milliseconds), "");
      waiting -= pass.milliseconds;
    }
    text += row("    submission and waiting", milliseconds(waiting), "");
  }
  return text + row("  host work of the method and rest", milliseconds(rest), "");
}

std::string range_text(const std::vector<double>& nm) {
  return std::to_string(nm.size()) + " wavelengths from " + format_number(nm.front()) + " to " +
         format_number(nm.back()) + " nm";
}

}  // namespace

std::string json_report(const RenderReport& report) {
  JsonWriter json;
  json.begin_object();
  json.key("name").value(report.scene.name).key("method").value(report.scene.render.method);
  json.key("width").value(report.scene.image.width).key("height").value(report.scene.image.height);
  json.key("files").values(report.files);
  if (report.device) {
    json.key("device").value(report.device->name).key("driver").value(report.device->driver);
  } else {
    json.key("device").null();
  }
  json.key("view").text_or_null(report.view);
  json.key("exposure").value(report.rendering.exposure);
  json.key("non_finite").value(report.rendering.picture.not_finite);
  json.key("negative").value(report.rendering.picture.negative);
  if (report.exr) {
    json.key("exr").begin_object().key("format").value(report.exr_format);
    json.key("clamped").value(report.exr->clamped).key("underflowed").value(report.exr->underflowed).end_object();
  }
  if (report.tile) {
    json.key("tile").begin_object().key("width").value(report.tile->width);
    json.key("height").value(report.tile->height).end_object();
  }
  if (!report.rendering.layers.empty()) {
    json.key("layers").begin_array();
    for (const Layer& layer : report.rendering.layers) {
      json.value(layer.name);
    }
    json.end_array();
  }
  if (const std::optional<SpectralImage>& spectrum = report.rendering.spectrum) {
    json.key("spectrum").begin_object().key("unit").value(spectrum->unit);
    json.key("picture").value(origin_of_colours(*spectrum));
    json.key("wavelengths_nm").values(spectrum->nm).key("sunlight").values(spectrum->sunlight).end_object();
  }
  if (report.choice) {
    json.key("choice");
    write_choice(json, *report.choice);
  }
  json.key("left_out").values(report.rendering.left_out);
  write_tables(json, report);
  write_timings(json, report);
  return json.end_object().take();
}

std::string timings_table(const RenderReport& report) {
  std::string text = row("", "  wall ms", "   CPU ms");
  for (const Lap& lap : report.watch.laps()) {
    text += row(lap.name, milliseconds(lap.wall_ms), milliseconds(lap.cpu_ms));
    text += lap.name == "render" ? parts_of_render(report, lap.wall_ms) : "";
  }
  const Lap total = report.watch.total();
  text += row(total.name, milliseconds(total.wall_ms), milliseconds(total.cpu_ms));
  return text + row("peak resident MiB", milliseconds(peak_resident_mib()), "");
}

std::string details(const RenderReport& report) {
  const Rendering& rendering = report.rendering;
  char text[160];
  std::string out = "method " + report.scene.render.method;
  out += report.device ? " on " + report.device->name + " (" + report.device->driver + ")\n" : "\n";
  // Parts left out by the choice are listed in its explanation.
  const std::vector<std::string> told = report.choice ? report.choice->choice.left_out : std::vector<std::string>();
  for (const std::string& reason : rendering.left_out) {
    const bool is_told = std::ranges::find(told, reason) != told.end();
    out += is_told ? "" : "left out: " + reason + "\n";
  }
  if (rendering.spectrum) {
    out += "spectrum: " + range_text(rendering.spectrum->nm) + ", " + rendering.spectrum->unit + "; the picture is " +
           origin_of_colours(*rendering.spectrum) + "\n";
  }
  std::snprintf(text, sizeof text, "exposure %.4g, metered luminance %.4g, largest %.4g\n", rendering.exposure,
                rendering.picture.metered_luminance, rendering.picture.max_luminance);
  return out + text + (report.view.empty() ? "" : "view " + report.view + "\n");
}

std::vector<std::string> exr_warnings(const ExrCounts& counts) {
  std::vector<std::string> warnings;
  if (counts.clamped > 0) {
    warnings.push_back(std::to_string(counts.clamped) +
                       " samples above 65504 were clamped in the half-float EXR; leave out --half to keep them");
  }
  // A few dark pixels are no loss; a picture of them is.
  if (counts.underflowed * 2 > counts.samples) {
    warnings.push_back(std::to_string(counts.underflowed) + " of " + std::to_string(counts.samples) +
                       " samples are too dark for half floats to hold all digits; leave out --half to keep them");
  }
  return warnings;
}

std::string json_of_plan(const Scene& scene, const Plan& plan, const std::vector<std::string>& files,
                         const std::optional<ChoiceReport>& choice, const std::vector<double>& wavelengths) {
  JsonWriter json;
  json.begin_object().key("name").value(scene.name).key("method").value(scene.render.method);
  json.key("width").value(scene.image.width).key("height").value(scene.image.height).key("files").values(files);
  if (choice) {
    json.key("choice");
    write_choice(json, *choice);
  }
  if (!wavelengths.empty()) {
    json.key("wavelengths_nm").values(wavelengths);
  }
  json.key("passes").begin_array();
  for (const PassDesc& pass : plan.passes()) {
    json.value(pass.name.empty() ? pass.shader : pass.name);
  }
  return json.end_array().key("preset").raw(to_json(scene)).end_object().take();
}

std::string spectral_text(const Nodes& wavelengths) {
  return "spectrum: " + range_text(wavelengths.nm) + "; the passes below for each three of them\n";
}

std::string plan_text(const Plan& plan) {
  std::string text = "passes, at most:\n";
  for (const PassDesc& pass : plan.passes()) {
    const std::string& name = pass.name.empty() ? pass.shader : pass.name;
    text += "  " + name + (name == pass.shader ? "" : " (shader " + pass.shader + ")") + ", " + size_of(pass.grid) +
            " threads: reads " + names_of(plan, pass.reads) + "; writes " + names_of(plan, pass.writes) + "\n";
  }
  return text;
}

}  // namespace airlight::cli
