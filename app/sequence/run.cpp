#include "app/sequence/run.h"

#include <algorithm>
#include <memory>
#include <mutex>

#include "app/cli/frame_scene.h"
#include "app/cli/interruption.h"
#include "app/cli/terminal.h"
#include "app/render/publish.h"
#include "app/render/report.h"
#include "app/render/tile_option.h"
#include "app/sequence/leftovers.h"
#include "app/sequence/manifest.h"
#include "app/sequence/report.h"
#include "core/base/clock.h"
#include "core/base/error.h"
#include "core/library/validity.h"
#include "core/methods/method.h"
#include "core/methods/ready.h"
#include "core/output/atomic_file.h"
#include "core/output/last_words.h"
#include "core/scene/angle.h"
#include "core/scene/json_format.h"
#include "core/sequence/bounded_workers.h"

namespace airlight::cli {
namespace {

// Encoding spreads over the cores within a frame; a second thread fills the gaps of writing and syncing.
constexpr unsigned kEncoders = 2;

// Kinds of warnings, in words for the last line with their frames' number.
constexpr const char* kUnclaimed = "are outside what their method claims to hold for";
constexpr const char* kBounded = "are rendered with fewer orders of scattering than asked for";
constexpr const char* kUndone = "lack light that would have taken for ever to find";
constexpr const char* kLossy = "have samples that half floats do not hold";

// Number of frames that wait to be encoded. One is enough to even out differences between frames. Frames so large that
// they would fill the memory do not wait, and only one is in work.
struct Room {
  unsigned threads = kEncoders;
  std::size_t waiting = 1;
};

Room room_for(const ImageSize& image, bool layers) {
  const double kLargePixels = layers ? 6e6 : 32e6;  // 512 MB of floats
  const double pixels = static_cast<double>(image.width) * static_cast<double>(image.height);
  return pixels > kLargePixels ? Room{1, 0} : Room{};
}

// A frame on its way: inputs of the encoder and of the report.
struct Work {
  std::size_t k = 0;  // in the shard
  Scene scene;
  Rendering rendering;          // without pixels
  std::optional<Band> picture;  // which its writer has not got yet
  std::optional<PictureWriter> writer;
  std::string preset_json;
  FrameHashes hashes;
  FrameAttributes attributes;
  FrameReport report;
};

class Runner {
 public:
  explicit Runner(const SequenceJob& job)
      : job_(job),
        stage_(*job_.stage),
        report_(job_),
        manifest_(job_),
        transform_(job.png ? display_transform(job.picture, job.scene) : std::nullopt),
        display_(transform_ ? transform_->config() + ", " + transform_->display() + ", " + transform_->view() : "") {
    if (transform_ && !transform_->warning().empty() && !job.quiet) {
      complain("warning: " + transform_->warning());
    }
    if (const std::string warning = latlong_warning(job.scene); job.exr && !job.quiet && !warning.empty()) {
      complain("warning: " + warning);
    }
  }

  SequenceOutcome run();

 private:
  void hold_exposure();
  void render_all();
  bool render_frame(std::size_t k, sequence::BoundedWorkers& encoders);
  bool render_into(Work& work);
  PictureContext context_of(const Work& work, const Scene& scene, const Rendering& rendering) const;
  void encode(Work& work);
  void finished(std::size_t k, const Scene& scene, const FrameReport& report);
  std::string whole_so_far() const;

