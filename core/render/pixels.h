#pragma once
// What a picture, or a band of its rows, holds, and how it is put together from tiles and cut into rows.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/base/radiance_image.h"
#include "core/base/spectral_image.h"
#include "core/render/layers.h"
#include "core/scene/scene.h"

namespace airlight {

struct Pixels {
  RadianceImage radiance;
  std::optional<RadianceImage> standard_error;  // for a method that samples
  std::optional<SpectralImage> spectrum;
  std::optional<RadianceImage> bloom;  // before intensity; absent where nothing glows or it was not asked for
  std::vector<std::uint16_t> encoded;  // gpu_tone: RGBA, sRGB-encoded, 0 to 65535
  std::vector<Layer> layers;
};

inline std::size_t pixels_of(int width, int height) {
  return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
}

inline std::size_t pixels_of(const Tile& tile) {
  return pixels_of(tile.width, tile.height);
}

// Copies rows of a tile to their columns of the band.
void put(RadianceImage& band, std::span<const std::byte> tile_bytes, const Tile& tile);

// Copies a tile's layers to their place in the band's.
void put(std::vector<Layer>& layers, const Tile& band, const std::vector<Layer>& tile_layers, const Tile& tile);

// Whole rows of a picture.
Pixels rows_of(const Pixels& whole, const Tile& rows);

}  // namespace airlight
