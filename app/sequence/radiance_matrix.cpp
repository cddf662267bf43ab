#include "app/sequence/radiance_matrix.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <memory>
#include <mutex>
#include <thread>

#include "app/cli/interruption.h"
#include "app/cli/progress.h"
#include "app/cli/terminal.h"
#include "app/render/radiance_files.h"
#include "core/base/error.h"
#include "core/base/in_parallel.h"
#include "core/base/text.h"
#include "core/methods/ready.h"
#include "core/output/atomic_file.h"
#include "core/output/ending.h"
#include "core/output/last_words.h"
#include "core/render/lighting.h"
#include "core/render/sky_patches.h"
#include "core/scene/angle.h"
#include "core/scene/photometry.h"

namespace airlight::cli {
namespace {

constexpr const char* kOption = "sequence: --radiance-matrix";
constexpr double kDarkDegrees = -18.0;

using Column = std::vector<Vector3>;

// The whole sky's size: 1.9 degrees a pixel, finer where patches are.
ImageSize sky_size(int factor) {
  const int rows = factor <= 2 ? 96 : 60 * factor;
  return {2 * rows, rows};
}

bool is_dark(const Scene& scene) {
  return degrees_from_radians(scene.sun.elevation) < kDarkDegrees && !scene.moon && !scene.night_sky && !scene.stars;
}

void add_disc(const SkyPatches& patches, const SunLight& light, Column& column) {
  for (const SkyPatches::Share& part : patches.around(light.elevation, light.azimuth)) {
    for (std::size_t c = 0; c < 3; ++c) {
      column[part.patch][c] += light.irradiance[c] * part.share / patches.solid_angle(part.patch);
    }
  }
}

Column column_of(const SkyPatches& patches, const PatchMeans& means, ImageSize size, const DeviceOnDemand& device,
                 const Stage& stage) {
  HostOptions host;
  host.report = [](double) { return Interruption::signal() == 0; };
  const RadianceImage sky = whole_sky(device, stage, host, size).radiance;
  Column column = means.of(sky);
  add_disc(patches, sun_light(device, stage), column);
  for (const Stage& other : stage.others()) {
    add_disc(patches, sun_light(device, other), column);
  }
  const double luminance = luminance_of_one(stage.scene());
  for (Vector3& colour : column) {
    colour = radiance_colour(colour, luminance);
  }
  return column;
}

std::string head_of(const SequenceJob& job, std::size_t rows, std::size_t columns) {
  const sequence::Place& place = std::get<sequence::SunPath>(job.source).place;
  return "#?RADIANCE\nairlight sequence " + job.scene_options.preset + " --radiance-matrix\nSOFTWARE= airlight " +
         AIRLIGHT_VERSION + "\nLATLONG= " + rounded(place.latitude_deg, 8) + " " + rounded(place.longitude_deg, 8) +
         "\nNROWS=" + std::to_string(rows) + "\nNCOLS=" + std::to_string(columns) + "\nNCOMP=3\nFORMAT=ascii\n\n";
}

// The text row by row, each with an empty line after it.
void write_text(const std::string& file, const std::string& head, const std::vector<Column>& columns) {
  std::string piece;
  std::size_t row = 0;
  const std::size_t rows = columns.front().size();
  bool begun = false;
  write_file(file, [&]() -> std::span<const std::byte> {
    piece.clear();
    if (!begun) {
      begun = true;
      piece = head;
    } else if (row < rows) {
      for (const Column& column : columns) {
        const Vector3& c = column[row];
        piece += rounded(c[0], 5) + " " + rounded(c[1], 5) + " " + rounded(c[2], 5) + "\n";
      }
      piece += "\n";
      ++row;
    }
    return std::as_bytes(std::span(piece));
  });
}

// The matrix's columns, found by a few threads, each with a device of its own, so that the host's work for one moment
// is done beside the passes of another.
class Moments {
 public:
  Moments(const SequenceJob& job, int factor)
      : job_(job),
        patches_(factor),
        size_(sky_size(factor)),
        means_(patches_, size_.width, size_.height),
        columns_(sequence::frame_count(job.source)) {
    if (!job.quiet) {
      progress_ = terminal_progress();
    }
  }

