#include <filesystem>
#include <memory>

#include "app/choice_options.h"
#include "app/commands.h"
#include "app/cube_faces.h"
#include "app/lighting_files.h"
#include "app/picture_files.h"
#include "app/picture_options.h"
#include "app/preset_source.h"
#include "app/progress.h"
#include "app/publish.h"
#include "app/render_report.h"
#include "app/sampling_options.h"
#include "app/scene_options.h"
#include "app/stopwatch.h"
#include "app/table_files.h"
#include "app/terminal.h"
#include "app/tiled_picture.h"
#include "app/validity.h"
#include "core/error.h"
#include "core/output/atomic_file.h"
#include "core/output/half_block.h"
#include "core/scene/preset.h"
#include "core/scene/resolve.h"

namespace airlight::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* kDefaultFolder = "out";

struct Given {
  SceneOptions scene;
  SamplingOptions sampling;
  std::optional<std::string> tolerance;
  std::optional<std::string> exr;
  std::optional<std::string> png;
  std::optional<std::string> tables;
  std::optional<std::string> tile;
  std::optional<std::string> irradiance;
  bool cube_faces = false;
  PictureOptions picture;
  bool timings = false;
  bool json = false;
  bool dry_run = false;
  bool quiet = false;
  bool verbose = false;
};

Targets choose_targets(const Given& given) {
  if (given.exr || given.png) {
    return {given.exr.value_or(""), given.png.value_or(""), given.tables.value_or("")};
  }
  const fs::path name = fs::path(kDefaultFolder) / picture_name(given.scene.preset);
  return {name.string() + ".exr", name.string() + ".png", given.tables.value_or("")};
}

// Everything that can be known to fail is said before anything is rendered.
void check_targets(const Given& given, const Targets& targets) {
  if (!given.exr && !given.png) {
    make_folder(kDefaultFolder);
  }
  if (!targets.exr.empty()) {
    require_ending(targets.exr, "render: -o", ".exr");
    require_writable(targets.exr);
  }
  if (!targets.png.empty()) {
    require_ending(targets.png, "render: --png", ".png");
    require_writable(targets.png);
  }
  if (!targets.tables.empty()) {
    require_folder(targets.tables);
  }
  if (given.irradiance) {
    require_ending(*given.irradiance, "render: --irradiance", ".exr");
    require_writable(*given.irradiance);
    require_writable(lighting_json_file(*given.irradiance));
    std::error_code ignored;
    if (fs::equivalent(lighting_json_file(*given.irradiance), given.scene.preset, ignored)) {
      throw InputError("render: --irradiance: '" + given.scene.preset + "' would be written over; give another name");
    }
    if (*given.irradiance == targets.exr) {
      throw InputError("render: --irradiance: '" + targets.exr + "' is where -o writes; give a name of its own");
    }
  }
}

bool samples(const Scene& scene) {
  return find_method(scene.render.method)->render_on_host != nullptr;
}

Scene scene_of(const Given& given) {
  const std::vector<std::string> further = overrides(given.picture);
  const auto with = [&](bool of_sampling) {
    std::vector<std::string> all = overrides(given.sampling, of_sampling);
    all.insert(all.end(), further.begin(), further.end());
    return load_scene(given.scene, all);
  };
  Scene scene = with(false);
  return samples(scene) && given.sampling.time_limit ? with(true) : scene;
}

// Nothing where method and quality are the preset's.
std::optional<ChoiceWish> choice_wish(const Given& given, const Scene& scene) {
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
    wish.tolerance = relative_error(*given.tolerance, "render: --tolerance");
  } else {
    wish.limit_ms = milliseconds_from(*given.sampling.time_limit, "render: --time-limit");
    if (!(wish.limit_ms > 0.0)) {
      throw InputError("render: --time-limit: nothing is rendered in no time; write for example 50ms");
    }
  }
  return wish;
}

RenderRequest request_of(const Scene& scene, const Targets& targets) {
  RenderRequest request = request_for(scene, !targets.exr.empty(), !targets.png.empty());
  request.tables = !targets.tables.empty();
  return request;
}

int dry_run(const Scene& scene, const Targets& targets, const std::optional<ChoiceReport>& choice) {
  const std::string why = choice ? summary(*choice) + "\n" + explanation(*choice) : "";
  print(why + describe(scene) + plan_text(plan_for(scene, request_of(scene, targets))));
  return 0;
}

