#pragma once

#include <cstddef>
#include <vector>

#include "core/measure/raster.h"

namespace airlight::measure {

// The whole PNG file in memory. Throws RunError.
std::vector<std::byte> encode_png(const Raster& raster);

}  // namespace airlight::measure
