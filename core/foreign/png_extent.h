#pragma once
// Whether a PNG goes on to its end. libpng says on standard error what it finds missing, whoever reads the file.

#include <filesystem>

namespace airlight::foreign {

// Throws std::runtime_error with a reason that continues "FILE: damaged or cut short: " where a chunk that the picture
// needs is cut or has another checksum than its own, or the last is missing. A file that is no PNG passes.
void require_whole_png(const std::filesystem::path& file);

}  // namespace airlight::foreign
