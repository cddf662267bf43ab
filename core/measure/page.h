#pragma once
// A comparison as one HTML page that needs nothing beside itself.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/measure/report.h"

namespace airlight::measure {

// Pixels of each picture that a page of so many pairs may hold: 960x540 of a single one, and together at most 1.5
// million, which is 19 MB of page.
std::size_t page_pixels(std::size_t pairs);

// Every pair, the worst first. `a`, `b`: what was compared, as the user named it.
std::string html_page(const std::vector<NamedReport>& entries, std::string_view a, std::string_view b);

// core/measure/page.html, embedded at build time.
std::string_view page_template();

}  // namespace airlight::measure
