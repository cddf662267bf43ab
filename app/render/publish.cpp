#include "app/render/publish.h"

#include <algorithm>
#include <utility>

#include "core/base/clock.h"
#include "core/base/error.h"
#include "core/output/atomic_file.h"
#include "core/output/half_block.h"
#include "core/render/metering.h"

namespace airlight::cli {
namespace {

// Throws the RunError of a rendering at fault. If the PNG shows the fault, as by the diagnostic view, `write_png` is
// called first.
[[noreturn]] void refuse(const Rendering& rendering, const std::string& source, const PicturePart& first,
                         const std::function<void()>& write_png) {
  const std::string what = source + ": " + rendering.fault();
  if (rendering.picture_fault().empty()) {
    throw RunError(what + "; no picture was written");  // in a layer, which no PNG shows
  }
  if (first.scene.display.view != kDiagnosticView || first.files.png.empty()) {
    throw RunError(what + "; no picture was written; --png FILE --view diagnostic shows where");
  }
  write_png();
  throw RunError(what + "; " + first.files.png + " shows where: " + diagnostic_legend());
}

}  // namespace

std::optional<ExrDepth> depth_in_tiles(const PictureOptions& options, const Targets& files,
                                       const DeviceOnDemand& device, const Stage& stage) {
  if (files.exr.empty()) {
    return std::nullopt;
  }
  const bool is_asked = options.full_float || options.half_float;
  return exr_depth(options, is_asked ? Rendering{} : metered_picture(device, stage));
}

// The files of a part, while they are being written.
class PictureWriter::PartFiles {
 public:
  PartFiles(const PicturePart& part, const PublishOrder& order, bool in_tiles) : part_(part), order_(order) {
    using Order = FileInProgress::Order;
    if (!part.files.exr.empty()) {
      exr_file_ = std::make_unique<FileInProgress>(part.files.exr, in_tiles ? Order::any : Order::held);
    }
    if (!part.files.other.empty()) {
      other_file_ = std::make_unique<FileInProgress>(part.files.other, in_tiles ? Order::onward : Order::held);
    }
    if (!part.files.png.empty()) {
      png_file_ = std::make_unique<FileInProgress>(part.files.png, in_tiles ? Order::onward : Order::held);
    }
  }

  // Writes the part's share of the band's rows.
  void add(const Band& band, bool half) {
    const Rendering& rows = band.rows;
    const int first = std::max(part_.first_row, band.y);
    const int end = std::min(part_.first_row + part_.scene.image.height, band.y + rows.radiance.height);
    if (end - first == rows.radiance.height) {
      add_rows(rows, half);
    } else if (first < end) {
      Rendering some;
      static_cast<Pixels&>(some) = rows_of(rows, {0, first - band.y, rows.radiance.width, end - first});
      some.exposure = rows.exposure;
      some.left_out = rows.left_out;
      add_rows(some, half);
    }
  }

  ExrCounts finish_exr(double exposure, const std::optional<Lighting>& lighting) {
    const Rendering no_pixels;
    const PictureContext context = order_.context(part_.scene, no_pixels);
    std::map<std::string, float> numbers{{kExposureKey, static_cast<float>(exposure)}};
    const ExrLight light = lighting ? exr_light(*lighting, context) : ExrLight();
    numbers.insert(light.numbers.begin(), light.numbers.end());
    const ExrCounts counts = exr_->finish(numbers, light.vectors);
    exr_file_->commit();
    return counts;
  }
  std::vector<std::string> finish_other() {
    std::vector<std::string> warnings = other_->finish();
    other_file_->commit();
    return warnings;
  }
  void finish_png() {
    if (png_) {
      png_->finish();
      png_file_->commit();
    }
  }
  const Targets& targets() const { return part_.files; }
  double exr_ms() const { return exr_ms_; }
  double png_ms() const { return png_ms_; }

 private:
  void add_rows(const Rendering& rows, bool half) {
    const PictureContext context = order_.context(part_.scene, rows);
    if (exr_file_) {
      const Clock::time_point start = Clock::now();
      add_exr(context, half);
      exr_ms_ += milliseconds_since(start);
    }
    if (other_file_) {
      add_other(context);
    }
    if (png_file_) {
      const Clock::time_point start = Clock::now();
      add_png(context);
      png_ms_ += milliseconds_since(start);
    }
  }

  void add_exr(const PictureContext& context, bool half) {
    const PictureChannels channels(context);
    const ImageSize& size = part_.scene.image;
    if (!exr_) {
      const ExrSink sink = [this](std::uint64_t position, std::span<const std::byte> bytes) {
        exr_file_->write(position, bytes);
      };
      exr_ = std::make_unique<ExrRows>(sink, size.width, size.height, channels.list(), exr_options(context, half));
    }
    exr_->add(context.rendering.radiance.height, channels.list());
  }

