#include "app/render/run.h"

#include <algorithm>
#include <functional>
#include <memory>
#include <utility>

#include "app/cli/choice_options.h"
#include "app/cli/frame_scene.h"
#include "app/cli/interruption.h"
#include "app/cli/progress.h"
#include "app/cli/scene_files.h"
#include "app/cli/stopwatch.h"
#include "app/cli/terminal.h"
#include "app/render/cube_faces.h"
#include "app/render/make_picture.h"
#include "app/render/radiance_files.h"
#include "app/render/report.h"
#include "app/render/targets.h"
#include "app/render/tile_option.h"
#include "app/render/usd_file.h"
#include "core/base/error.h"
#include "core/library/place.h"
#include "core/library/validity.h"
#include "core/library/wavelengths.h"
#include "core/methods/ready.h"
#include "core/output/atomic_file.h"
#include "core/output/last_words.h"
#include "core/render/spectrum.h"
#include "core/scene/preset.h"
#include "core/scene/resolve.h"

namespace airlight::cli {
namespace {

Scene scene_of(const RenderOrder& given) {
  std::vector<Override> further = sun_overrides(given.place, given.scene, "render");
  for (Override& change : overrides(given.picture)) {
    further.push_back(std::move(change));
  }
  if (given.usd) {  // its lights are the discs
    further.push_back({"/sun/disc/visible=false", "--usd " + *given.usd});
  }
  const auto with = [&](bool of_sampling) {
    std::vector<Override> all = overrides(given.sampling, of_sampling);
    all.insert(all.end(), further.begin(), further.end());
    Preset preset = chosen_preset(given.scene, all);
    if (given.place.date) {
      leave_out_unseen(preset);
    }
    return judged(preset);
  };
  Scene scene = with(false);
  require_one_refraction(given.place, scene, "render");
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

// None where method and quality are the preset's.
std::optional<ChoiceWish> choice_wish(const RenderOrder& given, const Scene& scene) {
  const bool by_time = given.sampling.time_limit && !samples(scene);
  if (!given.tolerance && !by_time) {
    if (given.judge_time) {
      throw InputError("render: --judge-time is for --tolerance and --time-limit; give one of them, or leave it out");
    }
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
  wish.keeps_traces = !given.scene.no_cache;
  if (given.judge_time) {
    wish.judge_s = 1e-3 * milliseconds_from(*given.judge_time, "render: --judge-time");
    if (!(wish.judge_s > 0.0)) {
      throw InputError("render: --judge-time: nothing is judged in no time; write for example 60s");
    }
  }
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

// The stage with the exposure of a day or of one of the preset's own key frames, if it asks for one.
Stage with_held_exposure(const RenderOrder& given, const Stage& stage, const DeviceOnDemand& device) {
  Scene scene = stage.scene();
  const std::optional<double> held = held_exposure(device, stage, [&] {
    Scene frame = frame_scene(chosen_preset(given.scene, overrides(given.picture)), locked_frame(scene), scene);
    frame.render = scene.render;
    return frame;
  });
  if (!held) {
    return stage;
  }
  scene.display.exposure = held;
  return ready(scene, stage);
}

int dry_run(const Means& means, const Stage& stage) {
  const Scene& scene = stage.scene();
  const std::optional<Nodes>& spectral = means.spectral;
  const Plan plan = plan_for(stage, request_of(means, scene));
  if (means.given.json) {
    print(json_of_plan(scene, plan, means.targets.files(), means.choice,
                       spectral ? spectral->nm : std::vector<double>()));
    return 0;
  }
  const std::string why = means.choice ? summary(*means.choice) + "\n" + explanation(*means.choice) : "";
  print(why + describe(scene) + (spectral ? spectral_text(*spectral) : "") + plan_text(plan));
  return 0;
}

// The tile size of a picture rendered in tiles. Throws InputError for impossible layers or tiles.
std::optional<ImageSize> tile_of(const RenderOrder& given, const Stage& stage, const Targets& targets) {
  require_layers(given.picture, stage.scene(), !targets.exr.empty(), "render");
  return tile_for(given.tile, stage, layer_set(given.picture), "render");
}

void warn(const Stage& stage, const Targets& targets, const std::optional<DisplayTransform>& transform,
          bool error_is_measured) {
  std::vector<std::string> warnings = scene_warnings(stage, error_is_measured);
  warnings.push_back(targets.exr.empty() ? std::string() : latlong_warning(stage.scene()));
  warnings.push_back(transform ? transform->warning() : std::string());
  for (const std::string& warning : warnings) {
    if (!warning.empty()) {
      complain("warning: " + warning);
    }
  }
}

// On Ctrl-C the checkpoint keeps all samples taken so far, and no picture is written. Returns the exit code, as in a
// shell.
int interruptible(const RenderOrder& given, const std::function<bool()>& publish_all) {
  const Interruption interruption;
  bool whole = false;
  try {
    whole = publish_all();
  } catch (const RunError&) {
    clear_progress();
    if (Interruption::signal() == 0) {
      throw;  // it is not a sampling run that was stopped
    }
  }
  if (whole) {
    return 0;
  }
  const int signal = Interruption::signal();
  complain(std::string("stopped by ") + signal_name(signal) + ": no picture was written; " + given.sampling.checkpoint +
           " keeps the samples so far, and the same command goes on from there");
  return 128 + signal;
}

constexpr const char* kSpectral = "render: --spectral";

// The wavelengths of --spectral; none where it is not given. Throws InputError where they are impossible.
std::optional<Nodes> spectral_wavelengths(const RenderOrder& given, const Scene& scene, const Targets& targets) {
  if (!given.spectral) {
    return std::nullopt;
  }
  Nodes nodes = wavelengths_from(*given.spectral, kSpectral);
  require_spectra(scene, kSpectral);
  if (targets.exr.empty()) {
    throw InputError(std::string(kSpectral) + ": spectra stand in the EXR, and none is written; give -o FILE.exr too");
  }
  const struct {
    bool given;
    const char* option;
  } others[] = {{given.tables.has_value(), "--luts"}, {given.tile.has_value(), "--tile"}};
  for (const auto& other : others) {
    if (other.given) {
      throw InputError(std::string(kSpectral) + " does not go with " + other.option +
                       ", whose files hold colours; render twice, with one of them each");
    }
  }
  if (given.radiance) {
    require_components(nodes);
    if (spectral_unit(scene).name != kAbsoluteSpectralUnit) {
      throw InputError(std::string(kSpectral) +
                       " with --radiance: Radiance takes W/(m2 sr), and this sun has a spectrum "
                       "of its own without a unit; set sun.unit to W/m2 or lux, or leave one of the two out");
    }
  }
  require_spectrum_fits(scene, nodes.nm.size(), kSpectral);
  return nodes;
}

}  // namespace

int run_render(const RenderOrder& given) {
  Stopwatch watch;
  require_one_depth(given.picture, "render");
  const Scene scene = scene_of(given);
  const std::optional<ChoiceWish> wish = choice_wish(given, scene);
  if (!given.sampling.checkpoint.empty() && (wish || !samples(scene))) {
    throw InputError("render: --checkpoint keeps samples, and " +
                     (wish ? std::string("the method that --tolerance or --time-limit chooses") : scene.render.method) +
                     " takes none; leave it out, or choose a method that samples, such as path-trace");
  }
  if (given.cube_faces) {
    require_cube_stack(scene);
  }
  if (locks_frame(scene)) {
    locked_frame(scene);  // throws if it does not exist
  }
  const Targets targets = choose_targets(given);
  require_format(given, scene, targets);
  if (given.usd) {
    require_dome(given, scene, targets);
  }
  const std::optional<Nodes> spectral = spectral_wavelengths(given, scene, targets);
  Stage stage = ready(scene);
  std::optional<ImageSize> tile = wish ? std::nullopt : tile_of(given, stage, targets);
  const std::unique_ptr<MadeFolder> folder = given.dry_run ? nullptr : check_targets(given, targets);
  watch.lap("preset and checks");
  std::unique_ptr<Executor> executor;
  std::optional<ChoiceReport> choice;
  if (wish) {
    choice = choose_rendering(stage, *wish, device_on_demand(given.scene, executor), given.quiet);
    stage = choice->choice.chosen->stage;
    tile = tile_of(given, stage, targets);
    watch.lap("choice of method and quality");
  }
  std::optional<DisplayTransform> transform;
  const Means means{given, targets, transform, choice, executor, watch, spectral};
  if (given.dry_run) {
    return dry_run(means, stage);
  }
  if (!targets.png.empty()) {
    transform = display_transform(given.picture, stage.scene());
    watch.lap("OCIO config");
  }
  if (!given.quiet) {
    warn(stage, targets, transform, choice.has_value());
  }
  for (const std::string& file : targets.files()) {
    remove_abandoned_files_of(file);  // left half written by killed runs
  }
  stage = with_held_exposure(given, stage, device_on_demand(given.scene, executor));
  const auto publish_all = [&] { return make_picture(means, stage, tile); };
  return given.sampling.checkpoint.empty() ? (publish_all(), 0) : interruptible(given, publish_all);
}

}  // namespace airlight::cli
