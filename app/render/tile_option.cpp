#include "app/render/tile_option.h"

#include <algorithm>

#include "app/cli/scene_options.h"
#include "core/base/error.h"

namespace airlight::cli {
namespace {

ImageSize tile_from(const std::string& text, const Stage& stage, LayerSet layers, const std::string& option) {
  const ImageSize& image = stage.scene().image;
  const std::optional<ImageSize> typed = size_from(text);
  if (!typed || typed->width < 1 || typed->height < 1) {
    throw InputError(option + ": '" + text + "' is no size; write WIDTHxHEIGHT in pixels, for example 2048x1024");
  }
  const ImageSize tile{std::min(typed->width, image.width), std::min(typed->height, image.height)};
  const std::size_t most = kTileBytes / tile_pixel_bytes(stage, layers);
  if (static_cast<std::size_t>(tile.width) * static_cast<std::size_t>(tile.height) > most) {
    throw InputError(option + ": '" + text + "' is too large for the buffers of a device; a tile of this picture" +
                     (layers != LayerSet::none ? " with layers" : "") + " has at most " + std::to_string(most) +
                     " pixels");
  }
  return tile;
}

}  // namespace

std::optional<ImageSize> tile_for(const std::optional<std::string>& option, const Stage& stage, LayerSet layers,
                                  const std::string& command) {
  if (option) {
    return tile_from(*option, stage, layers, command + ": --tile");
  }
  const ImageSize& image = stage.scene().image;
  const std::size_t pixels = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
  return pixels > kMostUntiledPixels ? std::optional(usual_tile(stage, layers)) : std::nullopt;
}

}  // namespace airlight::cli
