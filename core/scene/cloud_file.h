#pragma once
// Liquid water at the points of a grid, as plain text.

#include <filesystem>
#include <string>

#include "core/scene/scene.h"

namespace airlight {

inline constexpr std::size_t kMostCloudCells = std::size_t{1} << 25U;

// Reads a file of one of these forms; "#" begins a comment, commas count as spaces:
//   the numbers of points toward east, north and up; their distances east and north, km; the altitudes of the levels,
//   km, evenly spaced; a line of names; then lines of i j k, from 1 on, water in g/m3 and effective radius in um
//   the same as SHDOM's "2 parameter LWC file": that as a first line, and the levels' temperatures for the names
// Points without a line have no water. Returns the error, with its line; empty: none.
std::string read_cloud_file(const std::filesystem::path& file, CloudFile& cloud);

}  // namespace airlight
