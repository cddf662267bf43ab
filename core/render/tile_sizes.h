#pragma once
// How large tiles and bands may be.

#include <cstddef>

#include "core/render/layers.h"
#include "core/stage/stage.h"

namespace airlight {

// Most bytes in a device's buffer for one tile: the most that every device takes (Mesa's software device takes no
// more).
inline constexpr std::size_t kTileBytes = std::size_t{128} << 20;
// Most bytes of one band on the host, and of its rows on the device.
inline constexpr std::size_t kBandBytes = std::size_t{64} << 20;
// Most bytes of a tile's layers on the device.
inline constexpr std::size_t kLayerBytes = std::size_t{32} << 20;

// Bytes of one pixel in the greatest of a tile's buffers on the device, and of a band's on the host.
std::size_t tile_pixel_bytes(const Stage& stage, LayerSet layers);
std::size_t band_pixel_bytes(const Stage& stage, LayerSet layers);

// Size of a default tile: whole rows with about 32 MiB of radiance.
ImageSize usual_tile(const Stage& stage, LayerSet layers);

// Planes of light among a tile's layers on the device.
std::size_t layer_planes(const Stage& stage, LayerSet layers);

}  // namespace airlight
