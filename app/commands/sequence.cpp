#include <algorithm>
#include <memory>

#include "app/cli/sampling_options.h"
#include "app/cli/terminal.h"
#include "app/commands/commands.h"
#include "app/sequence/pictures.h"
#include "app/sequence/run.h"
#include "core/error.h"
#include "core/methods/method.h"
#include "core/output/atomic_file.h"
#include "core/scene/json_format.h"
#include "core/scene/resolve.h"

namespace airlight::cli {
namespace {

using sequence::FrameSource;

constexpr std::size_t kManyFrames = 1'000'000;

struct Given {
  SceneOptions scene;
  SamplingOptions sampling;
  PictureOptions picture;
  SequencePictures pictures;
  std::optional<std::string> exr, png;
  std::optional<std::string> date, from, to, step, zone, sweep;
  std::optional<double> latitude, longitude, place_altitude;
  bool refraction = false;
  std::optional<double> pressure, temperature;
  std::string shard = "1/1";
  std::optional<std::string> manifest;
  bool overwrite = false;
  bool yes = false;
  bool dry_run = false;
  bool json = false;
  bool quiet = false;
};

// The options of a sun path: name and whether it was given. The first six make one.
struct PathOption {
  const char* name;
  bool given;
  bool needed;
};

std::vector<PathOption> path_options(const Given& given) {
  return {{"--date", given.date.has_value(), true},    {"--from", given.from.has_value(), true},
          {"--to", given.to.has_value(), true},        {"--step", given.step.has_value(), true},
          {"--lat", given.latitude.has_value(), true}, {"--lon", given.longitude.has_value(), true},
          {"--tz", given.zone.has_value(), false},     {"--place-altitude", given.place_altitude.has_value(), false},
          {"--refraction", given.refraction, false}};
}

sequence::SunPath sun_path_of(const Given& given) {
  std::string missing;
  for (const PathOption& option : path_options(given)) {
    if (option.needed && !option.given) {
      missing += (missing.empty() ? "" : ", ") + std::string(option.name);
    }
  }
  if (!missing.empty()) {
    throw InputError("sequence: a sun path needs " + missing +
                     " as well; write for example --date 2026-06-21 --from 05:00 --to 21:00 --step 5m --lat 48.85 "
                     "--lon 2.35 --tz Europe/Paris");
  }
  if (given.scene.sun_azimuth) {
    throw InputError("sequence: --sun-azimuth: the sun path tells the azimuth; leave it out, or give --sun-elevation");
  }
  sequence::SunPathOrder order{*given.date, *given.from, *given.to, *given.step, given.zone.value_or("UTC"), {}};
  order.place = {*given.latitude, *given.longitude, given.place_altitude.value_or(0.0)};
  if (given.refraction) {
    const sequence::Air standard;
    order.refraction = sequence::Air{given.pressure.value_or(standard.pressure_hpa),
                                     given.temperature.value_or(standard.temperature_c)};
  }
  return sequence::make_sun_path(order);
}

// From where the frames come: the command line before the preset.
FrameSource source_of(const Given& given, const Scene& scene) {
  const std::vector<PathOption> path = path_options(given);
  const auto first = std::find_if(path.begin(), path.end(), [](const PathOption& option) { return option.given; });
  if (!given.refraction && (given.pressure || given.temperature)) {
    throw InputError("sequence: --pressure and --temperature belong to --refraction; give it too, or leave them out");
  }
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
    return sun_path_of(given);
  }
  if (scene.sequence) {
    return *scene.sequence;
  }
  throw InputError(
      "sequence: nothing says what changes from frame to frame; give a sun path (--date, --from, --to, --step, --lat, "
      "--lon), a sweep (--sun-elevation -12:90:1), or a preset with key frames (\"sequence\")");
}

// What the frames set, nobody else can.
void refuse_idle_overrides(const Given& given, const FrameSource& source) {
  const sequence::Frame frame = sequence::frame_at(source, 0);
  for (const std::string& assignment : given.scene.set) {
    const std::string pointer = assignment.substr(0, assignment.find('='));
    const bool is_moved =
        std::any_of(frame.keys.begin(), frame.keys.end(), [&](const auto& key) { return key.first == pointer; });
    if (is_moved) {
      throw InputError("sequence: --set " + assignment + ": each frame has its own " + pointer + "; leave it out");
    }
  }
}

// The options of sampling but the limit, of the look, and --set; then the limit, which only a method that samples
// takes.
Preset preset_of(const Given& given) {
  std::vector<std::string> further = overrides(given.sampling, false);
  for (std::string& assignment : overrides(given.picture)) {
    further.push_back(std::move(assignment));
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
  for (const std::string& assignment : overrides(limit, true)) {
    apply_override(preset, assignment);
  }
  return preset;
}

SequenceJob job_of(const Given& given) {
  SequenceJob job;
  job.scene_options = given.scene;
  job.picture = given.picture;
  job.overwrite = given.overwrite;
  job.quiet = given.quiet;
  job.json = given.json;
  if (!given.exr && !given.png) {
    throw InputError("sequence: no files to write; give a pattern such as -o 'sky.####.exr' or --png 'sky.####.png'");
  }
  if (given.exr) {
    job.exr = sequence::require_pattern(*given.exr, ".exr", "sequence: -o");
  }
  if (given.png) {
    job.png = sequence::require_pattern(*given.png, ".png", "sequence: --png");
  }
  job.shard = sequence::parse_shard(given.shard, "sequence: --shard");
  job.preset = preset_of(given);
  job.scene = resolve(job.preset, method_infos());
  require_layers(given.picture, job.scene, given.exr.has_value(), "sequence");
  job.source = source_of(given, job.scene);
  refuse_idle_overrides(given, job.source);
  std::get<PresetObject>(job.preset.root.data).erase("sequence");
  job.scene.sequence.reset();
  job.manifest = given.manifest ? sequence::manifest_file(*given.manifest, job.shard)
                                : sequence::manifest_file(job.exr ? *job.exr : *job.png, job.shard);
  const std::size_t frames = sequence::frame_count(job.source);
  if (frames > kManyFrames && !given.yes) {
    throw InputError("sequence: " + std::to_string(frames) +
                     " frames; more than a million are most often a slip in the step: say --yes to mean it");
  }
  return job;
}

// Everything that can be known to fail is said before anything is rendered.
void check_targets(const SequenceJob& job, const SequencePictures& pictures) {
  const FrameFiles files = files_of(job, sequence::frame_number(job.source, 0));
  for (const std::string& file : {files.exr, files.png, job.manifest}) {
    if (!file.empty()) {
      require_writable(file);
    }
  }
  check_pictures(pictures, job);
}

// Frame by frame, as it would be rendered.
int dry_run(const SequenceJob& job) {
  const std::size_t frames = sequence::shard_size(job.shard, sequence::frame_count(job.source));
  for (std::size_t k = 0; k < frames; ++k) {
    const sequence::Frame frame = sequence::frame_at(job.source, sequence::shard_frame(job.shard, k));
    std::string line = files_of(job, frame.number).first();
    if (frame.time) {
      line += "  " + sequence::iso_text(frame.time->utc, frame.time->offset_seconds);
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

int run(const Given& given) {
  const SequenceJob job = job_of(given);
  if (given.dry_run) {
    return dry_run(job);
  }
  check_targets(job, given.pictures);
  const SequenceOutcome outcome = run_sequence(job);
  if (outcome.signal != 0) {
    return 128 + outcome.signal;  // as a shell says it
  }
  make_pictures(given.pictures, job);
  return 0;
}

std::vector<Option> frame_options(Given& given) {
  const Range elevation_range{-0.5, 100.0};
  return {{"--date", "YYYY-MM-DD", "The day of a sun path, 1600 to 2400 by the Gregorian calendar", &given.date},
          {"--from", "HH:MM", "The first frame's time of day, on the clocks of --tz", &given.from},
          {"--to", "HH:MM", "The last frame's, if the step meets it; earlier than --from: on the next day", &given.to},
          {"--step", "TIME", "From frame to frame: a number with h, m or s, e.g. 5m or 1h30m", &given.step},
          {"--lat", "DEG", "The place's latitude, north positive", &given.latitude},
          {"--lon", "DEG", "The place's longitude, east positive", &given.longitude},
          {"--tz", "ZONE", "The clocks: a time zone such as Europe/Paris, or an offset such as +02:00; else UTC",
           &given.zone},
          {"--place-altitude", "KM", "The place's height above the sea, for the sun's parallax; the camera has its own",
           &given.place_altitude, Completes::nothing, elevation_range},
          {"--refraction", "",
           "Lift the sun as the air's refraction does (Saemundsson 1986); else its true elevation is used",
           &given.refraction},
          {"--pressure", "HPA", "For --refraction; else 1010", &given.pressure, Completes::nothing, Range{0.0, 2000.0}},
          {"--temperature", "CELSIUS", "For --refraction; else 10", &given.temperature, Completes::nothing,
           Range{-200.0, 200.0}},
          {"--sun-elevation", "FROM:TO:STEP", "Instead of a path: sweep the sun's elevation, in degrees, e.g. -12:90:1",
           &given.sweep},
          {"--sun-azimuth", "DEG", "The sun's azimuth in a sweep; short for --set /sun/azimuth_deg=DEG",
           &given.scene.sun_azimuth}};
}

std::vector<Option> run_options(Given& given) {
  return {{"--overwrite", "", "Render frames anew that are there, whole and of this very preset", &given.overwrite},
          {"--shard", "I/N", "Render every N-th frame from the I-th on, as one of N machines does, e.g. 3/16",
           &given.shard},
          {"--manifest", "FILE.json", "Where the list of frames goes; else beside them, as NAME.manifest.json",
           &given.manifest, Completes::file},
          {"--preview", "FILE", "Make a film of the frames, .mp4 or .gif; needs ffmpeg", &given.pictures.preview,
           Completes::file},
          {"--preview-rate", "N", "The film's frames a second; else 24", &given.pictures.frames_a_second,
           Completes::nothing, Range{1.0, 1000.0}},
          {"--contact-sheet", "FILE.png", "Make a sheet of small pictures, at most 60, evenly spread",
           &given.pictures.contact_sheet, Completes::file},
          {"--yes", "", "More than a million frames are meant", &given.yes},
          {"--dry-run", "", "List the frames; open no device, write nothing", &given.dry_run},
          {"--json", "", "Print one JSON object a frame on standard output, and one at the end", &given.json},
          {"-q,--quiet", "", "Say nothing but errors", &given.quiet}};
}

std::vector<Option> sequence_options(Given& given) {
  std::vector<Option> options = {
      {"-o,--output", "PATTERN.exr", "Write the frames here, # for their numbers: sky.####.exr", &given.exr,
       Completes::file},
      {"--png", "PATTERN.png", "Write pictures for people here, e.g. sky.####.png", &given.png, Completes::file},
      size_option(given.scene)};
  const auto append = [&](std::vector<Option> more, const std::vector<std::string>& left_out) {
    for (Option& option : more) {
      if (std::find(left_out.begin(), left_out.end(), option.names) == left_out.end()) {
        options.push_back(std::move(option));
      }
    }
  };
  append(frame_options(given), {});
  append(scene_options(given.scene), {"--sun-elevation", "--sun-azimuth"});
  append(sampling_options(given.sampling), {"--checkpoint", "--time-limit"});
  // Unlike render's: one choice of method and quality would have to hold for all frames.
  append({{"--time-limit", "TIME", "Of a method that samples: stop sampling a frame after so long, e.g. 50ms, 2s, 1min",
           &given.sampling.time_limit}},
         {});
  append(picture_options(given.picture), {});
  append(run_options(given), {});
  return options;
}

}  // namespace

Command sequence_command() {
  const auto given = std::make_shared<Given>();
  Command command;
  command.name = "sequence";
  command.summary = "Render a day, a sweep of the sun or key frames to numbered files";
  command.description =
      "What changes from frame to frame is one of three: the sun's path over a place (--date, --from, --to, --step, "
      "--lat, --lon), a sweep of its elevation, or the preset's own key frames (the key sequence). The path is that of "
      "the sun's centre, good to 0.01 degrees, without refraction unless --refraction asks for it.\n\n"
      "A run may be stopped and given again: frames that are whole and carry the hash of their preset are kept. Every "
      "file appears whole or not at all, whatever ends the run. Ctrl-C finishes the frame in hand (exit code 130); "
      "twice, it drops it.\n\n"
      "The manifest lists frames, times, sun angles, files, hashes and milliseconds as JSON. Many machines share a "
      "sequence by --shard; scripts/slurm-sequence submits it to Slurm.";
  command.examples = {
      {"airlight sequence earth-noon -o 'day.####.exr' --date 2026-06-21 --from 06:00 --to 18:00 --step 6h --lat 48.85 "
       "--lon 2.35 --tz Europe/Paris --size 64x36",
       "Three skies over Paris"},
      {"airlight sequence earth-noon --png 'sweep.##.png' --sun-elevation -6:6:6 --size 64x36",
       "The sun from 6 degrees below the horizon to 6 above"},
      {"airlight sequence earth-noon -o 'day.####.exr' --date 2026-06-21 --from 00:00 --to 24:00 --step 1m --lat 69.65 "
       "--lon 18.96 --tz Europe/Oslo --dry-run",
       "List the frames of a day that knows no night"}};
  command.positionals = {preset_positional(given->scene)};
  command.options = sequence_options(*given);
  command.run = [given] { return run(*given); };
  return command;
}

}  // namespace airlight::cli