  SequenceJob job_;
  Stage stage_;  // of the last frame, from which the next takes over what is equal
  SequenceReport report_;
  SequenceManifest manifest_;
  std::mutex manifest_mutex_;
  std::optional<DisplayTransform> transform_;
  std::string display_;  // config, display and view of the PNGs, from options or preset
  std::unique_ptr<Executor> executor_;
};

void Runner::finished(std::size_t k, const Scene& scene, const FrameReport& report) {
  {
    const std::lock_guard lock(manifest_mutex_);
    manifest_.add(k, report.hash, scene, report.rendered ? report.render_ms + report.encode_ms : -1.0);
    manifest_.write_now_and_then();
  }
  report_.frame(report);
}

PictureContext Runner::context_of(const Work& work, const Scene& scene, const Rendering& rendering) const {
  const std::string device = executor_ ? executor_->device().name : "the processor";
  return {.scene = scene,
          .rendering = rendering,
          .provenance = {work.preset_json, work.scene.render.method, AIRLIGHT_VERSION, device},
          .exr_hash = work.hashes.exr,
          .png_hash = work.hashes.png,
          .space = working_space_of(job_.picture),
          .frame = work.attributes};
}

// Encodes what the frame's files do not have yet, and lets them appear.
void Runner::encode(Work& work) {
  const Clock::time_point start = Clock::now();
  if (work.picture) {
    work.writer->add(*work.picture);
  }
  Stopwatch laps;
  const Published done = work.writer->publish(work.rendering, laps);
  if (!done.depth.why.empty()) {
    report_.took_floats(work.report.number, done.depth.why);
  }
  report_.warn(work.report.number, kLossy, done.exr ? exr_warnings(*done.exr) : std::vector<std::string>());
  FrameReport report = work.report;
  report.encode_ms = milliseconds_since(start);
  finished(work.k, work.scene, report);
}

// Renders a frame, in tiles into its files, else for encode(). False when a signal has cut it short: it is dropped.
bool Runner::render_into(Work& work) {
  const Clock::time_point start = Clock::now();
  const DeviceOnDemand device = device_on_demand(job_.scene_options, executor_);
  const std::optional<ImageSize> tile = tile_for(job_.tile, stage_, layer_set(job_.picture), "sequence");
  const Targets& files = work.report.files;
  work.writer.emplace(PublishOrder{
      .parts = {{work.scene, 0, files}},
      .transform = transform_,
      .options = job_.picture,
      .depth = tile ? depth_in_tiles(job_.picture, files, device, stage_) : std::nullopt,
      .source = "frame " + std::to_string(work.report.number),
      .context = [this, &work](const Scene& scene, const Rendering& rows) { return context_of(work, scene, rows); }});
  RenderRequest request = request_for(work.scene, job_.exr.has_value(), job_.png.has_value());
  request.layers = layer_set(job_.picture);
  request.host.report = [](double) { return Interruption::signal() == 0; };
  BandsRequest bands = work.writer->bands(tile, request);
  if (!tile) {
    bands.sink = [&work](Band& picture) { work.picture = std::move(picture); };
  }
  const auto is_cut = [&work] { return samples(work.scene) && Interruption::signal() != 0; };
  try {
    work.rendering = render_bands(device, stage_, bands);
  } catch (const RunError&) {
    if (is_cut()) {
      return false;  // too early for a picture
    }
    throw;
  }
  require_valid_vulkan();
  if (is_cut()) {
    return false;
  }
  report_.warn(work.report.number, kUndone, work.rendering.undone);
  work.report.rendered = true;
  work.report.render_ms = milliseconds_since(start);
  return true;
}

// False when a signal has cut the frame short: it is dropped.
bool Runner::render_frame(std::size_t k, sequence::BoundedWorkers& encoders) {
  const sequence::Frame frame = sequence::frame_at(job_.source, sequence::shard_frame(job_.shard, k));
  auto work = std::make_shared<Work>();
  work->k = k;
  work->scene = scene_of(job_, frame);
  const Scene& scene = work->scene;
  work->preset_json = to_json(scene);
  FrameReport& report = work->report;
  report.number = frame.number;
  report.time = frame.time;
  report.elevation_deg = degrees_from_radians(scene.sun.elevation);
  report.azimuth_deg = degrees_from_radians(scene.sun.azimuth);
  report.files = files_of(job_, frame.number);
  work->attributes = attributes_of(job_, frame);
  work->hashes = hashes_of(job_.picture, display_, work->preset_json, work->attributes);
  report.hash = job_.exr ? work->hashes.exr : work->hashes.png;
  if (!job_.overwrite && is_done(report.files, work->hashes, work->preset_json)) {
    finished(k, scene, report);
    return true;
  }
  stage_ = ready(scene, stage_);
  if (std::string warning = validity_warning(stage_); !warning.empty()) {
    report_.warn(frame.number, kUnclaimed, {std::move(warning)});
  } else if (std::string failure = known_failure_warning(stage_); !failure.empty()) {
    report_.warn(frame.number, kUnclaimed, {std::move(failure)});
  }
  report_.warn(frame.number, kBounded, bound_warnings(stage_));
  if (!render_into(*work)) {
    return false;
  }
  encoders.add([this, work] { encode(*work); });
  return true;
}

// Makes a day's or a frame's exposure the preset's own, so that every frame, and its hash, has the number.
void Runner::hold_exposure() {
  const std::optional<double> held = held_exposure(device_on_demand(job_.scene_options, executor_), stage_,
                                                   [&] { return scene_of(job_, locked_frame(job_)); });
  if (held) {
    apply_override(job_.preset, "/display/exposure=" + format_number(*held));
    job_.scene.display.exposure = held;
  }
}

void Runner::render_all() {
  const std::size_t frames = sequence::shard_size(job_.shard, sequence::frame_count(job_.source));
  const Room room = room_for(job_.scene.image, layer_set(job_.picture) != LayerSet::none);
  sequence::BoundedWorkers encoders(room.threads, room.waiting);
  for (std::size_t k = 0; k < frames && Interruption::signal() == 0; ++k) {
    if (!render_frame(k, encoders)) {
      break;
    }
  }
  encoders.finish();
}

std::string Runner::whole_so_far() const {
  const SequenceTotals totals = report_.totals();
  return std::to_string(totals.rendered + totals.kept) + " of " + std::to_string(totals.frames) +
         " frames are whole; the same command goes on from there";
}

SequenceOutcome Runner::run() {
  const Interruption interruption;
  remove_half_written(job_);
  try {
    hold_exposure();
    render_all();
  } catch (const RunError& error) {
    report_.end("");
    try {
      manifest_.write();
    } catch (const RunError&) {  // the disk is already full: the first error is reported
    }
    throw RunError(std::string(error.what()) + "; " + whole_so_far());
  }
  manifest_.write();
  const int signal = Interruption::signal();
  const SequenceTotals totals = report_.totals();
  const bool complete = totals.rendered + totals.kept == totals.frames;
  report_.end(complete ? "" : signal_name(signal));
  if (complete) {
    tidy_frames_beyond(job_);
  }
  if (!complete) {
    complain(std::string("stopped by ") + signal_name(signal) + ": " + whole_so_far());
  }
  return {signal, complete};
}

}  // namespace

SequenceOutcome run_sequence(const SequenceJob& job) {
  return Runner(job).run();
}

}  // namespace airlight::cli
