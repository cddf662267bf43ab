#pragma once
// What a picture's header may ask for, judged before a pixel is decoded: the display window is not the data, and may
// say anything.

#include <algorithm>
#include <cstdint>
#include <string>

#include "core/base/error.h"
#include "core/foreign/foreign_picture.h"

namespace airlight::foreign {

// Throws InputError where the window is far larger or smaller than what is stored, or is none; then `accept` decides.
inline void require_acceptable(const Picture& picture, std::int64_t stored_columns, std::int64_t stored_rows,
                               const Accept& accept) {
  constexpr double kPlenty = 16777216.0;  // pixels: a crop out of 4K is usual
  constexpr double kTimes = 16.0;
  const auto by = [](std::int64_t a, std::int64_t b) { return std::to_string(a) + "x" + std::to_string(b); };
  if (picture.width <= 0 || picture.height <= 0) {
    throw InputError(picture.file + ": holds no pixels");
  }
  const double window = static_cast<double>(picture.width) * picture.height;
  const double stored = static_cast<double>(stored_columns) * static_cast<double>(stored_rows);
  const std::string sizes = picture.file + ": its display window is " + by(picture.width, picture.height) +
                            " pixels, and " + by(stored_columns, stored_rows) + " are stored; ";
  if (window > std::max(kPlenty, kTimes * stored)) {
    throw InputError(sizes + "crop the window to what is there");
  }
  if (stored > std::max(kPlenty, kTimes * window)) {
    throw InputError(sizes + "crop them to the window");
  }
  if (accept) {
    accept(picture);
  }
}

}  // namespace airlight::foreign
