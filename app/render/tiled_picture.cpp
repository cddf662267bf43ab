#include "app/render/tiled_picture.h"

#include <memory>

#include "core/clock.h"
#include "core/error.h"
#include "core/output/atomic_file.h"
#include "core/output/half_block.h"

namespace airlight::cli {
namespace {

ImageSize tile_from(const std::string& text, const Stage& stage, bool layers, const std::string& option) {
  const ImageSize& image = stage.scene().image;
  const std::optional<ImageSize> typed = size_from(text);
  if (!typed || typed->width < 1 || typed->height < 1) {
    throw InputError(option + ": '" + text + "' is no size; write WIDTHxHEIGHT in pixels, for example 2048x1024");
  }
  const ImageSize tile{std::min(typed->width, image.width), std::min(typed->height, image.height)};
  const std::size_t most = kTileBytes / tile_pixel_bytes(stage, layers);
  if (static_cast<std::size_t>(tile.width) * static_cast<std::size_t>(tile.height) > most) {
    throw InputError(option + ": '" + text + "' is too large for the buffers of a device; a tile of this picture" +
                     (layers ? " with layers" : "") + " has at most " + std::to_string(most) + " pixels");
  }
  return tile;
}

// The files of a part, while they are being written.
class PartFiles {
 public:
  PartFiles(const TiledPart& part, const TiledOrder& order) : part_(part), order_(order) {
    if (!part.files.exr.empty()) {
      exr_file_ = std::make_unique<FileInProgress>(part.files.exr);
    }
    if (!part.files.png.empty()) {
      png_file_ = std::make_unique<FileInProgress>(part.files.png, FileInProgress::Order::onward);
    }
  }

  // Writes the part's share of the band's rows.
  void add(const Band& band) {
    const int first = std::max(part_.first_row, band.y);
    const int end = std::min(part_.first_row + part_.scene.image.height, band.y + band.rows.radiance.height);
    if (first >= end) {
      return;
    }
    if (end - first == band.rows.radiance.height) {
      add_rows(band.rows);
    } else {
      add_rows(rows_of(band.rows, first - band.y, end - first));
    }
  }

  ExrCounts finish_exr(double exposure) {
    ExrCounts counts;
    if (exr_) {
      const Clock::time_point start = Clock::now();
      counts = exr_->finish({{kExposureKey, static_cast<float>(exposure)}});
      exr_file_->commit();
      exr_ms_ += milliseconds_since(start);
    }
    return counts;
  }
  void finish_png() {
    if (png_) {
      const Clock::time_point start = Clock::now();
      png_->finish();
      png_file_->commit();
      png_ms_ += milliseconds_since(start);
    }
  }
  double exr_ms() const { return exr_ms_; }
  double png_ms() const { return png_ms_; }

 private:
  void add_rows(const Rendering& rows) {
    const PictureContext context = order_.context(part_.scene, rows);
    if (exr_file_) {
      const Clock::time_point start = Clock::now();
      add_exr(context);
      exr_ms_ += milliseconds_since(start);
    }
    if (png_file_) {
      const Clock::time_point start = Clock::now();
      if (!png_) {
        const auto sink = [this](std::span<const std::byte> bytes) {
          png_file_->write(png_bytes_, bytes);
          png_bytes_ += bytes.size();
        };
        png_ = std::make_unique<PicturePng>(sink, context, order_.transform, order_.bits);
      }
      png_->add(rows);
      png_ms_ += milliseconds_since(start);
    }
  }

  void add_exr(const PictureContext& context) {
    const PictureChannels channels(context);
    const ImageSize& size = part_.scene.image;
    if (!exr_) {
      const ExrSink sink = [this](std::uint64_t position, std::span<const std::byte> bytes) {
        exr_file_->write(position, bytes);
      };
      exr_ =
          std::make_unique<ExrRows>(sink, size.width, size.height, channels.list(), exr_options(context, order_.half));
    }
    exr_->add(context.rendering.radiance.height, channels.list());
  }

  const TiledPart& part_;
  const TiledOrder& order_;
  std::unique_ptr<FileInProgress> exr_file_, png_file_;
  std::unique_ptr<ExrRows> exr_;
  std::unique_ptr<PicturePng> png_;
  std::uint64_t png_bytes_ = 0;
  double exr_ms_ = 0.0;
  double png_ms_ = 0.0;
};

using AllFiles = std::vector<std::unique_ptr<PartFiles>>;

// Returns if the picture is sound, else throws.
void require_sound_parts(const Scene& scene, const Rendering& rendering, const TiledOrder& order,
                         const AllFiles& files) {
  if (rendering.fault().empty()) {
    return;
  }
  refuse(scene, rendering, order.source, order.parts.front().files.png, [&] {
    for (const auto& file : files) {
      file->finish_png();
    }
  });
}

// Finishes both files of all parts, the EXRs first.
void finish(TiledPicture& done, const TiledOrder& order, const AllFiles& files) {
  double exr_ms = 0.0;
  double png_ms = 0.0;
  for (std::size_t i = 0; i < files.size(); ++i) {
    add_counts(done.counts, files[i]->finish_exr(done.rendering.exposure));
    files[i]->finish_png();
    const std::vector<std::string> written = order.parts[i].files.files();
    done.files.insert(done.files.end(), written.begin(), written.end());
    exr_ms += files[i]->exr_ms();
    png_ms += files[i]->png_ms();
  }
  if (exr_ms > 0.0) {
    done.rendering.host.push_back({"EXR, encoding and writing", exr_ms});
  }
  if (png_ms > 0.0) {
    done.rendering.host.push_back({"PNG, display transform, encoding and writing", png_ms});
  }
}

}  // namespace

std::optional<ImageSize> tile_for(const std::optional<std::string>& option, const Stage& stage, bool layers,
                                  const std::string& command) {
  if (option) {
    return tile_from(*option, stage, layers, command + ": --tile");
  }
  const ImageSize& image = stage.scene().image;
  const std::size_t pixels = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
  return pixels > kMostUntiledPixels ? std::optional(usual_tile(stage, layers)) : std::nullopt;
}

TiledPicture write_tiled(const DeviceOnDemand& device, const Stage& stage, const TiledOrder& order) {
  const Scene& scene = stage.scene();
  if (needs_whole_picture(scene, order.request)) {
    throw InputError(order.source +
                     ": /bloom/model: a chain is made of the whole picture, and this one is rendered in tiles; set "
                     "/bloom/model to \"glare\", or /bloom/enabled to false");
  }
  AllFiles files;
  bool shown = false;
  for (const TiledPart& part : order.parts) {
    files.push_back(std::make_unique<PartFiles>(part, order));
    shown = shown || !part.files.png.empty();
  }
  const bool diagnostic = scene.display.view == kDiagnosticView;
  TiledRequest request{.tile = order.tile,
                       .picture = order.request,
                       .exposure_first = shown && !diagnostic,
                       .past_faults = shown && diagnostic,
                       .sink = {},
                       .report = order.report};
  request.sink = [&](const Band& band) {
    for (const auto& file : files) {
      file->add(band);
    }
  };
  TiledPicture done{render_tiled(device, stage, request), {}, {}};
  if (order.dropped && order.dropped()) {
    return done;
  }
  require_sound_parts(scene, done.rendering, order, files);
  finish(done, order, files);
  if (order.request.layers) {
    done.rendering.layers = layers_of(stage);
  }
  return done;
}

}  // namespace airlight::cli
