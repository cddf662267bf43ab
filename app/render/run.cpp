#include "app/render/run.h"

#include <functional>
#include <memory>
#include <utility>

#include "app/cli/choice_options.h"
#include "app/cli/frame_scene.h"
#include "app/cli/interruption.h"
#include "app/cli/preset_source.h"
#include "app/cli/progress.h"
#include "app/cli/stopwatch.h"
#include "app/cli/terminal.h"
#include "app/render/cube_faces.h"
#include "app/render/lighting_files.h"
#include "app/render/picture_files.h"
#include "app/render/publish.h"
#include "app/render/report.h"
#include "app/render/spectral_order.h"
#include "app/render/table_files.h"
#include "app/render/targets.h"
#include "app/render/tiled_picture.h"
#include "app/render/validity.h"
#include "core/error.h"
#include "core/output/atomic_file.h"
#include "core/output/half_block.h"
#include "core/render/metering.h"
#include "core/render/spectrum.h"
#include "core/scene/preset.h"
#include "core/scene/resolve.h"

namespace airlight::cli {
namespace {

bool samples(const Scene& scene) {
  return find_method(scene.render.method)->render_on_host != nullptr;
}

Scene scene_of(const RenderOrder& given) {
  std::vector<Override> further = sun_overrides(given.place, given.scene, "render");
  for (Override& change : overrides(given.picture)) {
    further.push_back(std::move(change));
  }
  const auto with = [&](bool of_sampling) {
    std::vector<Override> all = overrides(given.sampling, of_sampling);
    all.insert(all.end(), further.begin(), further.end());
    return load_scene(given.scene, all);
  };
  Scene scene = with(false);
  return samples(scene) && given.sampling.time_limit ? with(true) : scene;
}

// The frame that `lock:FRAME` names, of the preset's own sequence.
sequence::Frame locked_frame(const Scene& scene) {
  const std::string place = "render: the exposure " + metering_text(scene.display);
  if (!scene.sequence) {
    throw InputError(place + ": the preset has no key frames to find it in; give auto, day, or stops such as 3.5");
  }
  return frame_numbered(*scene.sequence, scene.display.metered_frame, place);
}

// Nothing where method and quality are the preset's.
std::optional<ChoiceWish> choice_wish(const RenderOrder& given, const Scene& scene) {
  const bool by_time = given.sampling.time_limit && !samples(scene);
  if (!given.tolerance && !by_time) {
    return std::nullopt;
  }
  const std::string option = given.tolerance ? "--tolerance" : "--time-limit";
  if (given.tolerance && given.sampling.time_limit) {
    throw InputError("render: --tolerance and --time-limit exclude each other; give one");
  }
  for (const std::string& assignment : given.scene.set) {
    if (assignment.starts_with("/render/")) {
      throw InputError("render: " + option + " chooses what stands under /render; leave out --set " + assignment);
    }
  }
  ChoiceWish wish;
  wish.method = given.scene.method.value_or("");
  if (given.tolerance && find_method(wish.method) != nullptr && samples(scene)) {
    throw InputError("render: --tolerance: " + wish.method + " samples until --target-error; give that instead");
  }
  if (given.tolerance) {
    wish.tolerance = *given.tolerance;
  } else {
    wish.limit_ms = milliseconds_from(*given.sampling.time_limit, "render: --time-limit");
    if (!(wish.limit_ms > 0.0)) {
      throw InputError("render: --time-limit: nothing is rendered in no time; write for example 50ms");
    }
  }
  return wish;
}

// The scene with the exposure of a day or of one of the preset's own key frames, where it asks for one.
Scene with_held_exposure(const RenderOrder& given, Scene scene, const DeviceOnDemand& device) {
  std::optional<Scene> frame;
  if (scene.display.metering == Metering::frame && !scene.display.exposure) {
    const Preset preset = chosen_preset(given.scene, overrides(given.picture));
    frame = frame_scene(preset, locked_frame(scene));
    frame->render = scene.render;
  }
  if (const std::optional<double> held = held_exposure(device, scene, frame ? &*frame : nullptr)) {
    scene.display.exposure = held;
  }
  return scene;
}

RenderRequest request_of(const Scene& scene, const Targets& targets) {
  RenderRequest request = request_for(scene, !targets.exr.empty(), !targets.png.empty());
  request.tables = !targets.tables.empty();
  return request;
}

int dry_run(const RenderOrder& given, const Scene& scene, const Targets& targets, const std::optional<Nodes>& spectral,
            const std::optional<ChoiceReport>& choice) {
  const Plan plan = spectral ? plan_for_spectrum(scene, *spectral) : plan_for(scene, request_of(scene, targets));
  if (given.json) {
    std::vector<std::string> files;
    for (const std::string& file : {targets.exr, targets.png}) {
      if (!file.empty()) {
        files.push_back(file);
      }
    }
    print(json_of_plan(scene, plan, files, choice, spectral ? spectral->nm : std::vector<double>()));
    return 0;
  }
  const std::string why = choice ? summary(*choice) + "\n" + explanation(*choice) : "";
  print(why + describe(scene) + (spectral ? spectral_text(*spectral) : "") + plan_text(plan));
  return 0;
}

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

// What a picture is made with, beside the scene.
struct Means {
  const RenderOrder& given;
  const Targets& targets;
  const std::optional<DisplayTransform>& transform;
  const std::optional<ChoiceReport>& choice;
  std::unique_ptr<Executor>& executor;
  Stopwatch& watch;
  std::optional<Nodes> spectral;  // wavelengths of --spectral
};

// What killed runs have left half written of these files.
void remove_half_written(const Targets& targets) {
  for (const std::string& file : {targets.exr, targets.png}) {
    if (!file.empty()) {
      remove_abandoned_files_of(file);
    }
  }
}

std::optional<DeviceInfo> device_of(const Means& means) {
  return means.executor ? std::optional(means.executor->device()) : std::nullopt;
}

Provenance provenance_of(const Means& means, const Scene& scene) {
  const std::optional<DeviceInfo> device = device_of(means);
  return {to_json(scene), scene.render.method, AIRLIGHT_VERSION, device ? device->name : "the processor"};
}

PictureContext context_of(const Means& means, const Scene& scene, const Rendering& rendering) {
  return {.scene = scene,
          .rendering = rendering,
          .provenance = provenance_of(means, scene),
          .choice = note_of(means.choice),
          .space = working_space_of(means.given.picture)};
}

// One picture, or the six of a cube.
Published publish_pictures(const Means& means, const PictureContext& context, bool half) {
  const RenderOrder& given = means.given;
  const Targets& targets = means.targets;
  const PublishOrder order{targets, given.scene.preset, half, given.picture.bits};
  if (!given.cube_faces) {
    return publish(context, order, means.transform, means.watch);
  }
  Published all;
  for (const CubeFace& face : cube_faces(context.scene, context.rendering)) {
    PublishOrder one = order;
    one.targets = {face_file(targets.exr, face.name), face_file(targets.png, face.name)};
    const Published done = publish(context_of(means, face.scene, face.rendering), one, means.transform, means.watch);
    all.files.insert(all.files.end(), done.files.begin(), done.files.end());
    if (done.exr) {
      add_counts(all.exr ? *all.exr : all.exr.emplace(), *done.exr);
    }
  }
  return all;
}

// What stands beside the picture: tables, and what lighting asks for.
void add_further_files(const Means& means, const PictureContext& context, const std::optional<Lighting>& lighting,
                       std::vector<std::string>& files) {
  const auto append = [&](const std::vector<std::string>& more, const char* lap) {
    files.insert(files.end(), more.begin(), more.end());
    means.watch.lap(lap);
  };
  if (!means.targets.tables.empty()) {
    append(write_tables(means.targets.tables, context.rendering.tables, context.provenance),
           "tables, encoding and writing");
  }
  if (lighting) {
    append(write_lighting(*means.given.irradiance, *lighting, context), "irradiance, writing");
  }
}

// Colours that no screen of linear Rec.709 has, where the file says them in that space.
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

// From a checked scene to files on disk. False: it was interrupted, and its samples are kept.
bool render_and_publish(const Means& means, const Scene& scene) {
  const RenderOrder& given = means.given;
  RenderRequest request = request_of(scene, means.targets);
  request.layers = given.picture.layers;
  request.host = host_options(given.sampling, given.quiet);
  const DeviceOnDemand device = device_on_demand(given.scene, means.executor);
  Rendering rendering =
      means.spectral ? render_spectrum(device, scene, request, *means.spectral) : render(device, scene, request);
  clear_progress();
  if (Interruption::signal() != 0) {
    return false;
  }
  means.watch.lap("render");
  tell_undone(given, rendering);
  if (means.choice) {
    const std::vector<std::string>& left_out = means.choice->choice.left_out;
    rendering.left_out.insert(rendering.left_out.begin(), left_out.begin(), left_out.end());
  }
  std::optional<Lighting> lighting;
  if (given.irradiance && rendering.fault().empty()) {
    lighting = lighting_of(device, scene, request.host);
    clear_progress();
    means.watch.lap("irradiance");
  }
  require_valid_vulkan();
  const PictureContext context = context_of(means, scene, rendering);
  const ExrDepth depth = means.targets.exr.empty() ? ExrDepth{} : exr_depth(given.picture, rendering);
  Published done = publish_pictures(means, context, depth.half);
  add_further_files(means, context, lighting, done.files);
  const Plan plan = plan_for(scene, request);
  RenderReport report{scene,    rendering, plan, device_of(means), done.files,
                      done.exr, {},        {},   means.choice,     means.watch};
  tell(means, report, depth);
  return true;
}

// All of the picture, or the faces that it is cut into.
std::vector<TiledPart> parts_of(const Means& means, const Scene& scene) {
  if (!means.given.cube_faces) {
    return {{scene, 0, means.targets.exr, means.targets.png}};
  }
  std::vector<TiledPart> parts;
  for (const FaceScene& face : face_scenes(scene)) {
    parts.push_back(
        {face.scene, face.first_row, face_file(means.targets.exr, face.name), face_file(means.targets.png, face.name)});
  }
  return parts;
}

bool render_in_tiles(const Means& means, const Scene& scene, const ImageSize& tile) {
  const RenderOrder& given = means.given;
  const DeviceOnDemand device = device_on_demand(given.scene, means.executor);
  if (!samples(scene)) {
    device();  // its name stands in the header, before the first tile
  }
  const bool is_asked = given.picture.full_float || given.picture.half_float || means.targets.exr.empty();
  const ExrDepth depth = exr_depth(given.picture, is_asked ? Rendering{} : metered_picture(device, scene));
  TiledOrder order{.tile = tile,
                   .request = request_of(scene, means.targets),
                   .parts = parts_of(means, scene),
                   .transform = means.transform,
                   .half = depth.half,
                   .bits = given.picture.bits,
                   .source = given.scene.preset,
                   .context = {}};
  order.request.layers = given.picture.layers;
  order.request.host = host_options(given.sampling, given.quiet);
  if (!samples(scene)) {
    order.report = std::exchange(order.request.host.report, {});
  }
  const std::vector<std::string> left_out = means.choice ? means.choice->choice.left_out : std::vector<std::string>();
  order.context = [&](const Scene& part, const Rendering& rendering) {
    PictureContext context = context_of(means, part, rendering);
    context.left_out = left_out;
    return context;
  };
  order.dropped = [] { return Interruption::signal() != 0; };
  std::optional<Lighting> lighting;
  if (given.irradiance) {
    lighting = lighting_of(device, scene, order.request.host);
    clear_progress();
    means.watch.lap("irradiance");
  }
  TiledPicture done = write_tiled(device, scene, order);
  clear_progress();
  if (Interruption::signal() != 0) {
    return false;
  }
  means.watch.lap("render");
  require_valid_vulkan();
  tell_undone(given, done.rendering);
  done.rendering.left_out.insert(done.rendering.left_out.begin(), left_out.begin(), left_out.end());
  const PictureContext context = context_of(means, scene, done.rendering);
  add_further_files(means, context, lighting, done.files);
  const Plan plan = plan_for(scene, {});
  RenderReport report{scene, done.rendering, plan, device_of(means), done.files, {}, {}, {}, means.choice, means.watch};
  if (!means.targets.exr.empty()) {
    report.exr = done.counts;
  }
  report.tile = tile;
  tell(means, report, depth);
  return true;
}

// The tile of a picture that is rendered in tiles. Throws InputError for layers and tiles that cannot be had.
std::optional<ImageSize> tile_of(const RenderOrder& given, const Scene& scene, const Targets& targets) {
  require_layers(given.picture, scene, !targets.exr.empty(), "render");
  return tile_for(given.tile, scene, given.picture.layers, "render");
}

void warn(const Scene& scene, const Targets& targets, const std::optional<DisplayTransform>& transform,
          bool error_is_measured) {
  std::vector<std::string> warnings = scene_warnings(scene, error_is_measured);
  warnings.push_back(targets.exr.empty() ? std::string() : latlong_warning(scene));
  warnings.push_back(transform ? transform->warning() : std::string());
  for (const std::string& warning : warnings) {
    if (!warning.empty()) {
      complain("warning: " + warning);
    }
  }
}

// Ctrl-C leaves the checkpoint with all samples taken so far, and no picture. The exit code, as a shell says it.
int interruptible(const RenderOrder& given, const std::function<bool()>& publish_all) {
  const Interruption interruption;
  bool whole = false;
  try {
    whole = publish_all();
  } catch (const RunError&) {
    clear_progress();
    if (Interruption::signal() == 0) {
      throw;  // no sampling that was stopped
    }
  }
  if (whole) {
    return 0;
  }
  const int signal = Interruption::signal();
  complain("stopped by " + Interruption::name(signal) + ": no picture was written; " + given.sampling.checkpoint +
           " keeps the samples so far, and the same command goes on from there");
  return 128 + signal;
}

}  // namespace

int run_render(const RenderOrder& given) {
  Stopwatch watch;
  require_one_depth(given.picture, "render");
  Scene scene = scene_of(given);
  const std::optional<ChoiceWish> wish = choice_wish(given, scene);
  if (given.cube_faces) {
    require_cube_stack(scene);
  }
  if (scene.display.metering == Metering::frame && !scene.display.exposure) {
    locked_frame(scene);  // which must be there
  }
  const Targets targets = choose_targets(given);
  const std::optional<Nodes> spectral = spectral_wavelengths(given, scene, targets);
  std::optional<ImageSize> tile = wish ? std::nullopt : tile_of(given, scene, targets);
  if (!given.dry_run) {
    check_targets(given, targets);
  }
  watch.lap("preset and checks");
  std::unique_ptr<Executor> executor;
  std::optional<ChoiceReport> choice;
  if (wish) {
    choice = choose_rendering(scene, *wish, device_on_demand(given.scene, executor), given.quiet);
    scene = choice->choice.chosen->scene;
    tile = tile_of(given, scene, targets);
    watch.lap("choice of method and quality");
  }
  if (given.dry_run) {
    return dry_run(given, scene, targets, spectral, choice);
  }
  std::optional<DisplayTransform> transform;
  if (!targets.png.empty()) {
    transform = display_transform(given.picture, scene);
    watch.lap("OCIO config");
  }
  if (!given.quiet) {
    warn(scene, targets, transform, choice.has_value());
  }
  remove_half_written(targets);
  scene = with_held_exposure(given, std::move(scene), device_on_demand(given.scene, executor));
  const Means means{given, targets, transform, choice, executor, watch, spectral};
  const auto publish_all = [&] {
    return tile ? render_in_tiles(means, scene, *tile) : render_and_publish(means, scene);
  };
  return given.sampling.checkpoint.empty() ? (publish_all(), 0) : interruptible(given, publish_all);
}

}  // namespace airlight::cli
