#pragma once
// Reads pictures of ours back, for previews and contact sheets.

#include <filesystem>
#include <optional>

#include "core/base/radiance_image.h"
#include "core/output/png.h"

namespace airlight {

struct ExrPicture {
  RadianceImage radiance;
  std::optional<RadianceImage> bloom;  // where the file has the layer
  float exposure = 1.0F;               // as noted when it was rendered
};

// The main picture of a scan-line EXR; alpha is 1 where the file has none. Throws RunError.
ExrPicture read_exr_picture(const std::filesystem::path& file);

// A PNG as 8-bit RGB. Throws RunError.
PixelImage read_png_picture(const std::filesystem::path& file);

}  // namespace airlight