void tell_people(const Given& given, const RenderReport& report) {
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

// One picture, or the six of a cube.
Published publish_pictures(const Given& given, const PictureContext& context, const Targets& targets,
                           const std::optional<DisplayTransform>& transform, Stopwatch& watch) {
  const PublishOrder order{targets, given.scene.preset, !given.picture.full_float, given.picture.bits};
  if (!given.cube_faces) {
    return publish(context, order, transform, watch);
  }
  Published all;
  for (const CubeFace& face : cube_faces(context.scene, context.rendering)) {
    PublishOrder one = order;
    one.targets = {face_file(targets.exr, face.name), face_file(targets.png, face.name), ""};
    Provenance provenance = context.provenance;
    provenance.preset_json = to_json(face.scene);
    const PictureContext of_face{face.scene, face.rendering, provenance, context.choice, {}, {}, context.space};
    const Published done = publish(of_face, one, transform, watch);
    all.files.insert(all.files.end(), done.files.begin(), done.files.end());
    if (done.exr) {
      add_counts(all.exr ? *all.exr : all.exr.emplace(), *done.exr);
    }
  }
  if (!targets.tables.empty()) {
    const std::vector<std::string> tables = write_tables(targets.tables, context.rendering.tables, context.provenance);
    all.files.insert(all.files.end(), tables.begin(), tables.end());
  }
  return all;
}

std::optional<ChoiceNote> note_of(const std::optional<ChoiceReport>& choice) {
  return choice ? std::optional(ChoiceNote{choice->choice.chosen->quality, choice->choice.error}) : std::nullopt;
}

// What a picture is made with, beside the scene.
struct Means {
  const Given& given;
  const Targets& targets;
  const std::optional<DisplayTransform>& transform;
  const std::optional<ChoiceReport>& choice;
  std::unique_ptr<Executor>& executor;
  Stopwatch& watch;
};

std::optional<DeviceInfo> device_of(const Means& means) {
  return means.executor ? std::optional(means.executor->device()) : std::nullopt;
}

Provenance provenance_of(const Means& means, const Scene& scene) {
  const std::optional<DeviceInfo> device = device_of(means);
  return {to_json(scene), scene.render.method, AIRLIGHT_VERSION, device ? device->name : "the processor"};
}

void tell(const Means& means, RenderReport& report) {
  const Given& given = means.given;
  report.exr_format = given.picture.full_float ? "float" : "half";
  if (!means.targets.png.empty()) {
    report.view =
        means.transform ? means.transform->display() + " / " + means.transform->view() : report.scene.display.view;
  }
  tell_people(given, report);
  if (given.json) {
    print(json_report(report));
  }
}

// From a checked scene to files on disk.
void render_and_publish(const Means& means, const Scene& scene) {
  const Given& given = means.given;
  RenderRequest request = request_of(scene, means.targets);
  request.layers = given.picture.layers;
  request.host = host_options(given.sampling, given.quiet);
  Rendering rendering = render(device_on_demand(given.scene, means.executor), scene, request);
  clear_progress();
  means.watch.lap("render");
  if (means.choice) {
    const std::vector<std::string>& left_out = means.choice->choice.left_out;
    rendering.left_out.insert(rendering.left_out.begin(), left_out.begin(), left_out.end());
  }
  std::optional<Lighting> lighting;
  if (given.irradiance && rendering.fault().empty()) {
    lighting = lighting_of(device_on_demand(given.scene, means.executor), scene, request.host);
    clear_progress();
    means.watch.lap("irradiance");
  }
  require_valid_vulkan();
  const PictureContext context{scene, rendering, provenance_of(means, scene),    note_of(means.choice),
                               {},    {},        working_space_of(given.picture)};
  Published done = publish_pictures(given, context, means.targets, means.transform, means.watch);
  if (lighting) {
    const std::vector<std::string> files = write_lighting(*given.irradiance, *lighting, context);
    done.files.insert(done.files.end(), files.begin(), files.end());
    means.watch.lap("irradiance, writing");
  }
  const Plan plan = plan_for(scene, request);
  RenderReport report{scene,    rendering, plan, device_of(means), done.files,
                      done.exr, {},        {},   means.choice,     means.watch};
  tell(means, report);
}

void render_in_tiles(const Means& means, const Scene& scene, const ImageSize& tile) {
  const Given& given = means.given;
  const DeviceOnDemand device = device_on_demand(given.scene, means.executor);
  device();  // its name stands in the header, before the first tile
  const TiledOrder order{
      .tile = tile,
      .layers = given.picture.layers,
      .half = !given.picture.full_float,
      .file = means.targets.exr,
      .source = given.scene.preset,
      .provenance = provenance_of(means, scene),
      .choice = note_of(means.choice),
      .space = working_space_of(given.picture),
      .left_out = means.choice ? means.choice->choice.left_out : std::vector<std::string>(),
      .report = host_options(given.sampling, given.quiet).report,
  };
  const TiledPicture done = write_tiled(device, scene, order);
  clear_progress();
  means.watch.lap("render");
  require_valid_vulkan();
  const Plan plan = plan_for(scene, {});
  RenderReport report{scene, done.rendering, plan,       device_of(means), {order.file}, done.counts, {},
                      {},    means.choice,   means.watch};
  report.tile = tile;
  tell(means, report);
}

// Why options beside the files' own need the whole picture; empty: they do not.
std::string needs_whole(const Given& given) {
  if (given.cube_faces) {
    return "--cube-faces cuts the whole picture; render one face at a time, or the stack in one file";
  }
  return given.irradiance ? "--irradiance stands beside a whole picture; write it by a run of its own, of a small one"
                          : "";
}

// The tile of a picture that is rendered in tiles. Throws InputError for layers and tiles that cannot be had.
std::optional<ImageSize> tile_of(const Given& given, const Scene& scene, const Targets& targets) {
  require_layers(given.picture, scene, !targets.exr.empty(), "render");
  return tile_for(given.tile, scene, targets, given.picture.layers, needs_whole(given));
}

void warn(const Given& given, const Scene& scene, const Targets& targets, bool tiled,
          const std::optional<DisplayTransform>& transform) {
  const std::string untiled = tiled ? "" : untiled_warning(scene, targets, needs_whole(given));
  for (const std::string& warning :
       {validity_warning(scene), untiled, transform ? transform->warning() : std::string()}) {
    if (!warning.empty()) {
      complain("warning: " + warning);
    }
  }
}

int run_render(const Given& given) {
  Stopwatch watch;
  Scene scene = scene_of(given);
  const std::optional<ChoiceWish> wish = choice_wish(given, scene);
  if (given.cube_faces) {
    require_cube_stack(scene);
  }
  const Targets targets = choose_targets(given);
  std::optional<ImageSize> tile = wish ? std::nullopt : tile_of(given, scene, targets);
  if (!given.dry_run) {
    check_targets(given, targets);
  }
  watch.lap("preset and checks");
  std::unique_ptr<Executor> executor;
  std::optional<ChoiceReport> choice;
  if (wish) {
    choice = choose_rendering(scene, *wish, device_on_demand(given.scene, executor));
    scene = choice->choice.chosen->scene;
    tile = tile_of(given, scene, targets);
    watch.lap("choice of method and quality");
  }
  if (given.dry_run) {
    return dry_run(scene, targets, choice);
  }
  std::optional<DisplayTransform> transform;
  if (!targets.png.empty()) {
    transform = display_transform(given.picture, scene);
    watch.lap("OCIO config");
  }
  if (!given.quiet) {
    warn(given, scene, targets, tile.has_value(), transform);
  }
  const Means means{given, targets, transform, choice, executor, watch};
  if (tile) {
    render_in_tiles(means, scene, *tile);
  } else {
    render_and_publish(means, scene);
  }
  return 0;
}

std::vector<Option> render_options(Given& given) {
  std::vector<Option> options = {
      {"-o,--output", "FILE.exr", "Write the scene-linear EXR here; then no PNG unless --png asks for it", &given.exr,
       Completes::file},
      {"--png", "FILE.png", "Write the picture for people here; then no EXR unless -o asks for it", &given.png,
       Completes::file},
      {"--luts", "DIR", "Also write every table into this folder, as 'airlight luts' does", &given.tables,
       Completes::folder},
      {"--tile", "WxH",
       "Render in tiles of this size, streamed into the EXR, in bounded memory; else in rows of tiles from 8388609 "
       "pixels on where neither PNG nor bloom needs the whole picture. The file is the same",
       &given.tile},
      {"--irradiance", "FILE.exr",
       "Also write what the sky gives a diffuse surface: a map over normals here, and in FILE.json beside it its 9 "
       "spherical-harmonic coefficients and the sun as a directional light",
       &given.irradiance, Completes::file},
      {"--cube-faces", "",
       "Write a cube map as six pictures instead of one: FILE.posx.exr, .negx, .posy, .negy, .posz, .negz",
       &given.cube_faces},
      size_option(given.scene)};
  for (Option& option : scene_options(given.scene)) {
    options.push_back(std::move(option));
  }
  options.push_back({"--tolerance", "ERROR",
                     "Choose the cheapest method and quality whose mean relative error stays below this, e.g. 1%, by "
                     "probing this very picture; with --method among its qualities",
                     &given.tolerance});
  for (Option& option : sampling_options(given.sampling)) {
    options.push_back(std::move(option));
  }
  for (Option& option : picture_options(given.picture)) {
    options.push_back(std::move(option));
  }
  const std::vector<Option> rest = {
      {"--timings", "", "Tell where the time went, every millisecond by name", &given.timings},
      {"--json", "", "Print one JSON object about the render on standard output", &given.json},
      {"--dry-run", "",
       "Print the resolved scene and the passes; write nothing, and open no device unless --tolerance or --time-limit "
       "has "
       "to be explained",
       &given.dry_run},
      {"-q,--quiet", "", "Say nothing but errors", &given.quiet},
      {"-v,--verbose", "", "Say more: device, exposure, what was left out", &given.verbose}};
  options.insert(options.end(), rest.begin(), rest.end());
  return options;
}

}  // namespace

