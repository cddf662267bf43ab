#pragma once
// What a picture's header may ask for, judged before a pixel is decoded: the display window is not the data, and may
// say anything.

#include <algorithm>
#include <cstdint>
#include <string>

#include "core/error.h"
#include "core/foreign/foreign_picture.h"

namespace airlight::foreign {

// Throws InputError where the window is far larger than what is stored in it, or is none; then `accept` decides.
inline void require_acceptable(const Picture& picture, std::int64_t stored_columns, std::int64_t stored_rows,
                               const Accept& accept) {
  constexpr std::int64_t kPlenty = std::int64_t{1} << 24;  // pixels: a crop out of 4K is usual
  constexpr std::int64_t kTimes = 16;
  const auto by = [](std::int64_t a, std::int64_t b) { return std::to_string(a) + "x" + std::to_string(b); };
  if (picture.width <= 0 || picture.height <= 0) {
    throw InputError(picture.file + ": holds no pixels");
  }
  const std::int64_t window = std::int64_t{picture.width} * picture.height;
  if (window > std::max(kPlenty, kTimes * stored_columns * stored_rows)) {
    throw InputError(picture.file + ": its display window is " + by(picture.width, picture.height) +
                     " pixels, and only " + by(stored_columns, stored_rows) +
                     " are stored; crop the window to what is there");
  }
  if (accept) {
    accept(picture);
  }
}

}  // namespace airlight::foreign
