#include "app/render/make_picture.h"

#include <utility>

#include "app/cli/interruption.h"
#include "app/cli/progress.h"
#include "app/cli/terminal.h"
#include "app/render/cube_faces.h"
#include "app/render/lighting_files.h"
#include "app/render/picture_files.h"
#include "app/render/publish.h"
#include "app/render/radiance_files.h"
#include "app/render/report.h"
#include "app/render/table_files.h"
#include "app/render/usd_file.h"
#include "core/scene/preset.h"

namespace airlight::cli {
namespace {

void tell_people(const RenderOrder& given, const RenderReport& report) {
  if (!given.quiet) {
    for (const std::string& warning : report.exr ? exr_warnings(*report.exr) : std::vector<std::string>()) {
      complain("warning: " + warning);
    }
    tell(report.choice ? summary(*report.choice) + "\n" : "");
    for (const std::string& file : report.files) {
      tell(file + "\n");
    }
  }
  if (given.verbose) {
    tell((report.choice ? explanation(*report.choice) : "") + details(report));
  }
  if (given.timings) {
    tell(timings_table(report));
  }
}

std::optional<ChoiceNote> note_of(const std::optional<ChoiceReport>& choice) {
  return choice ? std::optional(ChoiceNote{choice->choice.chosen->quality, choice->choice.error}) : std::nullopt;
}

std::vector<std::string> left_out_by(const std::optional<ChoiceReport>& choice) {
  return choice ? choice->choice.left_out : std::vector<std::string>();
}

std::optional<DeviceInfo> device_of(const Means& means) {
  return means.executor ? std::optional(means.executor->device()) : std::nullopt;
}

Provenance provenance_of(const Means& means, const Scene& scene) {
  const std::optional<DeviceInfo> device = device_of(means);
  return {to_json(scene), scene.render.method, AIRLIGHT_VERSION, device ? device->name : "the processor"};
}

bool wants_lighting(const RenderOrder& given) {
  return given.irradiance || given.usd || given.radiance || !given.prefilter.empty();
}

PictureContext context_of(const Means& means, const Scene& scene, const Rendering& rendering) {
  return {.scene = scene,
          .rendering = rendering,
          .provenance = provenance_of(means, scene),
          .choice = note_of(means.choice),
          .left_out = left_out_by(means.choice),
          .space = working_space_of(means.given.picture),
          .lit = wants_lighting(means.given)};
}

std::optional<Lighting> wanted_lighting(const Means& means, const DeviceOnDemand& device, const Stage& stage,
                                        const HostOptions& host) {
  if (!wants_lighting(means.given)) {
    return std::nullopt;
  }
  Lighting lighting = lighting_of(device, stage, host);
  clear_progress();
  means.watch.lap("irradiance");
  return lighting;
}

// Adds further files: tables, and those for lighting. `sky`: of --radiance.
void add_further_files(const Means& means, const PictureContext& context, const std::optional<Lighting>& lighting,
                       const std::optional<RadianceSky>& sky, std::vector<std::string>& files) {
  const auto append = [&](const std::vector<std::string>& more, const char* lap) {
    files.insert(files.end(), more.begin(), more.end());
    means.watch.lap(lap);
  };
  if (!means.targets.tables.empty()) {
    append(write_tables(means.targets.tables, context.rendering.tables, context.provenance),
           "tables, encoding and writing");
  }
  if (means.given.usd) {
    append({write_usd(means.given, *lighting, context)}, "USD, writing");
  }
  if (sky) {
    append(write_radiance(*means.given.radiance, *sky, *lighting, context), "Radiance, writing");
  }
  if (!means.given.prefilter.empty()) {
    append({write_cube_light(means.targets.other, *lighting, context)}, "harmonics, writing");
  }
  if (means.given.irradiance) {
    append(write_lighting(*means.given.irradiance, *lighting, context), "irradiance, writing");
  }
}

// Warns of colours outside linear Rec.709 where the file's colours are in that space.
void warn_of_gamut(const RenderOrder& given, const Rendering& rendering) {
  if (!given.quiet && rendering.picture.outside > 0 && working_space_of(given.picture) == WorkingSpace::linear_rec709) {
    complain(
        "warning: " + std::to_string(rendering.picture.outside) +
        " pixels have a colour outside linear Rec.709, with a negative channel; --colorspace ACES2065-1 holds them");
  }
}

void tell(const Means& means, RenderReport& report, const ExrDepth& depth) {
  const RenderOrder& given = means.given;
  warn_of_gamut(given, report.rendering);
  report.exr_format = depth.half ? "half" : "float";
  if (!depth.why.empty() && !given.quiet) {
    complain("note: the EXR has 32-bit floats: " + depth.why + "; --half forces 16 bits");
  }
  if (!means.targets.png.empty()) {
    report.view =
        means.transform ? means.transform->display() + " / " + means.transform->view() : report.scene.display.view;
  }
  tell_people(given, report);
  if (given.json) {
    print(json_report(report));
  }
}

void tell_undone(const RenderOrder& given, const Rendering& rendering) {
  for (const std::string& undone : rendering.undone) {
    if (!given.quiet) {
      complain("warning: " + undone);
    }
  }
}

}  // namespace

RenderRequest request_of(const Means& means, const Scene& scene) {
  const Targets& targets = means.targets;
  RenderRequest request = request_for(scene, !targets.exr.empty(), !targets.png.empty());
  request.tables = !targets.tables.empty();
  request.layers = layer_set(means.given.picture);
  request.spectrum = means.spectral;
  request.host = host_options(means.given.sampling, means.given.quiet);
  return request;
}

bool make_picture(const Means& means, const Stage& stage, const std::optional<ImageSize>& tile) {
  const Scene& scene = stage.scene();
  const RenderOrder& given = means.given;
  const RenderRequest request = request_of(means, scene);
  const DeviceOnDemand device = device_on_demand(given.scene, means.executor);
  const std::vector<std::string> left_out = left_out_by(means.choice);
  const auto context = [&](const Scene& part, const Rendering& rows) { return context_of(means, part, rows); };
  const PicturePart whole{scene, 0, means.targets};
  PictureWriter writer({.parts = given.cube_faces ? face_parts(scene, means.targets) : std::vector{whole},
                        .transform = means.transform,
                        .options = given.picture,
                        .depth = tile ? depth_in_tiles(given.picture, means.targets, device, stage) : std::nullopt,
                        .source = given.scene.preset,
                        .prefilter = !given.prefilter.empty(),
                        .context = context});
  Rendering rendering = render_bands(device, stage, writer.bands(tile, request));
  clear_progress();
  means.watch.lap("render");
  const bool goes_on = rendering.fault().empty() && Interruption::signal() == 0;
  const std::optional<Lighting> lighting = goes_on ? wanted_lighting(means, device, stage, request.host) : std::nullopt;
  std::optional<RadianceSky> sky;
  if (lighting && given.radiance) {
    sky = RadianceSky{whole_sky(device, stage, request.host, kRadianceSky, means.spectral), {}};
    if (means.spectral) {
      sky->sun_spectrum = sun_spectrum(device, stage, *means.spectral);
    }
    means.watch.lap("sky for Radiance");
  }
  if (Interruption::signal() != 0) {
    return false;
  }
  tell_undone(given, rendering);
  rendering.left_out.insert(rendering.left_out.begin(), left_out.begin(), left_out.end());
  require_valid_vulkan();
  Published done = writer.publish(rendering, means.watch, lighting);
  if (request.layers != LayerSet::none) {
    rendering.layers = layers_of(stage, request.layers);
  }
  for (const std::string& warning : given.quiet ? std::vector<std::string>() : done.warnings) {
    complain("warning: " + warning);
  }
  add_further_files(means, context_of(means, scene, rendering), lighting, sky, done.files);
  const Plan plan = plan_for(stage, request);
  RenderReport report{scene, rendering, plan,         device_of(means), done.files, done.exr,
                      {},    {},        means.choice, means.watch,      tile};
  tell(means, report, done.depth);
  return true;
}

}  // namespace airlight::cli
