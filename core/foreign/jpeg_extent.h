#pragma once
// Whether a JPEG goes on to its end. libjpeg fills with grey what is missing, and OpenImageIO hands that on.

#include <filesystem>

namespace airlight::foreign {

// Throws std::runtime_error with a reason that continues "FILE: damaged or cut short: " where the pixels are not
// followed by the marker of the end. A file that is no JPEG passes.
void require_whole_jpeg(const std::filesystem::path& file);

}  // namespace airlight::foreign
