#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>

#include "app/cli/frame_scene.h"
#include "app/cli/json_writer.h"
#include "app/cli/place_options.h"
#include "app/cli/sampling_options.h"
#include "app/cli/scene_files.h"
#include "app/cli/terminal.h"
#include "app/commands/commands.h"
#include "app/render/tile_option.h"
#include "app/sequence/pictures.h"
#include "app/sequence/radiance_matrix.h"
#include "app/sequence/run.h"
#include "app/sequence/usd_stage.h"
#include "app/sequence/wind.h"
#include "core/base/error.h"
#include "core/base/text.h"
#include "core/methods/method.h"
#include "core/methods/ready.h"
#include "core/output/atomic_file.h"
#include "core/scene/json_format.h"
#include "core/scene/named_file.h"
#include "core/scene/resolve.h"

namespace airlight::cli {
namespace {

using sequence::FrameSource;

constexpr std::size_t kManyFrames = 1'000'000;
constexpr int kFramesASecond = 24;

struct SequenceGiven {
  SceneOptions scene;
  SamplingOptions sampling;
  PictureOptions picture;
  SequencePictures pictures;
  std::optional<std::string> exr, png;
  PlaceOptions place;
  std::optional<std::string> from, to, step, until, sweep;
  std::optional<std::string> matrix;
  std::optional<std::string> usd;
  std::string up = "y";
  std::optional<int> patches;
  std::string shard = "1/1";
  std::optional<std::string> tile;
  std::optional<std::string> manifest;
  int frames_a_second = kFramesASecond;
  std::optional<int> preview_rate;
  bool overwrite = false;
  bool clean = false;
  bool yes = false;
  bool dry_run = false;
  bool json = false;
  bool quiet = false;
};

// The options of a sun path, with whether each was given. The first six make up a path.
struct PathOption {
  const char* name;
  bool given;
  bool needed;
};

std::vector<PathOption> path_options(const SequenceGiven& given) {
  const PlaceOptions& place = given.place;
  return {{"--date", place.date.has_value(), true},
          {"--from", given.from.has_value(), true},
          {"--to", given.to.has_value(), true},
          {"--step", given.step.has_value(), true},
          {"--lat", place.latitude.has_value(), true},
          {"--lon", place.longitude.has_value(), true},
          {"--until", given.until.has_value(), false},
          {"--tz", place.zone.has_value(), false},
          {"--place-altitude", place.altitude.has_value(), false},
          {"--refraction", place.refraction, false}};
}

sequence::SunPath sun_path_of(const SequenceGiven& given, const Scene& scene) {
  const std::string missing = joined_of(
      path_options(given), [](const PathOption& option) { return option.needed && !option.given ? option.name : ""; });
  if (!missing.empty()) {
    throw InputError("sequence: a sun path needs " + missing +
                     " as well; write for example --date 2026-06-21 --from 05:00 --to 21:00 --step 5m --lat 48.85 "
                     "--lon 2.35 --tz Europe/Paris");
  }
  if (given.scene.sun_azimuth) {
    throw InputError("sequence: --sun-azimuth: the sun path tells the azimuth; leave it out, or give --sun-elevation");
  }
  require_one_refraction(given.place, scene, "sequence");
  sequence::SunPath path =
      sequence::make_sun_path({*given.place.date, *given.from, *given.to, *given.step, given.place.zone.value_or("UTC"),
                               place_of(given.place), air_of(given.place, "sequence"), given.until});
  path.moon = scene.moon.has_value();
  path.stars = scene.night_sky.has_value() || scene.stars.has_value();
  return path;
}

// The source of the frames: the command line has precedence over the preset.
FrameSource source_of(const SequenceGiven& given, const Scene& scene) {
  const std::vector<PathOption> path = path_options(given);
  const auto first = std::ranges::find_if(path, [](const PathOption& option) { return option.given; });
  air_of(given.place, "sequence");  // refuses its further options where none is asked for
  if (given.sweep && first != path.end()) {
    throw InputError(std::string("sequence: --sun-elevation and ") + first->name +
                     " both move the sun; choose a sweep or a sun path");
  }
  const bool by_option = given.sweep || first != path.end();
  if (by_option && scene.sequence && !given.quiet) {
    complain("warning: the preset's own key frames are not used, as the command line says how the sun moves");
  }
  if (given.sweep) {
    return sequence::parse_sweep(*given.sweep, "sequence: --sun-elevation");
  }
  if (first != path.end()) {
    return sun_path_of(given, scene);
  }
  if (scene.sequence) {
    return *scene.sequence;
  }
  throw InputError(
      "sequence: nothing says what changes from frame to frame; give a sun path (--date, --from, --to, --step, --lat, "
      "--lon), a sweep (--sun-elevation -12:90:1), or a preset with key frames (\"sequence\")");
}

// Refuses options for keys that the frames set. Of a sun path and a sweep, which are options too, --set alone.
void refuse_idle_options(const Preset& preset, const FrameSource& source) {
  const std::string_view options = std::holds_alternative<KeyFrames>(source) ? "--" : "--set ";
  for (const auto& [pointer, values] : sequence::frame_at(source, 0).keys) {
    const PresetValue* value = find_value(preset.root, pointer);
    if (value != nullptr && value->line == 0 && value->source.starts_with(options)) {
      throw InputError("sequence: " + value->source + ": each frame has its own " + pointer + "; leave it out");
    }
  }
}

// The preset with the options of sampling and of the look, and --set; then the time limit, which only a method that
// samples takes.
Preset preset_of(const SequenceGiven& given) {
  std::vector<Override> further = overrides(given.sampling, false);
  for (Override& override : overrides(given.picture)) {
    further.push_back(std::move(override));
  }
  if (given.usd) {  // its lights are the discs
    further.push_back({"/sun/disc/visible=false", "--usd " + *given.usd});
  }
  if (given.place.date && !given.matrix) {  // the matrix is of daylight
    std::ranges::move(sky_of_date("--date " + *given.place.date), std::back_inserter(further));
  }
  Preset preset = chosen_preset(given.scene, further);
  if (!given.sampling.time_limit) {
    return preset;
  }
  const std::string method = resolve(preset, method_infos()).render.method;
  if (find_method(method)->render_on_host == nullptr) {
    throw InputError("sequence: --time-limit: " + method +
                     " does not sample; 'airlight render PRESET --time-limit TIME --dry-run' finds a method and its "
                     "quality for such a time: give those");
  }
  SamplingOptions limit;
  limit.time_limit = given.sampling.time_limit;
  for (const Override& override : overrides(limit, true)) {
    apply_override(preset, override.assignment, override.typed);
  }
  return preset;
}

SequenceJob job_of(const SequenceGiven& given) {
  SequenceJob job;
  job.scene_options = given.scene;
  job.picture = given.picture;
  job.tile = given.tile;
  job.frames_a_second = given.frames_a_second;
  job.overwrite = given.overwrite;
  job.clean = given.clean;
  job.quiet = given.quiet;
  job.json = given.json;
  if (!given.exr && !given.png && !given.matrix) {
    throw InputError("sequence: no files to write; give a pattern such as -o 'sky.####.exr' or --png 'sky.####.png'");
  }
  const bool stream = given.exr == "-" || given.png == "-";
  const PictureNames names =
      stream ? PictureNames{given.exr, given.png} : picture_names(given.exr, given.png, given.json, "sequence");
  if (names.exr) {
    job.exr = sequence::require_pattern(*names.exr, ".exr", "sequence: -o");
  }
  if (names.png) {
    job.png = sequence::require_pattern(*names.png, ".png", "sequence: --png");
  }
  job.shard = sequence::parse_shard(given.shard, "sequence: --shard");
  require_one_depth(given.picture, "sequence");
  job.preset = preset_of(given);
  job.scene = judged(job.preset);
  require_layers(given.picture, job.scene, job.exr.has_value(), "sequence");
  job.stage = ready(job.scene);
  tile_for(job.tile, *job.stage, layer_set(given.picture), "sequence");  // throws if it is no tile
  job.source = source_of(given, job.scene);
  refuse_idle_options(job.preset, job.source);
  add_winds(job);
  std::get<PresetObject>(job.preset.root.data).erase("sequence");
  job.scene.sequence.reset();
  if (locks_frame(job.scene)) {
    locked_frame(job);  // throws if it does not exist
  }
  if (!job.exr && !job.png) {
    return job;
  }
  job.manifest = given.manifest ? sequence::manifest_file(*given.manifest, job.shard)
                                : sequence::manifest_file(job.exr ? *job.exr : *job.png, job.shard);
  const std::size_t frames = sequence::frame_count(job.source);
  if (frames > kManyFrames && !given.yes) {
    throw InputError("sequence: " + std::to_string(frames) +
                     " frames; more than a million are most often a slip in the step: say --yes to mean it");
  }
  return job;
}

// The list of frames is read before the first frame and replaced as it grows, which only a file can be.
void require_manifest_file(const std::string& file) {
  std::error_code ignored;
  if (std::filesystem::exists(file, ignored)) {
    if (const std::string problem = named_file_problem(file); !problem.empty()) {
      throw InputError("sequence: --manifest: " + file + ": " + problem + "; name a file, such as frames.json");
    }
  }
}

// Reports everything that can be known to fail before anything is rendered.
void check_targets(const SequenceJob& job, const SequencePictures& pictures) {
  require_manifest_file(job.manifest);
  const Targets files = files_of(job, sequence::frame_number(job.source, 0));
  for (const std::string& file : {files.exr, files.png, job.manifest}) {
    if (!file.empty()) {
      require_writable(file);
    }
  }
  check_pictures(pictures, job);
}

std::string frame_json(const SequenceJob& job, const sequence::Frame& frame) {
  JsonWriter json;
  const Targets files = files_of(job, frame.number);
  json.begin_object().key("frame").value(frame.number).key("file").value(files.first());
  json.key("png").text_or_null(files.png).key("time").text_or_null(frame.time ? iso_text(*frame.time) : "");
  json.key("keys").begin_object();
  for (const auto& [pointer, values] : frame.keys) {
    json.key(pointer);
    values.size() == 1 ? json.value(values.front()) : json.values(values);
  }
  return json.end_object().end_object().take();
}

// Prints the frames as they would be rendered.
int dry_run(const SequenceJob& job) {
  const std::size_t frames = sequence::shard_size(job.shard, sequence::frame_count(job.source));
  for (std::size_t k = 0; k < frames; ++k) {
    const sequence::Frame frame = sequence::frame_at(job.source, sequence::shard_frame(job.shard, k));
    if (job.json) {
      print(frame_json(job, frame));
      continue;
    }
    std::string line = files_of(job, frame.number).first();
    if (frame.time) {
      line += "  " + iso_text(*frame.time);
    }
    for (const auto& [pointer, values] : frame.keys) {
      line += "  " + pointer + "=";
      for (std::size_t i = 0; i < values.size(); ++i) {
        line += (i == 0 ? "" : ",") + format_number(values[i]);
      }
    }
    print(line + "\n");
  }
  return 0;
}

// A matrix is one file, whole or not there: what belongs to frames has no meaning for it.
int run_matrix(const SequenceGiven& given) {
  const SequencePictures& pictures = given.pictures;
  const PictureOptions& picture = given.picture;
  const std::array<std::pair<const char*, bool>, 23> idle{{{"-o", given.exr.has_value()},
                                                           {"--png", given.png.has_value()},
                                                           {"--usd", given.usd.has_value()},
                                                           {"--shard", given.shard != "1/1"},
                                                           {"--manifest", given.manifest.has_value()},
                                                           {"--preview", pictures.preview.has_value()},
                                                           {"--contact-sheet", pictures.contact_sheet.has_value()},
                                                           {"--layers", !picture.layers.empty()},
                                                           {"--float", picture.full_float},
                                                           {"--half", picture.half_float},
                                                           {"--exposure", picture.exposure.has_value()},
                                                           {"--ev", picture.compensation.has_value()},
                                                           {"--display", picture.display.has_value()},
                                                           {"--view", picture.view.has_value()},
                                                           {"--colorspace", !picture.colorspace.empty()},
                                                           {"--tile", given.tile.has_value()},
                                                           {"--bits", picture.bits != PictureOptions().bits},
                                                           {"--ocio-config", !picture.ocio_config.empty()},
                                                           {"--fps", given.frames_a_second != kFramesASecond},
                                                           {"--preview-rate", given.preview_rate.has_value()},
                                                           {"--clean", given.clean},
                                                           {"--overwrite", given.overwrite},
                                                           {"--json", given.json}}};
  for (const auto& [name, is_given] : idle) {
    if (is_given) {
      throw InputError(std::string("sequence: --radiance-matrix: ") + name +
                       " is for frames, and a matrix has none; leave it out");
    }
  }
  const SequenceJob job = job_of(given);
  const MatrixOrder order{*given.matrix, given.patches.value_or(1)};
  check_matrix(order, job);
  if (given.dry_run) {
    print(std::to_string(sequence::frame_count(job.source)) + " columns\n");
    return 0;
  }
  const int signal = write_matrix(order, job);
  return signal == 0 ? 0 : 128 + signal;
}

int run(const SequenceGiven& given) {
  if (given.matrix) {
    return run_matrix(given);
  }
  if (given.patches) {
    throw InputError("sequence: --patches is for --radiance-matrix; give that too, or leave it out");
  }
  if (given.up != "y" && !given.usd) {
    throw InputError("sequence: --up is for --usd; give that too, or leave it out");
  }
  const SequenceJob job = job_of(given);
  const std::optional<UsdStageOrder> stage =
      given.usd ? std::optional(UsdStageOrder{*given.usd, given.up}) : std::nullopt;
  if (stage) {
    check_usd_stage(*stage, job);
  }
  if (given.dry_run) {
    return dry_run(job);
  }
  SequencePictures pictures = given.pictures;
  pictures.frames_a_second = given.preview_rate.value_or(given.frames_a_second);
  check_targets(job, pictures);
  const SequenceOutcome outcome = run_sequence(job);
  if (outcome.signal != 0) {
    return 128 + outcome.signal;  // as in a shell
  }
  make_pictures(pictures, job);
  if (stage) {
    write_usd_stage(*stage, job);
  }
  return 0;
}

std::vector<Option> frame_options(SequenceGiven& given) {
  return place_options(
      given.place,
      {{"--from", "HH:MM", "Time of day of the first frame, in the time zone of --tz", &given.from},
       {"--to", "HH:MM", "Time of day of the last frame, if the step meets it. A time before --from is on the next day",
        &given.to},
       {"--until", "YYYY-MM-DD", "Date of --to, for several days in one run (default: that of --date)", &given.until},
       {"--step", "TIME", "Time from frame to frame: a number with h, m or s, e.g. 5m or 1h30m", &given.step}});
}

std::vector<Option> run_options(SequenceGiven& given) {
  return grouped(
      "Run",
      {{"--overwrite", "", "Render again the frames that are already whole and of this preset", &given.overwrite},
       {"--shard", "I/N", "Render every N-th frame from the I-th on, e.g. 3/16 on the third of 16 machines",
        &given.shard},
       {"--manifest", "FILE.json", "File for the list of frames (default: NAME.manifest.json beside the frames)",
        &given.manifest, Completes::file},
       {"--preview", "FILE", "Make a film of the frames, .mp4 or .gif; this needs ffmpeg", &given.pictures.preview,
        Completes::file},
       {"--preview-rate", "N", "Frames per second of the film (default: --fps)", &given.preview_rate,
        Completes::nothing, Range{1.0, 1000.0}},
       {"--contact-sheet", "FILE.png", "Make a sheet of small pictures of at most 60 frames, evenly spread",
        &given.pictures.contact_sheet, Completes::file},
       {"--clean", "",
        "Remove older frames whose names match but that are not part of this sequence, e.g. those of a finer step",
        &given.clean},
       {"--fps", "N", "Frames per second, for the headers of the frames and for the preview (default: 24)",
        &given.frames_a_second, Completes::nothing, Range{1.0, 1000.0}},
       tile_option(given.tile),
       {"--yes", "", "Allow more than a million frames", &given.yes},
       {"--dry-run", "", "List the frames, but open no device and write nothing", &given.dry_run},
       {"--json", "", "Print one JSON object for each frame on standard output, and one at the end", &given.json},
       {"-q,--quiet", "", "Say nothing but errors", &given.quiet}});
}

std::vector<Option> sequence_options(SequenceGiven& given) {
  std::vector<Option> options = grouped(
      "Output",
      {{"-o,--output", "PATTERN.exr",
        "Write the EXR frames here, with # for their numbers: sky.####.exr. A name that ends in .png is that of --png",
        &given.exr, Completes::file},
       {"--png", "PATTERN.png", "Write the pictures for people here, e.g. sky.####.png", &given.png, Completes::file},
       {"--usd", "FILE.usda",
        "Also write a USD stage for all frames: the EXRs, latlongs, as a dome, sun and moon as distant lights, with a "
        "time sample a frame. The EXRs then show no discs",
        &given.usd, Completes::file},
       {.names = "--up",
        .metavar = "y|z",
        .help = "The axis that points up in that stage (default: y)",
        .target = &given.up,
        .choices = {"y", "z"}},
       {"--radiance-matrix", "FILE.mtx",
        "Write no frames but one sky matrix for the daylight programs of Radiance: a row a patch of the sky, a column "
        "a "
        "moment, with sun and moon in their nearest patches",
        &given.matrix, Completes::file},
       {"--patches", "N",
        "Divide each of Tregenza's 145 patches in N by N as Reinhart does: 145, 577, 1297 or 2305, and the ground "
        "(default: 1)",
        &given.patches, Completes::nothing, Range{1.0, 4.0}}});
  const auto without = [](std::vector<Option> all, const std::vector<std::string>& left_out) {
    std::erase_if(all,
                  [&](const Option& option) { return std::ranges::find(left_out, option.names) != left_out.end(); });
    return all;
  };
  append(options, frame_options(given));
  append(options, grouped("Sweep of the sun",
                          {{"--sun-elevation", "FROM:TO:STEP",
                            "Sweep the sun's elevation, in degrees, instead of a path, e.g. -12:90:1", &given.sweep},
                           {"--sun-azimuth", "DEG", "Azimuth of the sun in a sweep, clockwise from north",
                            &given.scene.sun_azimuth}}));
  append(options, without(scene_options(given.scene), {"--sun-elevation", "--sun-azimuth"}));
  append(options, camera_options(given.scene));
  append(options, without(sampling_options(given.sampling), {"--checkpoint", "--time-limit"}));
  // It differs from render's, since one choice of method and quality would have to hold for all frames.
  append(options, grouped("Method", {{"--time-limit", "TIME",
                                      "Stop sampling a frame after this time, e.g. 50ms, 2s, 1min, with a method that "
                                      "samples",
                                      &given.sampling.time_limit}}));
  append(options, picture_options(given.picture));
  append(options, run_options(given));
  return options;
}

}  // namespace

Command sequence_command() {
  const auto given = std::make_shared<SequenceGiven>();
  Command command;
  command.name = "sequence";
  command.summary = "Render a day, a sweep of the sun or key frames to numbered files";
  command.description =
      "One of three things changes from frame to frame: the sun's path over a place (--date, --from, --to, --step, "
      "--lat, --lon), a sweep of the sun's elevation (--sun-elevation), or the preset's own key frames (its key "
      "sequence). The path is that of the sun's centre. It is good to 0.01 degrees and has no refraction, "
      "since the preset's air bends light itself (planet.refraction). Where it does not, --refraction lifts the "
      "sun.\n\n"
      "The exposure is automatic by default. It comes from each frame's own light, so a frame has the same exposure in "
      "every shard. It is steady by day, follows the dusk as an eye does, and leaves the night dark. --exposure "
      "lock:FRAME gives all frames the exposure of one frame. --exposure day gives them that of a midday. The EXRs "
      "have 16-bit floats if these hold the frame, otherwise 32-bit floats.\n\n"
      "You may stop a run and start the same command again. airlight then keeps the frames that are whole and carry "
      "the hash of their preset. Every file appears whole or not at all, whatever ends the run. Ctrl-C finishes the "
      "frame in hand; with a method that samples, it drops the frame. The exit code is then 130. A second Ctrl-C drops "
      "the frame and ends the run at once.\n\n"
      "The manifest is a JSON file that lists frames, times, sun angles, files, hashes and milliseconds. Several "
      "machines share a sequence with --shard. scripts/slurm-sequence submits a sequence to Slurm.";
  command.examples = {
      {"airlight sequence earth-noon -o 'day.####.exr' --date 2026-06-21 --from 06:00 --to 18:00 --step 6h --lat 48.85 "
       "--lon 2.35 --tz Europe/Paris --size 64x36",
       "Three skies over Paris"},
      {"airlight sequence earth-noon --png 'sweep.##.png' --sun-elevation -6:6:6 --size 64x36",
       "The sun from 6 degrees below the horizon to 6 above"},
      {"airlight sequence earth-noon -o 'day.####.exr' --date 2026-06-21 --from 00:00 --to 24:00 --step 1m --lat 69.65 "
       "--lon 18.96 --tz Europe/Oslo --dry-run",
       "List the frames of a day without a night"},
      {"airlight sequence earth-noon -o 'dome.##.exr' --usd day.usda --sun-elevation 0:20:10 --projection latlong "
       "--size 64x32",
       "A stage for programs that read USD, with a sky a frame"},
      {"airlight sequence earth-noon --radiance-matrix day.mtx --date 2026-06-21 --from 06:30 --to 17:30 --step 1h "
       "--lat "
       "48.85 --lon 2.35",
       "A day's sky for daylight programs; with --until 2026-12-31 a year's"}};
  command.positionals = {preset_positional(given->scene)};
  command.options = sequence_options(*given);
  command.run = [given] { return run(*given); };
  return command;
}

}  // namespace airlight::cli
