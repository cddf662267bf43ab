#include "app/render/tiled_picture.h"

#include <charconv>
#include <chrono>
#include <memory>
#include <utility>

#include "core/error.h"
#include "core/methods/method.h"
#include "core/output/atomic_file.h"

namespace airlight::cli {
namespace {

// Why the picture must be whole; empty: it need not.
std::string needs_whole(const Scene& scene, const Targets& targets, const std::string& other_reason) {
  if (!other_reason.empty()) {
    return other_reason;
  }
  if (!targets.png.empty()) {
    return "a PNG needs the whole picture, as its bloom and its display transform are fitted to it; write -o FILE.exr "
           "alone";
  }
  if (!targets.tables.empty()) {
    return "--luts reads the tables back with a whole picture; write them by 'airlight luts'";
  }
  if (scene.bloom.enabled && scene.bloom.in_exr) {
    return "bloom needs the whole picture; leave it out by --set /bloom/enabled=false";
  }
  if (find_method(scene.render.method)->add_passes == nullptr) {
    return scene.render.method + " renders the whole picture on the processor; choose another --method";
  }
  return {};
}

std::optional<int> positive(std::string_view text) {
  int value = 0;
  const auto parsed = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = parsed.ec == std::errc() && parsed.ptr == text.data() + text.size();
  return whole && value > 0 ? std::optional(value) : std::nullopt;
}

ImageSize tile_from(const std::string& text, const Scene& scene, bool layers) {
  const std::size_t x = text.find('x');
  const std::optional<int> width = positive(std::string_view(text).substr(0, x));
  const std::optional<int> height =
      x == std::string::npos ? std::nullopt : positive(std::string_view(text).substr(x + 1));
  if (!width || !height) {
    throw InputError("render: --tile: '" + text + "' is no size; write WIDTHxHEIGHT in pixels, for example 2048x1024");
  }
  const ImageSize tile{std::min(*width, scene.image.width), std::min(*height, scene.image.height)};
  const std::size_t most = kTileBytes / tile_pixel_bytes(scene, layers);
  if (static_cast<std::size_t>(tile.width) * static_cast<std::size_t>(tile.height) > most) {
    throw InputError("render: --tile: '" + text + "' is too large for the buffers of a device; a tile of this picture" +
                     (layers ? " with layers" : "") + " has at most " + std::to_string(most) + " pixels");
  }
  return tile;
}

bool is_large(const Scene& scene) {
  return static_cast<std::size_t>(scene.image.width) * static_cast<std::size_t>(scene.image.height) >
         kMostUntiledPixels;
}

}  // namespace

std::optional<ImageSize> tile_for(const std::optional<std::string>& option, const Scene& scene, const Targets& targets,
                                  bool layers, const std::string& other_reason) {
  const std::string reason = needs_whole(scene, targets, other_reason);
  if (!option) {
    return is_large(scene) && reason.empty() ? std::optional(usual_tile(scene, layers)) : std::nullopt;
  }
  if (!reason.empty()) {
    throw InputError("render: --tile: " + reason);
  }
  return tile_from(*option, scene, layers);
}

std::string untiled_warning(const Scene& scene, const Targets& targets, const std::string& other_reason) {
  const std::string reason = needs_whole(scene, targets, other_reason);
  return is_large(scene) && !reason.empty()
             ? "a picture so large is rendered in tiles where it can be, and some devices take it no other way: " +
                   reason
             : std::string();
}

TiledPicture write_tiled(const DeviceOnDemand& device, const Scene& scene, const TiledOrder& order) {
  using Clock = std::chrono::steady_clock;
  FileInProgress file(order.file);
  std::unique_ptr<ExrRows> rows;
  TiledRequest request{.tile = order.tile, .layers = order.layers, .sink = {}, .report = order.report};
  double writing_ms = 0.0;
  request.sink = [&](Band& band) {
    const Clock::time_point start = Clock::now();
    Rendering part;
    part.radiance = std::move(band.radiance);
    part.layers = std::move(band.layers);
    part.left_out = order.left_out;
    part.left_out.insert(part.left_out.end(), band.left_out.begin(), band.left_out.end());
    const PictureContext context{.scene = scene,
                                 .rendering = part,
                                 .provenance = order.provenance,
                                 .choice = order.choice,
                                 .space = order.space};
    const PictureChannels channels(context);
    if (rows == nullptr) {
      const ExrSink sink = [&](std::uint64_t position, std::span<const std::byte> bytes) {
        file.write(position, bytes);
      };
      rows = std::make_unique<ExrRows>(sink, scene.image.width, scene.image.height, channels.list(),
                                       exr_options(context, order.half));
    }
    rows->add(part.radiance.height, channels.list());
    writing_ms += std::chrono::duration<double, std::milli>(Clock::now() - start).count();
  };
  TiledPicture done{render_tiled(device, scene, request), {}};
  const std::string fault = done.rendering.fault();
  if (!fault.empty()) {
    throw RunError(order.source + ": " + fault + "; no picture was written");
  }
  done.counts = rows->finish({{kExposureKey, static_cast<float>(done.rendering.exposure)}});
  file.commit();
  done.rendering.host.push_back({"EXR, encoding and writing", writing_ms});
  done.rendering.left_out.insert(done.rendering.left_out.begin(), order.left_out.begin(), order.left_out.end());
  if (order.layers) {
    done.rendering.layers = layers_of(scene);
  }
  return done;
}

}  // namespace airlight::cli
