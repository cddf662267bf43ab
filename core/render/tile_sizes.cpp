#include "core/render/tile_sizes.h"

#include <algorithm>
#include <bit>

namespace airlight {
namespace {

constexpr std::size_t kUsualTilePixels = std::size_t{1} << 21;

}  // namespace

std::size_t layer_planes(const Stage& stage, LayerSet layers) {
  const std::size_t others = layers == LayerSet::stokes ? 5 : 3;
  return layers == LayerSet::none ? 0
                                  : 3 * (static_cast<std::size_t>(std::popcount(stage.scattering_media())) + others);
}

std::size_t tile_pixel_bytes(const Stage& stage, LayerSet layers) {
  return sizeof(float) * std::max<std::size_t>(4, layer_planes(stage, layers));
}

std::size_t band_pixel_bytes(const Stage& stage, LayerSet layers) {
  return sizeof(float) * (4 + (layers != LayerSet::none ? layer_planes(stage, layers) + 3 + 1 + 3 : 0));
}

ImageSize usual_tile(const Stage& stage, LayerSet layers) {
  const std::size_t pixels = kUsualTilePixels * 4 * sizeof(float) / band_pixel_bytes(stage, layers);
  const auto rows = static_cast<int>(pixels / static_cast<std::size_t>(stage.scene().image.width));
  return {stage.scene().image.width, std::max(1, rows)};
}

}  // namespace airlight