  void add_other(const PictureContext& context) {
    const RadianceImage& rows = context.rendering.radiance;
    if (!other_) {
      const auto sink = [this](std::span<const std::byte> bytes) {
        other_file_->write(other_bytes_, bytes);
        other_bytes_ += bytes.size();
      };
      other_ = picture_rows(part_.files.other, sink, rows.width, part_.scene.image.height, order_.prefilter);
    }
    const bool ours = context.space == WorkingSpace::linear_rec709;
    other_->add(ours ? rows : converted(rows, WorkingSpace::linear_rec709, context.space));
  }

  void add_png(const PictureContext& context) {
    if (!png_) {
      const auto sink = [this](std::span<const std::byte> bytes) {
        png_file_->write(png_bytes_, bytes);
        png_bytes_ += bytes.size();
      };
      png_ = std::make_unique<PicturePng>(sink, context, order_.transform, order_.options.bits);
    }
    png_->add(context.rendering);
  }

  const PicturePart& part_;
  const PublishOrder& order_;
  std::unique_ptr<FileInProgress> exr_file_, png_file_, other_file_;
  std::unique_ptr<ExrRows> exr_;
  std::unique_ptr<PictureRows> other_;
  std::uint64_t other_bytes_ = 0;
  std::unique_ptr<PicturePng> png_;
  std::uint64_t png_bytes_ = 0;
  double exr_ms_ = 0.0;
  double png_ms_ = 0.0;
};

PictureWriter::PictureWriter(PublishOrder order) : order_(std::move(order)) {}
PictureWriter::~PictureWriter() = default;

BandsRequest PictureWriter::bands(const std::optional<ImageSize>& tile, const RenderRequest& request) {
  const PicturePart& first = order_.parts.front();
  if (tile && needs_whole_picture(first.scene, request)) {
    throw InputError(order_.source +
                     ": /bloom/model: a chain is made of the whole picture, and this one is rendered in tiles; set "
                     "/bloom/model to \"glare\", or /bloom/enabled to false");
  }
  in_tiles_ = tile.has_value();
  const bool shown = !first.files.png.empty();
  const bool diagnostic = first.scene.display.view == kDiagnosticView;
  return {.tile = tile,
          .picture = request,
          .exposure_first = shown && !diagnostic,
          .is_last = true,
          .past_faults = shown && diagnostic,
          .sink = [this](const Band& band) { add(band); }};
}

void PictureWriter::add(const Band& band) {
  if (!depth_) {
    const bool is_open = !order_.depth && !order_.parts.front().files.exr.empty();
    depth_ = is_open ? exr_depth(order_.options, band.rows) : order_.depth.value_or(ExrDepth{});
    for (const PicturePart& part : order_.parts) {
      files_.push_back(std::make_unique<PartFiles>(part, order_, in_tiles_));
    }
  }
  for (const auto& file : files_) {
    file->add(band, depth_->half);
  }
}

Published PictureWriter::publish(Rendering& rendering, Stopwatch& watch, const std::optional<Lighting>& lighting) {
  if (!rendering.fault().empty()) {
    refuse(rendering, order_.source, order_.parts.front(), [&] {
      for (const auto& file : files_) {
        file->finish_png();
      }
    });
  }
  Published done{{}, {}, *depth_};
  double exr_ms = 0.0;
  double png_ms = 0.0;
  for (const auto& file : files_) {
    exr_ms += file->exr_ms();
    png_ms += file->png_ms();
    if (!file->targets().exr.empty()) {
      add_counts(done.exr ? *done.exr : done.exr.emplace(), file->finish_exr(rendering.exposure, lighting));
      watch.lap("EXR, writing");
    }
    if (!file->targets().other.empty()) {
      const std::vector<std::string> warnings = file->finish_other();
      done.warnings.insert(done.warnings.end(), warnings.begin(), warnings.end());
      watch.lap("picture, writing");
    }
    if (!file->targets().png.empty()) {
      file->finish_png();
      watch.lap("PNG, writing");
    }
    const std::vector<std::string> written = file->targets().files();
    done.files.insert(done.files.end(), written.begin(), written.end());
  }
  if (done.exr) {
    rendering.host.push_back({"EXR, encoding", exr_ms});
  }
  if (!order_.parts.front().files.png.empty()) {
    rendering.host.push_back({"PNG, transform and encoding", png_ms});
  }
  return done;
}

}  // namespace airlight::cli
