#include "app/sequence/radiance_matrix.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "app/cli/interruption.h"
#include "app/cli/progress.h"
#include "app/cli/terminal.h"
#include "app/render/radiance_files.h"
#include "core/error.h"
#include "core/methods/ready.h"
#include "core/output/atomic_file.h"
#include "core/output/ending.h"
#include "core/output/last_words.h"
#include "core/render/lighting.h"
#include "core/render/sky_patches.h"
#include "core/scene/angle.h"
#include "core/scene/photometry.h"
#include "core/text.h"

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

Column column_of(const SkyPatches& patches, const MatrixOrder& order, const DeviceOnDemand& device,
                 const Stage& stage) {
  HostOptions host;
  host.report = [](double) { return Interruption::signal() == 0; };
  const RadianceImage sky = whole_sky(device, stage, host, sky_size(order.factor)).radiance;
  Column column = patches.means(sky);
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
  const SkyPatches patches(order.factor);
  const std::size_t count = sequence::frame_count(job.source);
  const std::function<bool(double)> progress = job.quiet ? nullptr : terminal_progress();
  std::unique_ptr<Executor> executor;
  const DeviceOnDemand device = device_on_demand(job.scene_options, executor);
  std::vector<Column> columns;
  std::size_t dark = 0;
  Stage stage = *job.stage;
  while (columns.size() < count && Interruption::signal() == 0) {
    const Scene scene = scene_of(job, sequence::frame_at(job.source, columns.size()));
    if (is_dark(scene)) {
      ++dark;
      columns.emplace_back(patches.count());
    } else {
      stage = ready(scene, stage);
      columns.push_back(column_of(patches, order, device, stage));
    }
    if (progress) {
      progress(static_cast<double>(columns.size()) / static_cast<double>(count));
    }
  }
  clear_progress();
  if (const int signal = Interruption::signal(); signal != 0) {
    complain(std::string("stopped by ") + signal_name(signal) + ": no matrix was written");
    return signal;
  }
  require_valid_vulkan();
  write_text(order.file, head_of(job, patches.count(), count), columns);
  if (!job.quiet) {
    tell(order.file + ": " + std::to_string(patches.count()) + " patches by " + std::to_string(count) + " moments, " +
         std::to_string(dark) + " of them dark\n");
  }
  return 0;
}

}  // namespace airlight::cli
