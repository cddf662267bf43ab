#pragma once
// A comparison as one HTML page without further files.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/measure/report.h"

namespace airlight::measure {

// Pixels of each picture on a page of so many pairs: 960x540 for a single pair, at most 1.5 million for all together,
// which make 19 MB of page.
std::size_t page_pixels(std::size_t pairs);

// All pairs, the worst first. `a`, `b`: the names that the user gave to what was compared.
std::string html_page(const std::vector<NamedReport>& entries, std::string_view a, std::string_view b);

// core/measure/page.html, embedded at build time.
std::string_view page_template();

}  // namespace airlight::measure
