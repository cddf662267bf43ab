#pragma once
// --tile, and pictures larger than memory, which are rendered in tiles without it.

#include <optional>
#include <string>

#include "core/render/tile_sizes.h"

namespace airlight::cli {

// Larger pictures are rendered in tiles by default: their radiance exceeds the buffer that every device supports.
inline constexpr std::size_t kMostUntiledPixels = kTileBytes / (4 * sizeof(float));

// `option`: of --tile, "WxH". None: the picture is small and rendered as a whole. Throws InputError for a text that is
// no size, or a size beyond a device's buffers. `command`: "render".
std::optional<ImageSize> tile_for(const std::optional<std::string>& option, const Stage& stage, LayerSet layers,
                                  const std::string& command);

}  // namespace airlight::cli