Command render_command() {
  const auto given = std::make_shared<Given>();
  Command command;
  command.name = "render";
  command.summary = "Render a preset to a scene-linear EXR and a PNG";
  command.description =
      "Without -o and --png the files are out/NAME.exr and out/NAME.png, NAME being the preset's; the folder out is "
      "made "
      "if need be.\n\n"
      "Every file appears whole or not at all. A result with a NaN, an infinity or a negative value is not written: "
      "the command fails and says where it is.\n\n"
      "An EXR of airlight's carries its whole preset: rendering the EXR renders the same picture again.\n\n"
      "With --layers, NAME.R, .G and .B of each medium that scatters, of multiple, sun and ground sum up to R, G and "
      "B. transmittance is that to the ground or to space, depth.Z the distance in km to the ground or to where the "
      "ray leaves the air (1e10 where it meets neither; always 32 bits), N.X, .Y and .Z the ground's normal, x east, "
      "y up, z south, 0 where there is no ground. Bloom, where the preset asks for it in the EXR, is a layer outside "
      "the sum. --colorspace converts the light layers, and the transmittance as the colour of white seen through the "
      "air.\n\n"
      "--tolerance and --time-limit choose method and quality for this scene and picture, whatever the preset has "
      "under "
      "render: a few hundred of the picture's directions are computed by candidates and by a near-truth quality. The "
      "choice, the error that it is sure to stay below and what it leaves out stand in the log, in --json and in the "
      "EXR; -v and --dry-run tell what was tried. A tolerance that nothing reaches is refused, the best being named.";
  command.examples = {{"airlight render earth-sunset", "Write out/earth-sunset.exr and out/earth-sunset.png"},
                      {"airlight render my-sky.json -o sky.exr --png sky.png --sun-elevation 2 --size 1920x1080",
                       "A preset of one's own, with a lower sun and a larger picture"},
                      {"airlight render earth-noon --set /camera/pitch_deg=20 --png up.png --view gpu",
                       "Look up, and show the picture by the GPU tone curve"},
                      {"airlight render my-sky.json --tolerance 1% -o sky.exr", "Model no more than 1 % asks for"},
                      {"airlight render my-sky.json --colorspace ACEScg -o sky.exr", "An EXR for an ACES pipeline"},
                      {"airlight render my-sky.json --irradiance light.exr -o sky.exr",
                       "Also light.exr and light.json, for image-based lighting"},
                      {"airlight render sky.exr -o again.exr", "Render the picture of an EXR again"},
                      {"airlight render earth-sunset --layers -o layers.exr --size 160x90",
                       "Rayleigh, mie, multiple, sun, ground, transmittance, depth and normals apart, for compositing"},
                      {"airlight render earth-noon --size 640x360 --tile 200x100 -o tiles.exr",
                       "A picture of any size in bounded memory"}};
  command.positionals = {preset_positional(given->scene)};
  command.options = render_options(*given);
  command.run = [given] { return run_render(*given); };
  return command;
}

}  // namespace airlight::cli