  // Leaves columns empty once a signal has come. Throws what a moment threw.
  void find() {
    Thread first(job_, *job_.stage);
    add_next(first);  // alone: it stores tables and the device's code, which the others find
    const Stage begun = first.stage;
    const std::size_t threads = std::clamp<std::size_t>(std::thread::hardware_concurrency(), 1, kMostThreads);
    in_parallel(std::min(threads, columns_.size()), [&](std::size_t i) {
      if (i == 0) {
        add_rest(first);
      } else {
        Thread other(job_, begun);
        add_rest(other);
      }
    });
    clear_progress();
  }

  const SkyPatches& patches() const { return patches_; }
  const std::vector<Column>& columns() const { return columns_; }
  std::size_t dark() const { return dark_; }

 private:
  static constexpr std::size_t kMostThreads = 4;  // each takes some 100 MB

  struct Thread {
    Thread(const SequenceJob& job, Stage like)
        : device(device_on_demand(job.scene_options, executor)), stage(std::move(like)) {}
    std::unique_ptr<Executor> executor;
    DeviceOnDemand device;
    Stage stage;  // of its last moment, from which the next one takes over what is equal
  };

  void add_rest(Thread& thread) {
    try {
      while (add_next(thread)) {
      }
    } catch (...) {
      next_ = columns_.size();  // the other threads end too
      throw;
    }
  }

  // False: none is left, or a signal came.
  bool add_next(Thread& thread) {
    const std::size_t moment = next_++;
    if (moment >= columns_.size() || Interruption::signal() != 0) {
      return false;
    }
    const Scene scene = scene_of(job_, sequence::frame_at(job_.source, moment));
    if (is_dark(scene)) {
      ++dark_;
      columns_[moment].resize(patches_.count());
    } else {
      thread.stage = ready(scene, thread.stage);
      columns_[moment] = column_of(patches_, means_, size_, thread.device, thread.stage);
    }
    const std::scoped_lock lock(mutex_);
    ++done_;
    if (progress_) {
      progress_(static_cast<double>(done_) / static_cast<double>(columns_.size()));
    }
    return true;
  }

  const SequenceJob& job_;
  const SkyPatches patches_;
  const ImageSize size_;
  const PatchMeans means_;
  std::vector<Column> columns_;
  std::atomic<std::size_t> next_ = 0;
  std::atomic<std::size_t> dark_ = 0;
  std::mutex mutex_;
  std::size_t done_ = 0;
  std::function<bool(double)> progress_;
};

}  // namespace

void check_matrix(const MatrixOrder& order, const SequenceJob& job) {
  require_ending(order.file, kOption, ".mtx");
  if (!std::holds_alternative<sequence::SunPath>(job.source)) {
    throw InputError(std::string(kOption) +
                     ": its columns are moments of a place; give --date, --from, --to, --step, --lat and --lon");
  }
  const std::size_t values = SkyPatches(order.factor).count() * sequence::frame_count(job.source);
  if (values > kMostMatrixValues) {
    throw InputError(std::string(kOption) + ": " + std::to_string(values) + " values; expected at most " +
                     std::to_string(kMostMatrixValues) +
                     ": make the step longer, the time shorter or --patches smaller");
  }
  require_writable(order.file);
}

int write_matrix(const MatrixOrder& order, const SequenceJob& job) {
  const Interruption interruption;
  Moments moments(job, order.factor);
  moments.find();
  if (const int signal = Interruption::signal(); signal != 0) {
    complain(std::string("stopped by ") + signal_name(signal) + ": no matrix was written");
    return signal;
  }
  require_valid_vulkan();
  const std::vector<Column>& columns = moments.columns();
  write_text(order.file, head_of(job, moments.patches().count(), columns.size()), columns);
  if (!job.quiet) {
    tell(order.file + ": " + std::to_string(moments.patches().count()) + " patches by " +
         std::to_string(columns.size()) + " moments, " + std::to_string(moments.dark()) + " of them dark\n");
  }
  return 0;
}

}  // namespace airlight::cli
