#pragma once
// Whether a TIFF is as long as its directories say. libtiff fills with black what is missing, and says nothing.

#include <filesystem>

namespace airlight::foreign {

// Throws std::runtime_error with a reason that continues "FILE: damaged or cut short: " where pixels of one of the
// pictures in the file would lie beyond its end. A file that is no TIFF passes.
void require_whole_tiff(const std::filesystem::path& file);

}  // namespace airlight::foreign
