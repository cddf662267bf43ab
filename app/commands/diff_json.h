#pragma once
// A comparison as one JSON object for --json.

#include <string>
#include <vector>

#include "core/measure/report.h"

namespace airlight::cli {

// Infinite figures (an error against a black reference, the PSNR of equal pictures) are null.
std::string diff_json(const std::vector<measure::NamedReport>& entries, const measure::Limits& in_force,
                      const std::vector<std::string>& files_written,
                      const std::vector<std::string>& references_replaced);

}  // namespace airlight::cli
